#pragma once
/// A statement of the course, the experiment that asks whether it is so, and what came of it.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/accuracy/axis.h"
#include "bench/estimate.h"
#include "bench/power_fit.h"

namespace sightline::bench {

/// By the claim's own rule, from figures alone.
enum class Verdict { holds, with_limit, fails, not_resolved };

/// A number that was counted is exact: its estimate has median, low and high alike, and confidence 1.
struct Figure {
  std::string name;
  Estimate value;
  std::string unit;  ///< "x" for ratios; empty for exponents and counts.
};

/// How something grows: y against x, and the power law through it.
struct Growth {
  std::string name, x_unit, y_unit;
  std::vector<double> x, y;
  std::optional<PowerFit> fit;
  std::string chart{};  ///< Those of the same name share one; without a name, those of the same units.
};

struct Finding {
  std::vector<Figure> figures;
  std::vector<Growth> growths;
  Verdict verdict = Verdict::not_resolved;
  std::string reason;  ///< One or two sentences, with the limit where there is one.
};

struct Claim {
  std::string_view name;
  std::string_view statement;   ///< As the course has it.
  std::string_view experiment;  ///< What is measured, on what, against what.
  std::string_view rule;        ///< Which figures make it hold, hold with a limit, or fail; fixed before measuring.
  Finding (*measure)(const Effort& effort);
};

inline Figure exact_figure(std::string name, double value, std::string unit = {}) {
  return {std::move(name), {value, value, value, 1}, std::move(unit)};
}

/// All that there are, in the order of the course.
const std::vector<Claim>& claims();

}  // namespace sightline::bench
