#pragma once
/// Maps and volumes in rational numbers: what real arithmetic says.

#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "sightline/math/aabb.h"
#include "sightline/math/affine.h"
#include "sightline/math/volumes.h"

namespace sightline::exact {

using Rational = boost::multiprecision::cpp_rational;
using Point = std::array<Rational, 3>;

template <class T>
Point point(const Vec3<T>& v) {
  return {Rational(v.x), Rational(v.y), Rational(v.z)};
}

inline Rational dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point plus(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point times(const Rational& s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Map {
  std::array<std::array<Rational, 4>, 3> rows;

  explicit Map(const Affine& map) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 4; ++k) rows[i][k] = Rational(map.rows[i][k]);
    }
  }
  Map(const Map& outer, const Map& inner) {  // the product
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        rows[i][k] = k == 3 ? outer.rows[i][3] : Rational(0);
        for (std::size_t j = 0; j < 3; ++j) rows[i][k] += outer.rows[i][j] * inner.rows[j][k];
      }
    }
  }
  Point row(std::size_t i) const { return {rows[i][0], rows[i][1], rows[i][2]}; }
  Point image(const Point& p) const {
    return {dot(row(0), p) + rows[0][3], dot(row(1), p) + rows[1][3], dot(row(2), p) + rows[2][3]};
  }
  Rational determinant() const { return dot(row(0), cross(row(1), row(2))); }
};

inline bool holds(const Aabb& box, const Point& p) {
  for (int i = 0; i < 3; ++i) {
    const Rational& x = p[static_cast<std::size_t>(i)];
    if (std::isfinite(box.lo[i]) ? x < Rational(box.lo[i]) : box.lo[i] > 0) return false;
    if (std::isfinite(box.hi[i]) ? x > Rational(box.hi[i]) : box.hi[i] < 0) return false;
  }
  return true;
}

inline bool holds(const Sphere& sphere, const Point& p) {
  if (sphere.radius < 0 || std::isinf(sphere.radius)) return sphere.radius > 0;
  const Point away = minus(p, point(sphere.center));
  return dot(away, away) <= Rational(sphere.radius) * Rational(sphere.radius);
}

/// Along the axis as normalized.
inline bool holds(const Cylinder& cylinder, const Point& p) {
  if (cylinder.radius < 0 || std::isinf(cylinder.radius)) return cylinder.radius > 0;
  const Point away = minus(p, point(cylinder.center)), axis = point(cylinder.axis), across = cross(away, axis);
  const Rational length2 = dot(axis, axis), along = dot(away, axis), r(cylinder.radius), h(cylinder.half_length);
  return along * along <= h * h * length2 && dot(across, across) <= r * r * length2;
}

}  // namespace sightline::exact
