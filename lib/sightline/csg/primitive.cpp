#include "sightline/csg/primitive.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <type_traits>

#include "sightline/math/sized_double.h"

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

bool are_moderate(std::initializer_list<double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::fabs(x) <= SizedDouble::largest; });
}
bool is_moderate(const Vec3d& v) { return are_moderate({v.x, v.y, v.z}); }

struct IsModerate {
  bool operator()(const solid::HalfSpace& half) const {
    return is_moderate(half.normal) && are_moderate({half.offset});
  }
  bool operator()(const solid::Sphere& sphere) const {
    return is_moderate(sphere.center) && are_moderate({sphere.radius});
  }
  bool operator()(const solid::Box& box) const { return is_moderate(box.lo) && is_moderate(box.hi); }
  bool operator()(const solid::Cylinder& cylinder) const {
    return is_moderate(cylinder.base) && is_moderate(cylinder.top) && are_moderate({cylinder.radius});
  }
  bool operator()(const solid::Cone& cone) const {
    return is_moderate(cone.apex) && is_moderate(cone.base) && are_moderate({cone.radius});
  }
  bool operator()(const solid::Quadric& quadric) const {
    return std::all_of(quadric.coefficients.begin(), quadric.coefficients.end(),
                       [](double x) { return are_moderate({x}); });
  }
  bool operator()(const solid::Torus&) const { return false; }
  bool operator()(const std::shared_ptr<const ClosedMesh>& mesh) const {
    return std::all_of(mesh->vertices().begin(), mesh->vertices().end(), [](const Vec3d& v) { return is_moderate(v); });
  }
};

}  // namespace

bool is_moderate(const SolidShape& shape, const Frame& frame) {
  for (const auto& row : frame.rows) {
    if (!are_moderate({row[0], row[1], row[2], row[3]})) return false;
  }
  return std::visit(IsModerate(), shape);
}

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

}  // namespace sightline
