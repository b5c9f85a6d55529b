#pragma once

#include <array>

#include "sightline/accel/bounding_volumes.h"
#include "sightline/math/aabb.h"

namespace sightline {

/// An axis-aligned box as a bounding volume: six planes, met as slabs (Kay and Kajiya, "Ray Tracing Complex Scenes",
/// 1986).
struct BoundingBox {
  std::array<float, 6> planes;  ///< The low ones of x, y, z, then the high ones, so that a ray picks by index.

  static constexpr std::string_view tree_name = "box-tree";
  static constexpr std::string_view tree_description =
      "bounding boxes by surface area, nearer child first (Wald 2007; Kay and Kajiya 1986)";
  static constexpr bool needs_points = false;
  static constexpr float test_cost = 1;

  static BoundingBox around(const Aabb& box, std::span<const Vec3f>) {
    return {{box.lo.x, box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z}};
  }
  static float half_area_around(float x, float y, float z) { return x * y + y * z + z * x; }
  Aabb region() const { return {{planes[0], planes[1], planes[2]}, {planes[3], planes[4], planes[5]}}; }

  /// PaddedRay::clip, with all that depends on the direction's signs decided once a ray.
  template <class T>
  class Test {
   public:
    using Time = T;

    explicit Test(const PaddedRay<T>& ray)
        : inverse_(ray.inverse), enter_(ray.enter_origin), leave_(ray.leave_origin), t_min_(ray.t_min) {
      for (int axis = 0; axis < 3; ++axis) {
        near_[axis] = ray.is_negative[axis] ? axis + 3 : axis;
        far_[axis] = ray.is_negative[axis] ? axis : axis + 3;
      }
    }

    /// Inlined by force: compilers find it too large to copy, but the call costs as much as the test.
    [[gnu::always_inline]] PairTimes<T> operator()(const BoundingBox& first, const BoundingBox& second, T far) const {
      return {times_of(first, far), times_of(second, far)};
    }

   private:
    [[gnu::always_inline]] Interval<T> times_of(const BoundingBox& box, T far) const {
      Interval<T> range{t_min_, far};
      for (int axis = 0; axis < 3; ++axis) {
        const T near_plane = (box.planes[near_[axis]] - enter_[axis]) * inverse_[axis];
        const T far_plane = (box.planes[far_[axis]] - leave_[axis]) * inverse_[axis];
        range.lo = near_plane > range.lo ? near_plane : range.lo;  // a NaN bounds nothing
        range.hi = far_plane < range.hi ? far_plane : range.hi;
      }
      return range;
    }

    Vec3<T> inverse_, enter_, leave_;
    std::array<std::size_t, 3> near_, far_;
    T t_min_;
  };
};

static_assert(BoundingVolume<BoundingBox>);

}  // namespace sightline
