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
#include <cmath>

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

/// What the test needs of a ray, made once a ray.
class TriangleRay {
 public:
  /// `bounds` contain every triangle that will be tested.
  TriangleRay(const Ray<double>& ray, const Aabb& bounds);

  /// True when the line of the ray crosses the triangle. The caller holds t against the ray's range.
  bool intersect(const Triangle& triangle, Crossing& crossing) const {
    const Vec3d a = Vec3d(triangle.a) - origin_, b = Vec3d(triangle.b) - origin_, c = Vec3d(triangle.c) - origin_;
    const Sheared s{shear_x(a), shear_y(a), shear_x(b), shear_y(b), shear_x(c), shear_y(c)};
    const double u = s.cx * s.by - s.cy * s.bx;
    const double v = s.ax * s.cy - s.ay * s.cx;
    const double w = s.bx * s.ay - s.by * s.ax;
    // Most triangles end here: edge functions of both signs, farther from zero than any rounding in these bounds.
    if (std::min({u, v, w}) < -sign_bound_ && std::max({u, v, w}) > sign_bound_) return false;
    return settle(triangle, a, b, c, s, u, v, w, crossing);
  }

  template <class Report>
  void for_each_crossing(const Triangle& triangle, Report&& report) const {
    Crossing crossing;
    if (intersect(triangle, crossing)) report(crossing);
  }

 private:
  struct Sheared {
    double ax, ay, bx, by, cx, cy;
  };

  double shear_x(const Vec3d& p) const { return p[kx_] - shear_x_ * p[kz_]; }
  double shear_y(const Vec3d& p) const { return p[ky_] - shear_y_ * p[kz_]; }

  bool settle(const Triangle&, const Vec3d& a, const Vec3d& b, const Vec3d& c, const Sheared&, double u, double v,
              double w, Crossing&) const;
  bool intersect_exactly(const Triangle&, Crossing&) const;

  Vec3d origin_, direction_;
  int kx_, ky_, kz_;  ///< kz is the axis of the direction's largest component; x and y swap where that is negative.
  double shear_x_, shear_y_, scale_z_;
  double sign_bound_;  ///< Error of an edge function of any triangle in the bounds.
};

}  // namespace sightline
