#pragma once

#include <optional>
#include <span>

namespace sightline::bench {

/// y = factor * x^exponent, the straight line of least squares through (log x, log y).
struct PowerFit {
  double exponent = 0;
  double factor = 0;
  std::optional<double> standard_error;  ///< Of the exponent, from the scatter about the line; needs three points.
};

/// Nothing for fewer than two different x. Both of the same length and positive.
std::optional<PowerFit> fit_power(std::span<const double> x, std::span<const double> y);

}  // namespace sightline::bench
