#pragma once
/// A ray with a margin, so that no structure culls what an intersector would report.

#include <limits>
#include <type_traits>

#include "sightline/math/aabb.h"
#include "sightline/math/interval.h"
#include "sightline/math/ray.h"
#include "sightline/math/rounding.h"

namespace sightline {

/// The promise between intersectors and structures that makes all structures agree bit for bit:
///   M1  (intersector) When a primitive is reported at t, some point p of the primitive has |p - ray(t)|, on every
///   axis,
///       within half of margin<T> times reach. `reach` is the largest distance, over the axes, from the origin to the
///       scene's bounds.
///   M2  (structure) A region is skipped only if it holds no point within margin<T> * reach, per axis, of ray(t) for
///   any
///       t in [t_min, far limit]. The other half of the margin pays for the rounding of the skipping test itself.
/// Float: hits of level `fast` are off by up to 26 u of reach, u = 2^-24 (triangle_sieve.h), others by the rounding of
/// t alone; a slab test rounds four times, 5 u. Each may take 32 u. Double: intersectors bound their backward error by
/// 2^-35.
template <class T>
inline constexpr T margin = T(0x1p-18);
template <>
inline constexpr double margin<double> = 0x1p-34;

/// Half the width of the padded ray: the margin, and what underflow may add. `speed` is the direction's largest
/// component. A parameter that underflows is off by up to one denormal step, which a large direction magnifies;
/// computed in double, and for doubles from more than that step, since denormals take processors long.
template <class T>
T pad_of(T reach, T speed) {
  constexpr double step = std::is_same_v<T, float> ? 2 * double(std::numeric_limits<float>::denorm_min()) : 0x1p-900;
  return static_cast<T>(double(margin<T> * reach) + step * double(speed));
}

/// Entering uses an origin moved forward by the margin, leaving one moved backward, which costs nothing per plane.
/// The moved origins are rounded away from the true one, so the margin survives where the origin's own spacing exceeds
/// it.
template <class T>
struct PaddedRay {
  Vec3<T> origin;
  Vec3<T> direction;
  Vec3<T> inverse;       ///< 1 / direction; infinite, with the zero's sign, where that is 0.
  Vec3<T> enter_origin;  ///< Of planes through which the ray enters.
  Vec3<T> leave_origin;  ///< Of planes through which the ray leaves.
  T pad;                 ///< pad_of the ray.
  T t_min;
  T t_max;  ///< Below t_min where the ray is not valid: such a ray meets nothing.
  bool is_negative[3];

  PaddedRay(const Ray<T>& ray, const Aabb& bounds)
      : origin(ray.origin), direction(ray.direction), t_min(ray.t_min), t_max(ray.t_max) {
    if (bounds.is_empty() || !is_valid(ray)) {
      t_min = std::numeric_limits<T>::infinity();
      t_max = -std::numeric_limits<T>::infinity();
    }
    pad = pad_of(reach_of(origin, bounds), max_norm(direction));
    constexpr T rounding = 2 * std::numeric_limits<T>::epsilon();
    for (int axis = 0; axis < 3; ++axis) {
      inverse[axis] = T(1) / direction[axis];
      is_negative[axis] = std::signbit(direction[axis]);
      // A direction too small to invert moves the ray all the same, by an amount that cannot be told: no plane bounds
      // it.
      const bool is_unbounded = (direction[axis] != 0) & (std::fabs(inverse[axis]) > std::numeric_limits<T>::max());
      const T wide = is_unbounded ? std::numeric_limits<T>::infinity() : pad;
      // More than the rounding of this product, of both sums and of the moved origin; where the product underflows,
      // sums are exact.
      const T away = std::copysign(wide + rounding * (std::fabs(origin[axis]) + wide), direction[axis]);
      enter_origin[axis] = origin[axis] + away;
      leave_origin[axis] = origin[axis] - away;
    }
  }

  /// What of the ray concerns one axis.
  struct Axis {
    T enter_origin, leave_origin, inverse;

    T enter(float plane) const { return (plane - enter_origin) * inverse; }
    T leave(float plane) const { return (plane - leave_origin) * inverse; }
  };
  Axis along(int axis) const { return {enter_origin[axis], leave_origin[axis], inverse[axis]}; }

  /// Where the padded ray first touches the half-space that lies behind `plane` along its direction. NaN when the ray
  /// is parallel to the plane and exactly a margin away: comparisons must be written so that NaN keeps the region.
  T enter(int axis, float plane) const { return along(axis).enter(plane); }

  /// Where the padded ray last touches the half-space before `plane`. NaN as for enter.
  T leave(int axis, float plane) const { return along(axis).leave(plane); }

  /// Parameters within [t_min, far] at which the padded ray is in the box (Ize 2013, with NaN-keeping order).
  Interval<T> clip(const Aabb& box, T far) const {
    Interval<T> range{t_min, far};
    for (int axis = 0; axis < 3; ++axis) {
      const T near_plane = enter(axis, is_negative[axis] ? box.hi[axis] : box.lo[axis]);
      const T far_plane = leave(axis, is_negative[axis] ? box.lo[axis] : box.hi[axis]);
      range.lo = near_plane > range.lo ? near_plane : range.lo;
      range.hi = far_plane < range.hi ? far_plane : range.hi;
    }
    return range;
  }
};

}  // namespace sightline
