#pragma once
/// Sides of planes, in rationals.

#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "sightline/shape/triangle.h"

namespace sightline::hard {

/// The normal of a triangle, (b - a) x (c - a), and a.
struct ExactPlane {
  using Rational = boost::multiprecision::cpp_rational;
  using Point = std::array<Rational, 3>;

  static Point minus(const Vec3d& p, const Vec3d& q) {
    return {Rational(p.x) - Rational(q.x), Rational(p.y) - Rational(q.y), Rational(p.z) - Rational(q.z)};
  }
  static int sign(const Rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

  explicit ExactPlane(const Triangle& triangle) : at(triangle.a) {
    const Point u = minus(Vec3d(triangle.b), at), v = minus(Vec3d(triangle.c), at);
    normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }
  /// 1 before the plane, where the normal points to, 0 on it, -1 behind.
  int side_of(const Vec3d& p) const { return along(minus(p, at)); }
  /// Whether a direction goes to that side.
  int side_towards(const Vec3d& direction) const { return along(minus(direction, Vec3d(0))); }

  Vec3d at;
  Point normal;

 private:
  int along(const Point& v) const { return sign(normal[0] * v[0] + normal[1] * v[1] + normal[2] * v[2]); }
};

}  // namespace sightline::hard
