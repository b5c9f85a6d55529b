#pragma once

#include <cmath>

#include "sightline/math/expansion.h"

namespace sightline {

/// A number of some 106 bits: high + low, not overlapping, high the nearest double.
/// Joldes, Muller and Popescu, "Tight and Rigorous Error Bounds for Basic Building Blocks of Double-Word Arithmetic",
/// 2017, whose bounds (at most 10 u^2 of the result, u = 2^-53) hold as long as nothing over- or underflows.
struct DoubleDouble {
  double high = 0;
  double low = 0;

  DoubleDouble() = default;
  explicit DoubleDouble(double x) : high(x) {}
  DoubleDouble(double h, double l) : high(h), low(l) {}
  explicit DoubleDouble(TwoTerms terms) : high(terms.high), low(terms.low) {}

  DoubleDouble operator-() const { return {-high, -low}; }
};

namespace detail {
/// For |a| >= |b| (Dekker).
inline DoubleDouble quick_sum(double a, double b) {
  const double high = a + b;
  return {high, b - (high - a)};
}
}  // namespace detail

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const auto [high, rest] = two_sum(a.high, b.high);
  const auto [low, tail] = two_sum(a.low, b.low);
  const DoubleDouble sum = detail::quick_sum(high, rest + low);
  return detail::quick_sum(sum.high, tail + sum.low);
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const auto [high, rest] = two_product(a.high, b.high);
  const double cross = std::fma(a.low, b.high, std::fma(a.high, b.low, a.low * b.low));
  return detail::quick_sum(high, rest + cross);
}

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double high = a.high / b.high;
  const DoubleDouble rest = a - b * DoubleDouble(high);
  return detail::quick_sum(high, rest.high / b.high);
}

/// Of numbers that are not negative.
inline DoubleDouble sqrt(const DoubleDouble& a) {
  if (!(a.high > 0)) return DoubleDouble(std::sqrt(a.high));
  const double high = std::sqrt(a.high);
  const double rest = std::fma(-high, high, a.high) + a.low;
  return detail::quick_sum(high, rest / (2 * high));
}

}  // namespace sightline
