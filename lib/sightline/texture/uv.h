#pragma once
/// Places on a surface as places in an image: u to the right, v up, the image from (0, 0) to (1, 1).

#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

#include "sightline/math/vec.h"
#include "sightline/texture/waves.h"

namespace sightline {

/// What (u, v) moves by from a pixel to the next to the right and to the next below.
struct UvFootprint {
  glm::dvec2 right{0}, below{0};
};

/// On a sphere around the origin: u is the angle around the z axis from x over y, in turns, v the angle from -z, in
/// half turns. For any length of p, and no arc cosine that rounding could ask for more than 1.
///   U1  u is in [0, 1): the seam, where y = +-0, has one u on both sides of zero, 0 where x > 0 and 1/2 where x < 0.
///   U2  At a pole, where no u is better than another, it is 0 or 1/2 and never NaN.
inline glm::dvec2 spherical_uv(const Vec3d& p) {
  using std::numbers::pi;
  return {fraction(std::atan2(p.y, p.x) / (2 * pi)), std::atan2(std::hypot(p.x, p.y), -p.z) / pi};
}

/// The derivatives of p by u and by v. At a pole that by u is 0; complete it to a frame by the normal.
struct SurfaceDerivatives {
  Vec3d du, dv;
};
inline SurfaceDerivatives spherical_derivatives(const Vec3d& p) {
  using std::numbers::pi;
  const double across = std::hypot(p.x, p.y);
  // Where the meridian has no direction, that of u = 0 is one.
  const double x = across > 0 ? p.x / across : 1, y = across > 0 ? p.y / across : 0;
  return {2 * pi * Vec3d(-p.y, p.x, 0), pi * Vec3d(-p.z * x, -p.z * y, across)};
}

/// How (u, v) moves where p moves by `right` and `below`: derivatives, not differences, which would cross the seam. A
/// footprint around a pole holds all of u.
inline UvFootprint spherical_footprint(const Vec3d& p, const Vec3d& right, const Vec3d& below) {
  const auto [du, dv] = spherical_derivatives(p);
  const auto move = [&](const Vec3d& step) {
    const double turn = glm::dot(step, du) / glm::dot(du, du), rise = glm::dot(step, dv) / glm::dot(dv, dv);
    return glm::dvec2(std::fabs(turn) <= 1 ? turn : 1, std::fabs(rise) <= 1 ? rise : 1);
  };
  return {move(right), move(below)};
}

}  // namespace sightline
