#pragma once
/// Vectors of three in any type of numbers: rounded, bounded or exact.

#include <array>

#include "sightline/math/vec.h"

namespace sightline {

template <class N>
using Triple = std::array<N, 3>;

template <class N>
Triple<N> triple(const Vec3d& v) {
  return {N(v.x), N(v.y), N(v.z)};
}

template <class N>
Triple<N> difference(const Triple<N>& a, const Triple<N>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class N>
N dot(const Triple<N>& a, const Triple<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class N>
Triple<N> cross(const Triple<N>& a, const Triple<N>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace sightline
