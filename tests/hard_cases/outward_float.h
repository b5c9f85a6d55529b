#pragma once
/// Intervals of float, rounded outward by a step after each operation: what a program needs that is proud of its
/// bounds.

#include <algorithm>
#include <cmath>
#include <limits>

namespace sightline::hard {

struct OutwardFloat {
  float lo, hi;

  static OutwardFloat around(float lo, float hi) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return {std::nextafter(lo, -infinity), std::nextafter(hi, infinity)};
  }
  friend OutwardFloat operator+(OutwardFloat a, OutwardFloat b) { return around(a.lo + b.lo, a.hi + b.hi); }
  friend OutwardFloat operator-(OutwardFloat a, OutwardFloat b) { return around(a.lo - b.hi, a.hi - b.lo); }
  friend OutwardFloat operator*(OutwardFloat a, OutwardFloat b) {
    const auto [lo, hi] = std::minmax({a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi});
    return around(lo, hi);
  }
  /// By one that is above 0.
  friend OutwardFloat operator/(OutwardFloat a, OutwardFloat b) {
    const auto [lo, hi] = std::minmax({a.lo / b.lo, a.lo / b.hi, a.hi / b.lo, a.hi / b.hi});
    return around(lo, hi);
  }
};

inline OutwardFloat root_of(OutwardFloat x) {
  return OutwardFloat::around(std::sqrt(std::max(0.0f, x.lo)), std::sqrt(x.hi));
}

}  // namespace sightline::hard
