#pragma once
/// Tori, and where lines meet them.

#include <array>

#include "sightline/math/aabb.h"
#include "sightline/math/level.h"
#include "sightline/math/root_list.h"
#include "sightline/shape/line.h"

namespace sightline {

/// The points at distance `minor` >= 0 from a circle of radius `major` >= 0 around the axis, any vector but 0.
/// With minor < major a ring; with minor > major a spindle, whose surface also meets itself on the axis and bounds an
/// inner lemon. The lemon counts as hollow: inside is where the polynomial below is negative.
struct Torus {
  Vec3d center;
  Vec3d axis;
  double major;
  double minor;

  friend bool operator==(const Torus&, const Torus&) = default;
};

namespace detail {

/// Of the line w + t d, w seen from the center:
///   (a.a) (q.q + R^2 - r^2)^2 - 4 R^2 |a x q|^2 with q = w + t d.
template <class N>
std::array<N, 5> torus_polynomial(const Triple<N>& a, const N& major, const N& minor, const Triple<N>& w,
                                  const Triple<N>& d) {
  const Triple<N> u = cross(a, d), v = cross(a, w);
  const N major2 = major * major, scale = major2 + major2 + major2 + major2, size = dot(a, a);
  const N g2 = dot(d, d), wd = dot(w, d), g1 = wd + wd, g0 = dot(w, w) + (major2 - minor * minor);
  const N uv = dot(u, v), mixed = g2 * g0, odd = g1 * g0, steep = g2 * g1;
  return {size * (g0 * g0) - scale * dot(v, v), size * (odd + odd) - scale * (uv + uv),
          size * (g1 * g1 + (mixed + mixed)) - scale * dot(u, u), size * (steep + steep), size * (g2 * g2)};
}

}  // namespace detail

/// Whose roots are the parameters at which the line meets the torus, lowest coefficient first. Negative inside.
template <class N>
std::array<N, 5> polynomial(const Torus& torus, const Line<N>& line) {
  return detail::torus_polynomial(triple<N>(torus.axis), N(torus.major), N(torus.minor),
                                  difference(line.origin, triple<N>(torus.center)), line.direction);
}

/// Rounded outward, otherwise tight; of infinite size where that leaves the range of float.
Aabb bounds_of(const Torus&);

/// Of unit length, away from the inside, at a point on or near the surface. On the axis, where only spindles have
/// points, along it.
Vec3d normal_at(const Torus&, const Vec3d& point);

/// The parameters of the whole line, the ray's range aside, at which it meets the torus. A line that only touches has a
/// root of even multiplicity. At level `exact` the list is always certain and each t the nearest double; at `precise`
/// roots that some 100 bits cannot tell apart are one of their joint multiplicity, and the list is not certain. Rays
/// with infinite or NaN components, or without direction, meet nothing; the torus is finite.
RootList torus_roots(const Torus&, const Ray<double>&, Level);

}  // namespace sightline
