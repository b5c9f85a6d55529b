#pragma once
/// Directed rounding and guarded conversions.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace sightline {

/// The next float above x; +infinity and NaN are returned unchanged.
inline float next_up(float x) {
  if (!(x < std::numeric_limits<float>::infinity())) return x;
  if (x == 0) return std::numeric_limits<float>::denorm_min();
  const auto bits = std::bit_cast<std::uint32_t>(x);
  return std::bit_cast<float>(x > 0 ? bits + 1 : bits - 1);
}
inline double next_up(double x) {
  if (!(x < std::numeric_limits<double>::infinity())) return x;
  if (x == 0) return std::numeric_limits<double>::denorm_min();
  const auto bits = std::bit_cast<std::uint64_t>(x);
  return std::bit_cast<double>(x > 0 ? bits + 1 : bits - 1);
}

/// The next float below x; -infinity and NaN are returned unchanged.
template <class T>
T next_down(T x) {
  return -next_up(-x);
}

/// The largest float that is not above x.
inline float round_down(double x) {
  const auto nearest = static_cast<float>(x);
  return nearest > x ? next_down(nearest) : nearest;
}

/// The smallest float that is not below x.
inline float round_up(double x) {
  const auto nearest = static_cast<float>(x);
  return nearest < x ? next_up(nearest) : nearest;
}

/// floor(x) held within [0, count - 1]; NaN gives 0. `count` is at least 1.
template <class T>
int clamp_to_index(T x, int count) {
  const T held = std::min(std::max(T(0), x), static_cast<T>(count - 1));  // no branch to mispredict
  return std::min(static_cast<int>(held), count - 1);
}

}  // namespace sightline
