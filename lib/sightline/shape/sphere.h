#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sightline/math/rounding.h"
#include "sightline/shape/shapes.h"

namespace sightline {

/// Spheres as primitives. A sphere of radius 0 is a point.
///
/// The discriminant is taken from the vector between the center and the point of the line closest to it, which cancels
/// nothing (Haines, Guenther and Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", 2019), and the
/// roots from the sum of like signs (Kahan). A reported point is off the sphere by a few roundings of the distance to
/// the origin.
class SphereSet {
 public:
  using Shape = Sphere;

  class PreparedRay {
   public:
    explicit PreparedRay(const Ray<double>& ray)
        : origin_(ray.origin), direction_(ray.direction), length2_(glm::dot(ray.direction, ray.direction)) {}

    /// Two crossings, equal ones where the line touches.
    template <class Report>
    void for_each_crossing(const Sphere& sphere, Report&& report) const {
      const double radius = sphere.radius;
      const Vec3d to_center = Vec3d(sphere.center) - origin_;
      const double along = glm::dot(to_center, direction_);
      const Vec3d closest = to_center - (along / length2_) * direction_;
      const double discriminant = radius * radius - glm::dot(closest, closest);
      if (!(discriminant >= 0)) return;
      const double half_chord = std::sqrt(length2_ * discriminant);
      const double q = along >= 0 ? along + half_chord : along - half_chord;
      const double outside = glm::dot(to_center, to_center) - radius * radius;
      double t0 = q / length2_, t1 = q == 0 ? 0 : outside / q;
      if (t0 > t1) std::swap(t0, t1);
      report(Crossing{t0, 0, 0});
      report(Crossing{t1, 0, 0});
    }

   private:
    Vec3d origin_, direction_;
    double length2_;
  };

  SphereSet() = default;

  /// \throws std::invalid_argument naming the first sphere whose radius is negative or that leaves the range of float.
  explicit SphereSet(std::vector<Sphere> spheres) : spheres_(std::move(spheres)) {
    for (std::uint32_t id = 0; id < size(); ++id) {
      const Aabb box = bounds(id);
      if (!(spheres_[id].radius >= 0) || !is_finite(box.lo) || !is_finite(box.hi)) {
        throw std::invalid_argument("sphere " + std::to_string(id) +
                                    ": expected a radius that is not negative and finite bounds");
      }
    }
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(spheres_.size()); }
  const Sphere& operator[](std::uint32_t id) const { return spheres_[id]; }

  Aabb bounds(std::uint32_t id) const {
    const auto& [center, radius] = spheres_[id];
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
      box.lo[axis] = round_down(double(center[axis]) - radius);
      box.hi[axis] = round_up(double(center[axis]) + radius);
    }
    return box;
  }

  /// Empty only where the ball's nearest point in the box is out of reach.
  Aabb clip(std::uint32_t id, const Aabb& box) const {
    const auto& [center, radius] = spheres_[id];
    const Vec3d nearest = glm::clamp(Vec3d(center), Vec3d(box.lo), Vec3d(box.hi)) - Vec3d(center);
    const double slack = 1 + 0x1p-40;  // of the squared distance, rounded six times
    if (glm::dot(nearest, nearest) > double(radius) * radius * slack) return {};
    return intersection(bounds(id), box);
  }

  Hull hull(std::uint32_t id) const { return hull_of(bounds(id)); }
  CandidatePlanes planes(std::uint32_t id) const { return faces_of(bounds(id)); }
  PreparedRay prepare(const Ray<double>& ray) const { return PreparedRay(ray); }

 private:
  std::vector<Sphere> spheres_;
};

static_assert(Shapes<SphereSet>);

}  // namespace sightline
