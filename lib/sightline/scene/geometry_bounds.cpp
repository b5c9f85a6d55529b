#include "sightline/scene/geometry_bounds.h"

#include <algorithm>
#include <vector>

#include "sightline/csg/primitive_bounds.h"
#include "sightline/csg/solid.h"
#include "sightline/math/enclosure_image.h"
#include "sightline/math/rounding.h"

namespace sightline {
namespace {

/// Of double coordinates and a radius, rounded outward: the center as stored is off by less than 2^-24 of the numbers.
Sphere stored(const Vec3d& center, double radius) {
  const Vec3f at(center);
  const double moved = glm::length(Vec3d(at) - center);
  const Sphere ball{at, round_up((radius + moved) * (1 + 0x1p-49))};
  return is_finite(at) && std::isfinite(ball.radius) ? ball : everything<Sphere>();
}

/// Around the points within `radius` of the segment between two others, or of disks there. The stored axis is off by
/// less than 2^-23, and so is what is measured along and across it.
Cylinder stored(const Vec3d& base, const Vec3d& top, double radius) {
  const Vec3d middle = 0.5 * base + 0.5 * top, way = 0.5 * top - 0.5 * base;
  const Vec3f at(middle), axis(glm::normalize(way));
  const double half_length = glm::length(way), moved = glm::length(Vec3d(at) - middle);
  const double off = 0x1p-22 * (half_length + radius) + moved * (1 + 0x1p-49);
  const Cylinder rod{at, axis, round_up(radius + off), round_up(half_length + off)};
  const bool is_bounded = is_finite(at) && is_finite(axis) && axis != Vec3f(0) && std::isfinite(rod.radius) &&
                          std::isfinite(rod.half_length);
  return is_bounded ? rod : everything<Cylinder>();
}

/// The closer ones of a shape's own; `box` holds it.
struct ShapeEnclosure {
  const Aabb& box;

  Enclosure operator()(const solid::Sphere& s) const { return {box, stored(s.center, s.radius), cylinder_around(box)}; }
  Enclosure operator()(const solid::Cylinder& c) const {
    return {box, ball_around(box), stored(c.base, c.top, c.radius)};
  }
  Enclosure operator()(const solid::Cone& c) const { return {box, ball_around(box), stored(c.apex, c.base, c.radius)}; }
  Enclosure operator()(const solid::Torus& t) const {
    const Vec3d tube = t.minor * glm::normalize(t.axis / max_norm(t.axis));
    return {box, stored(t.center, t.major + t.minor), stored(t.center - tube, t.center + tube, t.major + t.minor)};
  }
  Enclosure operator()(const std::shared_ptr<const ClosedMesh>& mesh) const {
    const std::vector<Vec3f> points(mesh->vertices().begin(), mesh->vertices().end());
    Enclosure made = enclosure_of(points);
    const Vec3d most = glm::max(glm::abs(Vec3d(box.lo)), glm::abs(Vec3d(box.hi)));
    const double moved = 0x1p-23 * (most.x + most.y + most.z) + 0x1p-148;  // twice what float takes from vertices
    made.box = box;
    made.sphere.radius = round_up(made.sphere.radius + moved);
    made.cylinder.radius = round_up(made.cylinder.radius + moved);
    made.cylinder.half_length = round_up(made.cylinder.half_length + moved);
    return made;
  }
  template <class Shape>
  Enclosure operator()(const Shape&) const {
    return enclosure_of(box);
  }
};

Enclosure everywhere() { return {everything<Aabb>(), everything<Sphere>(), everything<Cylinder>()}; }

Enclosure of_primitive(const Solid& solid, const SolidNode& node) {
  const Primitive& primitive = solid.primitives()[node.primitive];
  const Frame* const frame = solid.frame_of(primitive);
  if (frame == nullptr) return std::visit(ShapeEnclosure{node.bounds}, primitive.shape);
  const auto own_box = bounds_of(primitive.shape, Frame());
  if (!own_box) return enclosure_of(node.bounds);
  const Enclosure own = std::visit(ShapeEnclosure{*own_box}, primitive.shape);
  const Affine to_solid = Transform::of(*frame).inverse();  // each number within 2^-51: less than EnclosureImage covers
  const EnclosureImage image(to_solid, own);
  return {node.bounds, image.sphere(), image.cylinder()};
}

Enclosure of_children(const Solid& solid, const SolidNode& node, const std::vector<Enclosure>& known) {
  std::vector<Sphere> spheres;
  std::vector<Cylinder> cylinders;
  for (const std::uint32_t child : solid.children(node)) {
    spheres.push_back(known[child].sphere);
    cylinders.push_back(known[child].cylinder);
  }
  switch (node.operation) {
    case Operation::subtract:
      return {node.bounds, spheres[0], cylinders[0]};
    case Operation::intersect: {
      Enclosure least = everywhere();
      for (const Sphere& s : spheres) least.sphere = closer_of(least.sphere, s);
      for (const Cylinder& c : cylinders) least.cylinder = closer_of(least.cylinder, c);
      return {node.bounds, least.sphere, least.cylinder};
    }
    default:
      return {node.bounds, around(spheres), around(cylinders)};
  }
}

/// Parts come before what they are parts of (N1 of SolidNode).
Enclosure enclosure_of(const Solid& solid) {
  std::vector<Enclosure> known;
  for (const SolidNode& node : solid.nodes()) {
    if (!node.is_bounded || node.is_complement) {  // the bounds of a complement are those of what it leaves out
      known.push_back(everywhere());
      continue;
    }
    Enclosure made = node.is_primitive ? of_primitive(solid, node) : of_children(solid, node, known);
    made.sphere = closer_of(made.sphere, ball_around(node.bounds));
    made.cylinder = closer_of(made.cylinder, cylinder_around(node.bounds));
    if (is_nothing(node.bounds)) made = Enclosure();
    known.push_back(made);
  }
  return known.back();
}

}  // namespace

Enclosure enclosure_of(const Geometry& geometry) {
  if (const auto* tree = std::get_if<SolidTree>(&geometry.shape)) return enclosure_of(Solid(*tree));
  const auto& mesh = std::get<MeshGeometry>(geometry.shape).mesh;
  return mesh ? enclosure_of(mesh->positions()) : Enclosure();
}

}  // namespace sightline
