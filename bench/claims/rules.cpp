#include "bench/claims/rules.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "bench/text_table.h"

namespace sightline::bench {
namespace {

/// That 97.5 % of Student's distribution lie below, by degrees of freedom from 1 on.
constexpr double student[] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};

using Conditions = std::vector<const Condition*>;

Conditions select(std::span<const Condition> all, Condition::Kind kind, bool is_broken) {
  Conditions found;
  for (const Condition& condition : all) {
    const Side side = side_of(condition.figure.value, condition.limit);
    const bool matches = is_broken ? side != Side::unclear && side != condition.side : side == Side::unclear;
    if (condition.kind == kind && matches) found.push_back(&condition);
  }
  return found;
}

std::string value_text(const Figure& figure) {
  const Estimate& value = figure.value;
  const std::string unit = figure.unit.empty() || figure.unit == "x" ? figure.unit : ' ' + figure.unit;
  std::string text = digits_text(value.median) + unit;
  if (value.low < value.high) text += " (" + digits_text(value.low) + " to " + digits_text(value.high) + ')';
  return text;
}

/// "a is 1.2x, not below 1; b is ...", of at most three.
std::string told(const Conditions& conditions, const std::string& verb) {
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, conditions.size()); ++i) {
    const Condition& c = *conditions[i];
    text += (i == 0 ? "" : "; ") + c.figure.name + " is " + value_text(c.figure) + ", " + verb + ' ' +
            (c.side == Side::below ? "below " : "above ") + digits_text(c.limit);
  }
  if (conditions.size() > most) text += "; and " + std::to_string(conditions.size() - most) + " more like that";
  return text + '.';
}

}  // namespace

Side side_of(const Estimate& value, double limit) {
  return value.high < limit ? Side::below : value.low > limit ? Side::above : Side::unclear;
}

Estimate exponent_of(const Growth& growth) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (!growth.fit) return {0, -unknown, unknown, 0};
  const double exponent = growth.fit->exponent;
  if (!growth.fit->standard_error) return {exponent, -unknown, unknown, 0};
  const std::size_t freedom = growth.x.size() - 2;
  const double width = student[std::min(freedom, std::size(student)) - 1] * *growth.fit->standard_error;
  return {exponent, exponent - width, exponent + width, 0.95};
}

Judgement judge(std::span<const Condition> conditions) {
  using enum Condition::Kind;
  if (conditions.empty()) return {Verdict::not_resolved, "Nothing was measured."};
  if (const auto broken = select(conditions, needed, true); !broken.empty()) {
    return {Verdict::fails, told(broken, "not")};
  }
  if (const auto unclear = select(conditions, needed, false); !unclear.empty()) {
    return {Verdict::not_resolved, told(unclear, "which does not tell whether it is")};
  }
  if (const auto broken = select(conditions, wanted, true); !broken.empty()) {
    return {Verdict::with_limit, told(broken, "not")};
  }
  if (const auto unclear = select(conditions, wanted, false); !unclear.empty()) {
    return {Verdict::not_resolved, told(unclear, "which does not tell whether it is")};
  }
  return {Verdict::holds, "Every figure of the rule is on its side of the limit."};
}

void conclude(Finding& finding, std::span<const Condition> conditions, std::string_view limit) {
  auto [verdict, reason] = judge(conditions);
  finding.verdict = verdict;
  finding.reason = verdict == Verdict::with_limit ? std::string(limit) + ": " + reason : reason;
}

std::string digits_text(double value) {
  const double size = std::fabs(value);
  const bool is_whole = value == std::floor(value), is_large = value >= 999.5;
  if (size > 0 && (size < 0x1p-20 || size >= 1e12)) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    return text;
  }
  if (value >= 0 && value < 1e15 && (is_whole || is_large)) return count_text(std::size_t(std::llround(value)));
  return number_text(value);
}

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::with_limit:
      return "holds with a limit";
    case Verdict::fails:
      return "does not hold";
    case Verdict::not_resolved:
      break;
  }
  return "not resolved";
}

}  // namespace sightline::bench
