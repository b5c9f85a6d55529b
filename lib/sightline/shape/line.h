#pragma once

#include <array>

#include "sightline/math/ray.h"

namespace sightline {

/// The line of a ray in any type of numbers.
template <class N>
struct Line {
  std::array<N, 3> origin, direction;
};

template <class N>
Line<N> line_of(const Ray<double>& ray) {
  Line<N> line;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    line.origin[axis] = N(ray.origin[static_cast<int>(axis)]);
    line.direction[axis] = N(ray.direction[static_cast<int>(axis)]);
  }
  return line;
}

}  // namespace sightline
