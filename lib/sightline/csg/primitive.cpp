#include "sightline/csg/primitive.h"

#include <cassert>
#include <type_traits>

namespace sightline {
namespace {

template <class Plane>
Surface widened(const Plane& plane) {
  return std::visit([](const auto& p) -> Surface { return p; }, plane);
}

struct SurfaceOf {
  std::uint32_t face;

  Surface operator()(const solid::HalfSpace& half) const { return widened(plane_of(half)); }
  Surface operator()(const solid::Sphere& sphere) const { return sphere; }
  Surface operator()(const solid::Box& box) const { return face_of(box, face); }
  Surface operator()(const solid::Cylinder& cylinder) const {
    if (face == 0) return cylinder;
    return widened(plane_of(cap_of(cylinder, face == 2)));
  }
  Surface operator()(const solid::Cone& cone) const {
    if (face == 0) return cone;
    return widened(plane_of(cap_of(cone, face == 2)));
  }
  Surface operator()(const solid::Quadric& quadric) const { return quadric; }
  Surface operator()(const solid::Torus& torus) const { return torus; }
  Surface operator()(const std::shared_ptr<const ClosedMesh>& mesh) const { return mesh->facet(face); }
};

}  // namespace

Surface surface_of(const SolidShape& shape, std::uint32_t face) { return std::visit(SurfaceOf{face}, shape); }

bool is_same(const Surface& a, const Surface& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&]<class S>(const S& x) {
        const S& y = std::get<S>(b);
        if constexpr (std::is_same_v<S, solid::AxisPlane>) {
          return x.axis == y.axis && x.position == y.position;
        } else {
          return x == y;
        }
      },
      a);
}

std::variant<solid::AxisPlane, solid::HalfSpace> plane_of(const solid::HalfSpace& half) {
  const int axis = solid::axis_along(half.normal);
  if (axis < 0) return half;
  const double scale = half.normal[axis], position = half.offset / scale;
  // Exact where nothing is left of the division, nor lost by underflow.
  const bool is_exact = std::fma(position, scale, -half.offset) == 0 &&
                        (half.offset == 0 || (std::fabs(half.offset) > 0x1p-900 && std::isnormal(position)));
  if (!is_exact) return half;
  return solid::AxisPlane{axis, position, scale > 0};
}

std::variant<solid::AxisPlane, solid::Cap> plane_of(const solid::Cap& cap) {
  int axis = -1, moves = 0;
  for (int i = 0; i < 3; ++i) {
    if (cap.from[i] != cap.to[i]) axis = i, ++moves;
  }
  if (moves != 1) return cap;
  return solid::AxisPlane{axis, cap.to[axis], cap.to[axis] > cap.from[axis]};
}

}  // namespace sightline
