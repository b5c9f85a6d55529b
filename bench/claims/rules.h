#pragma once
/// How figures become a verdict. A rule is a list of conditions, each a figure and the limit that it has to keep; the
/// figure's interval decides, and one that straddles its limit decides nothing.

#include <span>
#include <string>
#include <string_view>

#include "bench/claims/claim.h"

namespace sightline::bench {

enum class Side { below, above, unclear };

/// An exact figure that is equal to the limit is on neither side.
Side side_of(const Estimate& value, double limit);

/// The exponent of a fit with the interval that holds the true one with 95 % if what scatters about the line does so
/// normally (Student, "The probable error of a mean", 1908); unbounded without a standard error.
Estimate exponent_of(const Growth& growth);

struct Condition {
  enum class Kind {
    needed,  ///< Without it the claim does not hold.
    wanted,  ///< Without it the claim holds with a limit.
  };
  Kind kind;
  Figure figure;
  Side side;  ///< On which of the limit the figure has to be: below or above.
  double limit;
};

struct Judgement {
  Verdict verdict;
  std::string reason;
};

/// fails where a needed condition is surely broken; else not_resolved where one is unclear; else with_limit where a
/// wanted one is surely broken; else not_resolved where one of these is unclear; else holds. The reason names the
/// conditions that decided. Without conditions nothing is resolved.
Judgement judge(std::span<const Condition> conditions);

/// Puts the verdict of these conditions into a finding. Where it is with_limit, `limit` is said before the reason: what
/// the broken conditions mean, without a full stop.
void conclude(Finding& finding, std::span<const Condition> conditions, std::string_view limit);

/// A number as tables show it: whole ones as they are, thousands apart.
std::string digits_text(double value);

/// "holds", "holds with a limit", "does not hold", "not resolved".
std::string_view name_of(Verdict verdict);

}  // namespace sightline::bench
