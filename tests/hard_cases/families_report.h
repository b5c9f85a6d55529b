#pragma once
/// How often each level, and code as it is often written, is wrong of the questions of a family, by their difficulty.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tests/hard_cases/families/families.h"

namespace sightline::hard {

/// Answers of one level, of all structures and routines together; or of naive code, by its name.
struct FamilyLine {
  struct Count {
    std::uint64_t asked = 0, wrong = 0, exact = 0;

    double wrong_share() const { return asked > 0 ? static_cast<double>(wrong) / static_cast<double>(asked) : 0; }
  };
  std::string name;  ///< A level's, "always" where there are none, or that of naive code.
  bool is_naive = false;
  bool has_promise = false;   ///< Not naive, nor `fast`: nothing wrong is right.
  std::vector<Count> counts;  ///< By difficulty, from the easiest on.

  Count total() const;
};

struct FamilyResult {
  std::string name, help, difficulty, unit;
  int easiest = 0;
  std::uint64_t count = 0;  ///< Of questions at each difficulty, as was asked for.
  std::uint64_t seed = 0;
  std::vector<FamilyLine> lines;      ///< Levels first, from fast to exact.
  std::vector<std::string> failures;  ///< Wrong answers where there is a promise, the first of each row.

  int hardest() const;
  bool keeps_promises() const;
};

/// Asks `count` questions at each difficulty; some families ask more of each kind. `tell` is called with the share
/// done.
template <class Tell>
FamilyResult run_family(const Family& family, std::uint64_t count, std::uint64_t seed, Tell&& tell);
FamilyResult run_family(const Family& family, std::uint64_t count, std::uint64_t seed = 1);

/// A row a difficulty, a column a line: wrong of asked.
std::string text_table(const FamilyResult& result);

nlohmann::json to_json(const FamilyResult& result);

/// An SVG of its own: k to the right, the share that is wrong upwards.
std::string failure_chart_svg(const FamilyResult& result);

// ---- Its pieces

/// Of nothing yet.
FamilyResult begun_result(const Family& family, std::uint64_t count, std::uint64_t seed);
/// Adds what was found at difficulty k; difficulties in their order.
void add_difficulty(FamilyResult& result, int k, const Trial& trial);

template <class Tell>
FamilyResult run_family(const Family& family, std::uint64_t count, std::uint64_t seed, Tell&& tell) {
  FamilyResult result = begun_result(family, count, seed);
  for (int k = family.easiest; k <= family.hardest; ++k) {
    tell(static_cast<double>(k - family.easiest) / (family.hardest - family.easiest + 1));
    Trial trial;
    family.ask(k, count, seed + static_cast<std::uint64_t>(k), trial);
    add_difficulty(result, k, trial);
  }
  return result;
}

}  // namespace sightline::hard
