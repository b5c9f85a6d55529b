#pragma once
/// What solids are made of: shapes in frames of their own, and their faces.

#include <array>
#include <cstdint>
#include <memory>
#include <variant>

#include "sightline/shape/closed_mesh.h"
#include "sightline/shape/solid_shape.h"

namespace sightline {

using SolidShape = std::variant<solid::HalfSpace, solid::Sphere, solid::Box, solid::Cylinder, solid::Cone,
                                solid::Quadric, solid::Torus, std::shared_ptr<const ClosedMesh>>;

struct Primitive {
  SolidShape shape;
  std::uint32_t frame = 0;  ///< Of the solid; 0 is the world.
  std::uint32_t material = 0;
  bool is_moderate = false;  ///< All numbers, and the frame's, suit SizedDouble.
};

/// A face of a shape, whatever it is.
using Surface = std::variant<solid::AxisPlane, solid::HalfSpace, solid::Cap, solid::Sphere, solid::Cylinder,
                             solid::Cone, solid::Quadric, solid::Torus, solid::Facet>;

/// Which face is what: a cylinder's are its side, base and top, a cone's its side, the plane through its apex and its
/// base, a box's the lower and upper one of x, y and z, a mesh's its triangles.
Surface surface_of(const SolidShape& shape, std::uint32_t face);

/// Whether the numbers of a shape in a frame are at most SizedDouble::largest.
bool is_moderate(const SolidShape& shape, const Frame& frame);

/// Whether two surfaces are one and the same set of points by their very numbers, whichever side is inside. False does
/// not say that they differ.
bool is_same(const Surface& a, const Surface& b);

/// The only axis along which the plane's way moves, or -1.
inline int axis_across(const solid::Cap& cap) {
  const bool x = cap.from.x != cap.to.x, y = cap.from.y != cap.to.y, z = cap.from.z != cap.to.z;
  return x + y + z != 1 ? -1 : y + 2 * z;
}

/// The plane of a half-space, as one across an axis where it is such a one exactly (F3).
std::variant<solid::AxisPlane, solid::HalfSpace> plane_of(const solid::HalfSpace& half);
/// The plane of a cap, likewise.
inline std::variant<solid::AxisPlane, solid::Cap> plane_of(const solid::Cap& cap) {
  const int axis = axis_across(cap);
  if (axis < 0) return cap;
  return solid::AxisPlane{axis, cap.to[axis], cap.to[axis] > cap.from[axis]};
}

}  // namespace sightline
