#pragma once
/// Boxes as a first lesson has them: three slabs, and a reciprocal of the direction.

#include <algorithm>
#include <limits>
#include <optional>

#include "sightline/math/aabb.h"
#include "sightline/math/ray.h"

namespace sightline::hard {

template <class T>
struct NaiveSlabs {
  T enter = -std::numeric_limits<T>::infinity(), leave = std::numeric_limits<T>::infinity();

  bool is_hit() const { return enter <= leave && leave >= 0; }
  std::optional<double> first() const {
    if (!is_hit()) return std::nullopt;
    return enter >= 0 ? enter : leave;
  }
};

/// By (plane - o) / d as a product.
template <class T>
NaiveSlabs<T> naive_slabs(const Aabb& box, const Ray<T>& ray) {
  NaiveSlabs<T> slabs;
  for (int axis = 0; axis < 3; ++axis) {
    const T inverse = 1 / ray.direction[axis];
    const T a = (box.lo[axis] - ray.origin[axis]) * inverse, b = (box.hi[axis] - ray.origin[axis]) * inverse;
    slabs.enter = std::max(slabs.enter, std::min(a, b));
    slabs.leave = std::min(slabs.leave, std::max(a, b));
  }
  return slabs;
}

}  // namespace sightline::hard
