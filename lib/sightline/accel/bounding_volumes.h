#pragma once
/// What a hierarchy asks of its bounding volumes, and what balls and cylinders share.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>

#include "sightline/accel/padded_ray.h"
#include "sightline/math/volumes.h"

namespace sightline {

/// In what range of parameters a ray is in each of two volumes.
template <class T>
struct PairTimes {
  Interval<T> first, second;
};

/// A volume as a node stores it.
///   B1  around(box, points) contains the convex hull of the points, whose bounds are the box.
///   B2  Test<T>{ray}(first, second, far) are the ranges of parameters within [t_min, far] in which the padded ray may
///       be in the volumes: as large as margin M2 (padded_ray.h) demands or larger, and empty (lo > hi) only if a
///       volume may be skipped. They never hold a NaN. Two at a time, because siblings are tested together.
template <class V>
concept BoundingVolume = std::is_trivially_copyable_v<V> &&
    requires(const V& volume, const Aabb& box, std::span<const Vec3f> points, const PaddedRay<float>& ray,
             const typename V::template Test<float>& test) {
  { V::tree_name } -> std::convertible_to<std::string_view>;
  { V::tree_description } -> std::convertible_to<std::string_view>;
  { V::needs_points } -> std::convertible_to<bool>;  // otherwise `around` is given none
  { V::test_cost } -> std::convertible_to<float>;    // of two, relative to two boxes
  { V::around(box, points) } -> std::same_as<V>;
  { V::half_area_around(1.0f, 1.0f, 1.0f) } -> std::same_as<float>;  // up to a factor: around a box of such an extent
  {volume.region()};                                                 // as cells show it
  typename V::template Test<float>::Time;
  { test(volume, volume, ray.t_max) } -> std::same_as<PairTimes<typename V::template Test<float>::Time>>;
};

/// A padded ray in double, walked in units of distance: round volumes need squares, and those of floats leave the range
/// of float already at 1e20 and 1e-23.
///   D1  `pad` is at least the Euclidean length of the margin; half of it is 2^-34 reach or more, so roundings of
///       2^-40 reach, a thousand times what double needs, cannot use up what margin M2 leaves them.
template <class T>
struct DistanceRay {
  Vec3d origin;
  Vec3d direction;         ///< Of unit length but for rounding.
  double time_per_length;  ///< From distance to the ray's parameter.
  double pad;
  double t_min;

  explicit DistanceRay(const PaddedRay<T>& ray) : origin(ray.origin), direction(ray.direction), t_min(ray.t_min) {
    const double length = std::sqrt(glm::dot(direction, direction));
    direction /= length;
    time_per_length = 1 / length;
    pad = 1.7320509 * double(ray.pad);  // above the square root of 3: from a margin per axis to a distance
  }

  /// Distances along the ray as parameters within [t_min, far]; NaN distances bound nothing.
  Interval<double> times(double enter, double leave, double far) const {
    const double t_enter = enter * time_per_length, t_leave = leave * time_per_length;
    return {t_enter > t_min ? t_enter : t_min, t_leave < far ? t_leave : far};
  }
};

}  // namespace sightline
