#pragma once
/// Triangles and the watertight ray-triangle test.
///
/// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013: the triangle is moved and sheared so that the
/// ray becomes the z axis; the signs of three edge functions decide. Here their signs are exact: evaluated in double,
/// and where the error bound does not settle one, as expansions. So neighbours agree about their shared edge, a ray
/// that meets an edge or a corner hits every triangle there, and a triangle seen exactly edge-on, or without area, is
/// missed.
///   T1  A decision is the one real arithmetic would make.
///   T2  A reported t is off by so little that margin M1 (padded_ray.h) holds: where the edge functions are too small a
///       share of the projected size for that, t comes from expansions as well.
///   T3  The sign of t is the true one, so a ray that starts on a triangle does not find it again.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "sightline/math/aabb.h"
#include "sightline/math/hull.h"
#include "sightline/math/ray.h"
#include "sightline/shape/shapes.h"

namespace sightline {

struct Triangle {
  Vec3f a, b, c;
};

inline Aabb bounds_of(const Triangle& triangle) {
  Aabb box;
  box.extend(triangle.a);
  box.extend(triangle.b);
  box.extend(triangle.c);
  return box;
}

/// Bounds of the part of the triangle within `box`, rounded outward; empty where they are apart.
/// Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974.
Aabb clip(const Triangle&, const Aabb& box);

Hull hull_of(const Triangle&);

/// The triangle's plane and the three planes through its edges at right angles to it; the faces of its bounds when it
/// has no area.
CandidatePlanes planes_of(const Triangle&);

/// By the axis that comes last; all are rotations, which keep the sign of a triple product.
inline constexpr std::array<std::array<int, 4>, 3> axis_orders{{{1, 2, 0, 3}, {2, 0, 1, 3}, {0, 1, 2, 3}}};

/// What the test needs of a ray, made once a ray. Everything in it has the axis of the direction's largest component as
/// its last: triangles are put in that order when they are read, so that no test has to look an axis up.
class TriangleRay {
 public:
  /// `bounds` contain every triangle that will be tested.
  TriangleRay(const Ray<double>& ray, const Aabb& bounds)
      : TriangleRay(ray, largest_axis(glm::abs(ray.direction)), reach_of(ray.origin, bounds)) {}

  /// The same where it is known already along which axis the direction is largest. `reach` is not less than the largest
  /// distance over the axes from the origin to any vertex, and not much more.
  template <class T>
  TriangleRay(const Ray<T>& ray, int last_axis, double reach);

  /// True when the line of the ray crosses the triangle. The caller holds t against the ray's range.
  bool intersect(const Triangle& triangle, Crossing& crossing) const {
    return intersect_ordered({in_order(triangle.a), in_order(triangle.b), in_order(triangle.c)}, true, crossing);
  }

  /// The same of a triangle with its coordinates in the order of axes(). Crossings with t < 0 may be left out unless
  /// `takes_behind`: most rays that leave a surface meet their own triangle there.
  [[gnu::always_inline]] bool intersect_ordered(const Triangle& ordered, bool takes_behind, Crossing& crossing) const {
    const Vec3d a = Vec3d(ordered.a) - origin_, b = Vec3d(ordered.b) - origin_, c = Vec3d(ordered.c) - origin_;
    const Vec3d& d = direction_;
    // Sheared, and scaled by d.z: a division less before the first decision.
    const double ax = a.x * d.z - d.x * a.z, bx = b.x * d.z - d.x * b.z, cx = c.x * d.z - d.x * c.z;
    const double ay = a.y * d.z - d.y * a.z, by = b.y * d.z - d.y * b.z, cy = c.y * d.z - d.y * c.z;
    const double u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    // Most triangles end here: edge functions of both signs, farther from zero than any rounding in these bounds.
    const double lowest = std::min({u, v, w}), highest = std::max({u, v, w});
    if (lowest < -sign_bound_ && highest > sign_bound_) return false;

    const double size = std::max(max_norm(Vec3d(ax, bx, cx)), max_norm(Vec3d(ay, by, cy)));
    const double bound = edge_share_ * size;
    if (lowest < -bound && highest > bound) return false;
    const double sum = u + v + w, share = std::fabs(sum);
    const bool is_settled = (lowest > bound || highest < -bound) && share > least_weight * size * size;
    if (!is_settled) [[unlikely]]
      return intersect_exactly(ordered, crossing);
    // T3: three edge functions are off by 3 bound, and weights of one sign round the mean by 4 u of reach.
    const double height = u * a.z + v * b.z + w * c.z, along = sum * d.z;
    if (std::fabs(height) <= reach_ * (4 * bound + 8 * unit_roundoff * share)) [[unlikely]] {
      crossing.u = v / sum, crossing.v = w / sum;
      return settle_next_to(ordered, a, sum, bound, crossing);
    }
    if ((height < 0) != (along < 0) && !takes_behind) return false;
    crossing = {height / along, v / sum, w / sum};
    return true;
  }

  template <class Report>
  void for_each_crossing(const Triangle& triangle, Report&& report) const {
    Crossing crossing;
    if (intersect(triangle, crossing)) report(crossing);
  }

  /// t of the crossing with a triangle that the line crosses, rounded to the nearest double.
  double nearest_t(const Triangle& triangle) const;

  const std::array<int, 4>& axes() const { return axis_orders[last_axis_]; }

 private:
  static constexpr double unit_roundoff = 0x1p-53;

  /// With m no less than the largest |vertex - origin| and M the largest sheared coordinate, in units of d.z: a sheared
  /// coordinate is off by at most 6 u m (two rounded differences, which are at most m, two products, their difference),
  /// so an edge function, two products of such coordinates, by 4 * 6 u m M plus 8 u m M for its own roundings. 32 in
  /// all; the rest is for terms in u^2.
  static constexpr double edge_error = 40 * unit_roundoff;

  /// The weighted mean of the vertices strays from the ray by 3 edge_error m M * M / |u + v + w|. It must stay below
  /// the 2^-35 m that margin M1 grants to double rays, so the sum must exceed this share of M^2.
  static constexpr double least_weight = 3 * edge_error * 0x1p+35;

  template <class T>
  Vec3<T> in_order(const Vec3<T>& v) const {
    const std::array<T, 3> all{v.x, v.y, v.z};
    const std::array<int, 4>& order = axes();
    return {all[order[0]], all[order[1]], all[order[2]]};
  }

  bool settle_next_to(const Triangle& ordered, const Vec3d& a, double sum, double bound, Crossing&) const;
  bool intersect_exactly(const Triangle& ordered, Crossing&) const;

  int last_axis_;
  Vec3d origin_, direction_;
  double reach_;       ///< m of all triangles.
  double edge_share_;  ///< Error of an edge function over M; infinite where products might leave the range of double.
  double sign_bound_;  ///< Error of an edge function of any triangle in the bounds.
};

template <class T>
inline TriangleRay::TriangleRay(const Ray<T>& ray, int last_axis, double reach)
    : last_axis_(last_axis), origin_(in_order(ray.origin)), direction_(in_order(ray.direction)), reach_(reach) {
  const double along = std::fabs(direction_.z);
  const bool is_moderate = std::is_same_v<T, float> || (along >= 0x1p-150 && along <= 0x1p+150);
  edge_share_ = is_moderate ? edge_error * reach * along : std::numeric_limits<double>::infinity();
  sign_bound_ = 2 * edge_share_ * reach * along;  // M <= 2 m, as slopes are at most 1
}

}  // namespace sightline
