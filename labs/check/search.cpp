/// Looks for a case in which a check fails, and for the simplest one: RapidCheck draws and shrinks.

#include <rapidcheck.h>
#include <rapidcheck/detail/TestListenerAdapter.h>

#include <chrono>

#include "labs/check/check.h"

namespace sightline::labs {
namespace {

/// A student waits for no more shrinking than this: programs that hang take long to be asked.
constexpr std::chrono::seconds longest_shrinking{8};

/// Whole numbers of [-range, range]; 0 is the simplest, then 1, -1, 2, ...
rc::Gen<int> number(int range) {
  const auto places = rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 2 * range + 1));
  return rc::gen::map(places, [](int i) { return i % 2 != 0 ? (i + 1) / 2 : -(i / 2); });
}

rc::Gen<std::vector<int>> numbers(int count, int range) {
  return rc::gen::container<std::vector<int>>(static_cast<std::size_t>(count), number(range));
}

Case drawn(const Recipe& recipe) {
  Case at;
  if (recipe.head > 0) at.head = *numbers(recipe.head, recipe.range);
  if (recipe.item > 0) {
    const auto items = rc::gen::container<std::vector<std::vector<int>>>(numbers(recipe.item, recipe.range));
    at.items = *rc::gen::resize(recipe.most_items, items);  // of any number up to that
  }
  return at;
}

std::optional<Trouble> trouble_of(const Check& check, Subject& subject, const Case& at) {
  try {
    return check.ask(at, subject);
  } catch (const SubjectTrouble& error) {
    if (error.kind() == SubjectTrouble::Kind::hole) throw;
    return Trouble{"an answer", error.what()};
  }
}

}  // namespace

Outcome run_case(const Check& check, Subject& subject, const Case& at) {
  Outcome outcome{Outcome::State::passed, &check, 1, at, {}, {}};
  try {
    if (const auto trouble = trouble_of(check, subject, at)) {
      outcome.state = Outcome::State::failed;
      outcome.trouble = *trouble;
    }
  } catch (const SubjectTrouble& hole) {
    outcome.state = Outcome::State::hole;
    outcome.trouble = {"an answer", hole.what()};
  }
  outcome.printed = subject.printed();
  return outcome;
}

Outcome run(const Check& check, Subject& subject, std::uint64_t seed) {
  if (check.recipe.head == 0 && check.recipe.item == 0) return run_case(check, subject, {});
  Outcome outcome{Outcome::State::passed, &check, 0, {}, {}, {}};
  std::chrono::steady_clock::time_point end;  // of shrinking
  const auto property = [&] {
    if (outcome.state == Outcome::State::hole) return true;  // nothing else will come out
    if (outcome.state == Outcome::State::failed && std::chrono::steady_clock::now() > end) return true;
    const Case at = drawn(check.recipe);
    if (outcome.state == Outcome::State::passed) ++outcome.cases;
    const Outcome here = run_case(check, subject, at);
    if (here.state == Outcome::State::passed) return true;
    if (outcome.state == Outcome::State::passed) end = std::chrono::steady_clock::now() + longest_shrinking;
    const int cases = outcome.cases;
    outcome = here;  // the last to fail while shrinking is the simplest
    outcome.cases = cases;
    return here.state == Outcome::State::hole;
  };
  rc::detail::TestParams parameters;
  parameters.seed = seed;
  parameters.maxSuccess = check.count;
  rc::detail::TestListenerAdapter silent;
  // With the map of cases to reproduce given, none is looked for in the environment.
  rc::detail::checkTestable(property, rc::detail::TestMetadata{}, parameters, silent,
                            std::unordered_map<std::string, rc::detail::Reproduce>());
  return outcome;
}

std::optional<Drawing> draw(const Check& check, Subject& subject, const Case& at) {
  if (!check.draw) return std::nullopt;
  try {
    return check.draw(at, subject);
  } catch (const SubjectTrouble&) {
    return std::nullopt;
  }
}

}  // namespace sightline::labs
