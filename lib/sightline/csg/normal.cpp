#include <cmath>
#include <variant>

#include "sightline/csg/solid.h"

namespace sightline {
namespace {

/// Gradients of the faces' polynomials, up to a positive factor.
struct Gradient {
  Vec3d p;

  Vec3d operator()(const solid::AxisPlane& plane) const {
    Vec3d normal(0);
    normal[plane.axis] = plane.is_upper ? 1 : -1;
    return normal;
  }
  Vec3d operator()(const solid::HalfSpace& half) const { return half.normal; }
  Vec3d operator()(const solid::Cap& cap) const { return cap.to - cap.from; }
  Vec3d operator()(const solid::Sphere& sphere) const { return p - sphere.center; }
  Vec3d operator()(const solid::Cylinder& cylinder) const {
    const Vec3d axis = cylinder.top - cylinder.base;
    return glm::cross(axis, glm::cross(p - cylinder.base, axis));
  }
  Vec3d operator()(const solid::Cone& cone) const {
    const Vec3d axis = cone.base - cone.apex, q = p - cone.apex;
    const double length2 = glm::dot(axis, axis);
    return glm::cross(axis, glm::cross(q, axis)) - (cone.radius * cone.radius * glm::dot(q, axis) / length2) * axis;
  }
  Vec3d operator()(const solid::Quadric& quadric) const {
    const auto& q = quadric.coefficients;
    return {2 * q[0] * p.x + q[3] * p.y + q[4] * p.z + q[6], q[3] * p.x + 2 * q[1] * p.y + q[5] * p.z + q[7],
            q[4] * p.x + q[5] * p.y + 2 * q[2] * p.z + q[8]};
  }
  Vec3d operator()(const solid::Torus& torus) const { return normal_at(torus, p); }
  Vec3d operator()(const solid::Facet& facet) const {
    const auto& v = facet.vertices;
    return glm::cross(v[1] - v[0], v[2] - v[0]);
  }
};

/// Of a primitive's face; that of a surface, without a copy of it where that is easy.
Vec3d gradient_at(const SolidShape& shape, std::uint32_t face, const Vec3d& p) {
  const Gradient gradient{p};
  if (const auto* box = std::get_if<solid::Box>(&shape)) return gradient(solid::face_of(*box, face));
  if (const auto* sphere = std::get_if<solid::Sphere>(&shape)) return gradient(*sphere);
  if (const auto* cylinder = std::get_if<solid::Cylinder>(&shape); cylinder && face == 0) return gradient(*cylinder);
  return std::visit(gradient, surface_of(shape, face));
}

/// Of unit length, or the other vector's direction where there is none.
Vec3d unit(const Vec3d& v, const Vec3d& otherwise) {
  const double size = max_norm(v);
  if (size > 0x1p-400 && size < 0x1p+400) [[likely]]
    return v * (1 / std::sqrt(glm::dot(v, v)));
  if (!(size > 0) || !std::isfinite(size)) return glm::normalize(otherwise / max_norm(otherwise));
  return glm::normalize(v / size);
}

}  // namespace

Vec3d Solid::normal(const Boundary& boundary, const Ray<double>& ray) const {
  const Primitive& primitive = primitives_[boundary.primitive];
  const Frame* frame = frame_of(primitive);
  if (const auto* box = std::get_if<solid::Box>(&primitive.shape); box && !frame) {
    const Vec3d normal = Gradient{Vec3d(0)}(solid::face_of(*box, boundary.face));
    return boundary.is_flipped ? -normal : normal;
  }
  const Vec3d world = ray.at(boundary.t);
  if (const auto* sphere = std::get_if<solid::Sphere>(&primitive.shape); sphere && !frame) {
    const Vec3d normal = unit(world - sphere->center, boundary.is_flipped ? ray.direction : -ray.direction);
    return boundary.is_flipped ? -normal : normal;
  }
  Vec3d local = world;
  for (int i = 0; i < 3 && frame; ++i) {
    const auto& row = frame->rows[static_cast<std::size_t>(i)];
    local[i] = row[0] * world.x + row[1] * world.y + row[2] * world.z + row[3];
  }
  const Vec3d gradient = gradient_at(primitive.shape, boundary.face, local);
  Vec3d normal = gradient;
  if (frame) {  // covectors go back by the transposed matrix
    normal = Vec3d(0);
    for (int i = 0; i < 3; ++i) {
      const auto& row = frame->rows[static_cast<std::size_t>(i)];
      normal += gradient[i] * Vec3d(row[0], row[1], row[2]);
    }
  }
  normal = unit(normal, boundary.is_flipped ? ray.direction : -ray.direction);
  return boundary.is_flipped ? -normal : normal;
}

}  // namespace sightline
