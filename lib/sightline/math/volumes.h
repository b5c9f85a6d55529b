#pragma once
/// The regions of space that cells and bounding volumes are made of, besides boxes.

#include <array>
#include <cstdint>
#include <vector>

#include "sightline/math/vec.h"

namespace sightline {

/// The closed half-space normal . x <= offset. The normal need not have unit length.
struct Plane {
  Vec3d normal{0, 0, 1};
  double offset = 0;

  /// Signed distance in units of the normal's length; positive in front.
  double side(const Vec3d& p) const { return glm::dot(normal, p) - offset; }
};

struct Sphere {
  Vec3f center{0};
  float radius = 0;
};

/// A solid cylinder with flat caps: the points within `radius` of the segment center +- half_length * axis.
struct Cylinder {
  Vec3f center{0};
  Vec3f axis{0, 0, 1};  ///< Of unit length but for rounding.
  float radius = 0;
  float half_length = 0;
};

/// A convex polyhedron as its faces, each a convex polygon counter-clockwise when seen from outside.
struct Polyhedron {
  std::vector<Vec3d> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
};

}  // namespace sightline
