#pragma once
/// Frames around normals: what a normal map's x, y and z mean on a surface.

#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "sightline/math/expansion.h"
#include "sightline/math/vec.h"

namespace sightline {

/// v / |v|, without over- or underflow. False, and v as it was, where it has no direction: all zero or not finite.
inline bool normalize_safely(Vec3d& v) {
  const double size = max_norm(v);
  if (!(size > 0) || !is_finite(v)) return false;
  int exponent;
  std::frexp(size, &exponent);
  const Vec3d scaled(std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent));
  v = scaled / std::sqrt(glm::dot(scaled, scaled));
  return true;
}

/// Orthonormal. Mirrored, where tangent, bitangent and normal are a left hand's.
struct TangentFrame {
  Vec3d tangent, bitangent, normal;

  Vec3d to_world(const Vec3d& local) const { return local.x * tangent + local.y * bitangent + local.z * normal; }
  Vec3d to_local(const Vec3d& world) const {
    return {glm::dot(world, tangent), glm::dot(world, bitangent), glm::dot(world, normal)};
  }
  bool is_mirrored() const { return glm::dot(glm::cross(tangent, bitangent), normal) < 0; }
};

/// Any frame around a unit normal; the normal's own roundings are those of the frame. No normal is special: with the
/// sign of z, -0 included, the denominator is at least 1.
/// Duff, Burgess, Christensen, Hery, Kensler, Liani and Villemin, "Building an Orthonormal Basis, Revisited", 2017.
inline TangentFrame frame_around(const Vec3d& n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

/// The frame around a unit normal n whose tangent is what is left of `du` at right angles to n, and whose bitangent is
/// on the side of `dv`: so a mirrored image gives a mirrored frame. Where du has no such part, the bitangent comes from
/// dv; where neither has, or dv lies on neither side, the frame is a right hand's.
inline TangentFrame frame_along(const Vec3d& n, const Vec3d& du, const Vec3d& dv) {
  const auto within_plane = [&](Vec3d v) {
    if (!normalize_safely(v)) return Vec3d(0);
    v -= glm::dot(n, v) * n;
    const double once = max_norm(v);
    // Twice is enough: once may leave as much along n as there was rounding in a v that is nearly n. Where little is
    // left then, all of it was rounding. Kahan, in Parlett, "The Symmetric Eigenvalue Problem", 1980.
    v -= glm::dot(n, v) * n;
    return max_norm(v) > once / 2 && normalize_safely(v) ? v : Vec3d(0);
  };
  Vec3d tangent = within_plane(du);
  if (tangent == Vec3d(0)) {
    tangent = glm::cross(within_plane(dv), n);
    if (tangent == Vec3d(0)) return frame_around(n);
  }
  const Vec3d bitangent = glm::cross(n, tangent);
  return {tangent, glm::dot(bitangent, dv) < 0 ? -bitangent : bitangent, n};
}

/// The sign of the area that a triangle has in the image: -1 where the image is mirrored on it, 0 where the three
/// points are on a line. Exact.
inline int uv_orientation(const std::array<glm::dvec2, 3>& uv) {
  const auto side = [&](int i, int axis) {
    return exact_difference(uv[static_cast<std::size_t>(i)][axis], uv[0][axis]);
  };
  return (side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0)).sign();
}

/// A triangle's frame around a unit normal, which may be interpolated. u grows along the tangent, v to the side of the
/// bitangent: with mirrored (u, v) the frame is mirrored.
///   F1  The sign of the area in the image decides, exactly, and nothing is divided by the area: however thin it is,
///   the
///       direction of u is that of real arithmetic up to the roundings of a few products.
///   F2  Where (u, v) has no area, or is not finite, it has no direction either: any frame around the normal.
/// Lengyel, "Mathematics for 3D Game Programming and Computer Graphics", 2001; Mikkelsen, "Simulation of Wrinkled
/// Surfaces Revisited", 2008.
inline TangentFrame triangle_frame(const Vec3d& n, const std::array<Vec3d, 3>& corners,
                                   const std::array<glm::dvec2, 3>& uv) {
  for (const glm::dvec2& at : uv) {
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) return frame_around(n);
  }
  const int orientation = uv_orientation(uv);
  if (orientation == 0) return frame_around(n);  // F2
  const Vec3d first = corners[1] - corners[0], second = corners[2] - corners[0];
  const glm::dvec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
  const double sign = orientation;  // F1
  return frame_along(n, sign * (b.y * first - a.y * second), sign * (a.x * second - b.x * first));
}

/// The unit normal of a surface that `linear` has moved: by the inverse transpose, as the cofactors with the
/// determinant's sign, which needs no division and flattens where `linear` does. Some ten roundings of products of the
/// matrix, whatever its scales. `n` itself where nothing is left of it.
inline Vec3d transform_normal(const glm::dmat3& linear, const Vec3d& n) {
  const Vec3d x = glm::cross(linear[1], linear[2]), y = glm::cross(linear[2], linear[0]),
              z = glm::cross(linear[0], linear[1]);
  Vec3d moved = n.x * x + n.y * y + n.z * z;
  if (!normalize_safely(moved)) return n;
  return glm::dot(linear[0], x) < 0 ? -moved : moved;
}

}  // namespace sightline
