#pragma once

#include "sightline/math/aabb.h"
#include "sightline/math/ray.h"
#include "sightline/math/volumes.h"

namespace sightline {

/// A ray made ready to be held against volumes. Each answer is false only where no point of the volume lies on the ray
/// within [t_min, t_max] in real arithmetic; a ray that passes by at 2^-40 of the distance may be taken to meet one.
/// What is nothing is not met, what has no bounds is. A ray that is not valid meets nothing.
class VolumeRay {
 public:
  template <class T>
  explicit VolumeRay(const Ray<T>& ray) : VolumeRay(to_double(ray)) {}
  explicit VolumeRay(const Ray<double>& ray);

  bool may_meet(const Aabb& box) const;
  bool may_meet(const Sphere& sphere) const;
  bool may_meet(const Cylinder& cylinder) const;

 private:
  Vec3d origin_, direction_;
  Vec3d way_;        ///< The direction, by its largest component: 1 to sqrt(3) long.
  double way2_ = 1;  ///< Its square.
  double t_min_, t_max_;
  double from_, to_;  ///< The range in units of `way_`.
  bool is_valid_;
};

}  // namespace sightline
