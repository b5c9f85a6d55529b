#pragma once

#include <limits>
#include <optional>

#include "sightline/accel/padded_ray.h"
#include "sightline/csg/face_roots.h"

namespace sightline {

/// A ray made ready for all solids within some bounds. Refers to both. Not to be shared by threads.
template <Level level>
class SolidRay {
 public:
  using Real = typename QuickRay<level>::Real;

  SolidRay(const Ray<double>& ray, const Aabb& extent) : quick_(ray), extent_(&extent) {}

  const Ray<double>& ray() const { return quick_.ray(); }
  /// Made when it is needed first: many solids are answered without.
  const PaddedRay<Real>& padded() const {
    if (!padded_) padded_.emplace(to_real(ray()), *extent_);
    return *padded_;
  }
  const QuickRay<level>& quick() const { return quick_; }
  bool is_valid() const { return quick_.is_valid(); }

 private:
  static Ray<Real> to_real(const Ray<double>& ray) {
    return {Vec3<Real>(ray.origin), Vec3<Real>(ray.direction), -std::numeric_limits<Real>::infinity()};
  }

  QuickRay<level> quick_;
  const Aabb* extent_;
  mutable std::optional<PaddedRay<Real>> padded_;
};

}  // namespace sightline
