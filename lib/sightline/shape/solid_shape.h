#pragma once
/// Closed solids with curved or flat faces, each face the zeros of a polynomial that is negative inside.
///
///   F1  A point is in the solid where the polynomials of all faces are <= 0.
///   F2  Coefficients are sums and products of the solid's own numbers and the line's, written once for every type of
///       numbers: with float and double they are rounded, with balls bounded, with Dyadic exact.
///   F3  Planes across a coordinate axis are one number, so that faces of different solids in one plane are the same
///       polynomial.

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <variant>

#include "sightline/math/aabb.h"
#include "sightline/shape/facet.h"
#include "sightline/shape/line.h"
#include "sightline/shape/torus.h"

namespace sightline::solid {

using sightline::Torus;

/// normal . x <= offset.
struct HalfSpace {
  Vec3d normal{0, 0, 1};
  double offset = 0;

  friend bool operator==(const HalfSpace&, const HalfSpace&) = default;
};

struct Sphere {
  Vec3d center{0};
  double radius = 1;

  friend bool operator==(const Sphere&, const Sphere&) = default;
};

struct Box {
  Vec3d lo{-1};
  Vec3d hi{1};

  friend bool operator==(const Box&, const Box&) = default;
};

/// With flat caps through the centers `base` and `top`, across the axis between them.
struct Cylinder {
  Vec3d base{0, 0, -1};
  Vec3d top{0, 0, 1};
  double radius = 1;

  friend bool operator==(const Cylinder&, const Cylinder&) = default;
};

/// One nappe, from the apex to a flat cap of this radius around `base`.
struct Cone {
  Vec3d apex{0, 0, 1};
  Vec3d base{0, 0, 0};
  double radius = 1;

  friend bool operator==(const Cone&, const Cone&) = default;
};

/// a x^2 + b y^2 + c z^2 + d x y + e x z + f y z + g x + h y + i z + j <= 0, in this order.
struct Quadric {
  std::array<double, 10> coefficients{1, 1, 1, 0, 0, 0, 0, 0, 0, -1};

  friend bool operator==(const Quadric&, const Quadric&) = default;
};

// ---- Polynomials along a line

/// slope t + level.
template <class N>
struct LinearForm {
  N slope, level;
};

/// a t^2 + 2 b t + c.
template <class N>
struct QuadraticForm {
  N a, b, c;
};

/// By powers of t, the constant first.
template <class N>
struct QuarticForm {
  std::array<N, 5> coefficients;
};

/// The axis that a vector runs along, or -1.
inline int axis_along(const Vec3d& v) {
  const int count = (v.x != 0) + (v.y != 0) + (v.z != 0);
  return count != 1 ? -1 : v.x != 0 ? 0 : v.y != 0 ? 1 : 2;
}

/// A plane across a coordinate axis (F3): below it, or above it, is inside.
struct AxisPlane {
  int axis;
  double position;
  bool is_upper;  ///< Inside is below.

  friend bool operator==(const AxisPlane&, const AxisPlane&) = default;
};

inline AxisPlane face_of(const Box& box, std::uint32_t face) {
  const auto axis = static_cast<int>(face / 2);
  return face % 2 == 0 ? AxisPlane{axis, box.lo[axis], false} : AxisPlane{axis, box.hi[axis], true};
}

template <class N>
LinearForm<N> form_of(const AxisPlane& plane, const Line<N>& line) {
  const auto axis = static_cast<std::size_t>(plane.axis);
  if (plane.is_upper) return {line.direction[axis], line.origin[axis] - N(plane.position)};
  return {-line.direction[axis], N(plane.position) - line.origin[axis]};
}

/// A flat end: the plane through `to` across the way that leads there.
struct Cap {
  Vec3d from, to;

  friend bool operator==(const Cap&, const Cap&) = default;
};

inline Cap cap_of(const Cylinder& cylinder, bool is_top) {
  return is_top ? Cap{cylinder.base, cylinder.top} : Cap{cylinder.top, cylinder.base};
}
inline Cap cap_of(const Cone& cone, bool is_base) {
  return is_base ? Cap{cone.apex, cone.base} : Cap{cone.base, cone.apex};
}

template <class N>
LinearForm<N> form_of(const Cap& cap, const Line<N>& line) {
  const Triple<N> to = triple<N>(cap.to), normal = difference(to, triple<N>(cap.from));
  return {dot(normal, line.direction), dot(normal, difference(line.origin, to))};
}

template <class N>
LinearForm<N> form_of(const HalfSpace& half, const Line<N>& line) {
  const Triple<N> normal = triple<N>(half.normal);
  return {dot(normal, line.direction), dot(normal, line.origin) - N(half.offset)};
}

template <class N>
LinearForm<N> form_of(const Facet& facet, const Line<N>& line) {
  const Triple<N> a = triple<N>(facet.vertices[0]);
  const Triple<N> normal =
      cross(difference(triple<N>(facet.vertices[1]), a), difference(triple<N>(facet.vertices[2]), a));
  return {dot(normal, line.direction), dot(normal, difference(line.origin, a))};
}

template <class N>
QuadraticForm<N> form_of(const Sphere& sphere, const Line<N>& line) {
  const Triple<N> q = difference(line.origin, triple<N>(sphere.center));
  const N radius(sphere.radius);
  return {dot(line.direction, line.direction), dot(q, line.direction), dot(q, q) - radius * radius};
}

/// |a|^2 |q|^2 - (q.a)^2 - r^2 |a|^2: the infinite cylinder around the axis.
template <class N>
QuadraticForm<N> form_of(const Cylinder& cylinder, const Line<N>& line) {
  const Triple<N> base = triple<N>(cylinder.base), axis = difference(triple<N>(cylinder.top), base);
  const Triple<N> q = difference(line.origin, base);
  // Of perpendicular parts, in cross products, which cancel less than the difference of squares does.
  const Triple<N> across = cross(line.direction, axis), away = cross(q, axis);
  const N radius(cylinder.radius);
  return {dot(across, across), dot(across, away), dot(away, away) - radius * radius * dot(axis, axis)};
}

/// |a|^4 |q|^2 - (|a|^2 + r^2) (q.a)^2 over |a|^2 in cross products: |a|^2 |q x a|^2 - r^2 (q.a)^2, both nappes.
template <class N>
QuadraticForm<N> form_of(const Cone& cone, const Line<N>& line) {
  const Triple<N> apex = triple<N>(cone.apex), axis = difference(triple<N>(cone.base), apex);
  const Triple<N> q = difference(line.origin, apex);
  const Triple<N> across = cross(line.direction, axis), away = cross(q, axis);
  const N length2 = dot(axis, axis), radius(cone.radius), radius2 = radius * radius;
  const N rise = dot(line.direction, axis), height = dot(q, axis);
  return {length2 * dot(across, across) - radius2 * (rise * rise),
          length2 * dot(across, away) - radius2 * (rise * height),
          length2 * dot(away, away) - radius2 * (height * height)};
}

template <class N>
QuadraticForm<N> form_of(const Quadric& quadric, const Line<N>& line) {
  const auto k = [&](std::size_t i) { return N(quadric.coefficients[i]); };
  const Triple<N>&o = line.origin, &d = line.direction;
  // 2 F v for the quadratic part F, as a row.
  const auto twice = [&](const Triple<N>& v) {
    return Triple<N>{N(2) * k(0) * v[0] + k(3) * v[1] + k(4) * v[2], k(3) * v[0] + N(2) * k(1) * v[1] + k(5) * v[2],
                     k(4) * v[0] + k(5) * v[1] + N(2) * k(2) * v[2]};
  };
  const Triple<N> linear{k(6), k(7), k(8)};
  const N half(0.5);
  const Triple<N> twice_d = twice(d);
  return {half * dot(twice_d, d), half * (dot(twice_d, o) + dot(linear, d)),
          half * dot(twice(o), o) + dot(linear, o) + k(9)};
}

template <class N>
QuarticForm<N> form_of(const Torus& torus, const Line<N>& line) {
  return {polynomial(torus, line)};
}

}  // namespace sightline::solid
