#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "sightline/accel/bounding_volumes.h"
#include "sightline/math/aabb.h"
#include "sightline/math/smallest_cylinder.h"

namespace sightline {

/// A capped cylinder as a bounding volume (Weghorst, Hooper and Greenberg, "Improved Computational Methods for Ray
/// Tracing", 1984). As a rod it fits sticks, as a disc along the normal it fits pieces of surfaces.
/// C1 of SmallestCylinder holds.
struct BoundingCylinder {
  Cylinder cylinder;

  static constexpr std::string_view tree_name = "cylinder-tree";
  static constexpr std::string_view tree_description =
      "capped cylinders along principal axes by surface area, nearer child first (Weghorst and others 1984)";
  static constexpr bool needs_points = true;
  static constexpr float test_cost = 2.5f;

  static BoundingCylinder around(const Aabb& box, std::span<const Vec3f> points);

  /// The least of the three that stand along the axes, up to a constant factor.
  static float half_area_around(float x, float y, float z) {
    const auto along = [](float length, float a, float b) {
      const float diameter = std::sqrt(a * a + b * b);
      return diameter * (diameter + 2 * length);
    };
    return std::min({along(x, y, z), along(y, z, x), along(z, x, y)});
  }

  const Cylinder& region() const { return cylinder; }

  template <class T>
  class Test;
};

/// The ray is taken apart into its part along the axis, cut by the caps, and its part across, cut by the circle.
///
/// Why it is never too short: the center is at most 8 reach from the origin, so the parts are rounded by e < 2^-48
/// reach, and 2 - |axis|^2, which stands for 1 / |axis|^2 = 1 + d with |d| < 2^-22, adds 2^-44 of 8 reach, 2^-41 reach.
/// Along the part of the ray in reach, a wrong part of the direction moves points by as much again, and no more: the
/// circle is met by the line through the points so moved, whose closest point is a projection and amplifies nothing.
/// All of this is below half the pad (D1), and the chord argument is that of BoundingSphere. A part of the direction
/// below 2^-40 is rounding for the most, and moves points in reach by less than 2^-38 reach: it is taken for zero.
template <class T>
class BoundingCylinder::Test {
 public:
  using Time = double;

  explicit Test(const PaddedRay<T>& ray) : ray_(ray) {}

  PairTimes<double> operator()(const BoundingCylinder& first, const BoundingCylinder& second, double far) const {
    return {times_of(first, far), times_of(second, far)};
  }

 private:
  Interval<double> times_of(const BoundingCylinder& volume, double far) const {
    const Vec3d axis(volume.cylinder.axis);
    const Vec3d to_center = Vec3d(volume.cylinder.center) - ray_.origin;
    const double center_along = glm::dot(to_center, axis), direction_along = glm::dot(ray_.direction, axis);
    const double inverse_length2 = 2 - glm::dot(axis, axis);
    const Vec3d center_across = to_center - (center_along * inverse_length2) * axis;
    const Vec3d direction_across = ray_.direction - (direction_along * inverse_length2) * axis;

    const double radius = volume.cylinder.radius + ray_.pad, half_length = volume.cylinder.half_length + ray_.pad;
    double enter = -std::numeric_limits<double>::infinity(), leave = std::numeric_limits<double>::infinity();
    const double across2 = glm::dot(direction_across, direction_across);
    if (across2 > parallel * parallel) {
      const double middle = glm::dot(center_across, direction_across) / across2;
      const Vec3d offset = center_across - middle * direction_across;
      const double rest = radius * radius - glm::dot(offset, offset);
      if (rest < 0) return {};
      const double half_chord = std::sqrt(rest / across2);
      enter = middle - half_chord;
      leave = middle + half_chord;
    } else if (glm::dot(center_across, center_across) > radius * radius) {
      return {};
    }
    if (std::fabs(direction_along) > parallel) {
      const double middle = center_along / direction_along, half = half_length / std::fabs(direction_along);
      enter = std::fmax(enter, middle - half);
      leave = std::fmin(leave, middle + half);
    } else if (std::fabs(center_along) > half_length) {
      return {};
    }
    return ray_.times(enter, leave, far);
  }

  static constexpr double parallel = 0x1p-40;
  DistanceRay<T> ray_;
};

inline BoundingCylinder BoundingCylinder::around(const Aabb& box, std::span<const Vec3f> points) {
  return {SmallestCylinder(box, points).smallest()};
}

static_assert(BoundingVolume<BoundingCylinder>);

}  // namespace sightline
