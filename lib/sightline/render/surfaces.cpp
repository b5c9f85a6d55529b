#include "sightline/render/surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sightline/texture/uv.h"

namespace sightline {
namespace {

Vec3d unit_or(const Vec3d& v, const Vec3d& otherwise) {
  Vec3d unit = v;
  return normalize_safely(unit) ? unit : otherwise;
}

/// The cube root of how volumes change on the way back.
double length_scale(const Transform& to_world) {
  const Affine& back = to_world.inverse();
  return std::cbrt(std::fabs(glm::dot(back.column(0), glm::cross(back.column(1), back.column(2)))));
}

}  // namespace

std::uint32_t material_named(const Scene& scene, const std::string& name, std::uint32_t otherwise) {
  if (name.empty()) return otherwise;
  for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
    if (scene.materials[i].name == name) return i;
  }
  return otherwise;
}

struct Surfaces::Place {
  std::array<std::uint32_t, 3> corners;
  Triangle placed;
  double weights[3];

  template <class List>
  auto mixed(const List& list) const {
    using V = glm::vec<List::value_type::length(), double>;
    return weights[0] * V(list[corners[0]]) + weights[1] * V(list[corners[1]]) + weights[2] * V(list[corners[2]]);
  }
};

std::vector<std::uint32_t> primitives_in(const Solid& solid) {
  std::vector<std::uint32_t> primitives;
  std::vector<const SolidNode*> open{&solid.root()};
  while (!open.empty()) {
    const SolidNode& node = *open.back();
    open.pop_back();
    if (node.is_primitive) primitives.push_back(node.primitive);
    for (const std::uint32_t child : solid.children(node)) open.push_back(&solid.nodes()[child]);
  }
  return primitives;
}

Surfaces::Surfaces(const Scene& scene, const TraceWorld& world)
    // Level fast computes in float; above, t is within 2^-46 of itself.
    : scene_(scene), world_(world), solid_error_(world.level() == Level::fast ? 0x1p-18 : 0x1p-46) {
  for (std::uint32_t i = 0; i < world.size(); ++i) {
    const SceneOrigin& origin = world.origin(i);
    Item item;
    if (world.is_solid(i)) {
      item.to_world = scene.graph.world(origin.node);
      item.first_material = static_cast<std::uint32_t>(materials_.size());
      for (const std::string& name : world.solid(i).materials()) {
        materials_.push_back(material_named(scene, name, origin.material));
      }
    } else {
      item.mesh = &std::get<MeshGeometry>(scene.geometries[scene.graph.geometry(origin.node)].shape);
      item.to_world = Transform::of(world.instances().placements()[i].to_world());
    }
    item.scale = length_scale(item.to_world);
    has_smooth_ = has_smooth_ || (item.mesh && !item.mesh->normals.empty());
    items_.push_back(std::move(item));
  }
}

Surfaces::Place Surfaces::place(const WorldHit& hit) const {
  const Instances& instances = world_.instances();
  Place place{instances.mesh_of(hit.item).triangles()[hit.prim_id],
              instances.triangle(hit.item, hit.prim_id),
              {1 - hit.u - hit.v, hit.u, hit.v}};
  if (instances.placements()[hit.item].is_mirroring()) std::swap(place.corners[1], place.corners[2]);  // I2
  return place;
}

void Surfaces::locate(const Ray<double>& ray, const WorldHit& hit, SurfacePoint& at) const {
  if (world_.is_solid(hit.item)) {
    Boundary boundary;
    boundary.t = hit.t;
    boundary.primitive = hit.prim_id;
    boundary.face = static_cast<std::uint32_t>(hit.v);
    const Vec3d outside = world_.solid(hit.item).normal(boundary, ray), point = ray.at(hit.t);
    // Number by number, as they were written.
    for (int i = 0; i < 3; ++i) at.outside[i] = outside[i], at.point[i] = point[i];
    const double way = hit.t * max_norm(ray.direction);
    at.error = solid_error_ * way + 0x1p-51 * (max_norm(ray.origin) + way);
    return;
  }
  const Place found = place(hit);
  const Vec3d a(found.placed.a), b(found.placed.b), c(found.placed.c);
  at.point = found.weights[0] * a + found.weights[1] * b + found.weights[2] * c;
  // Three products and sums, each rounded, of weights whose sum is 1 but for two roundings.
  at.error = 0x1p-50 * (max_norm(a) + max_norm(b) + max_norm(c));
  at.outside = unit_or(glm::cross(b - a, c - a), Vec3d(0, 0, 1));
}

std::uint32_t Surfaces::material(const WorldHit& hit) const {
  if (!world_.is_solid(hit.item)) return world_.origin(hit.item).material;
  const Solid& solid = world_.solid(hit.item);
  return material(hit.item, solid.primitives()[hit.prim_id].material);
}

Vec3d Surfaces::interpolated_normal(const WorldHit& hit, const SurfacePoint& at) const {
  const Item& item = items_[hit.item];
  const Vec3d normal = unit_or(item.to_world.normal(place(hit).mixed(item.mesh->normals)), at.outside);
  return glm::dot(normal, at.outside) < 0 ? -normal : normal;
}

Vec3d Surfaces::local_of_mesh(const WorldHit& hit) const {
  return place(hit).mixed(items_[hit.item].mesh->mesh->positions());
}

Footprint Surfaces::wide_footprint(const WorldHit& hit, const SurfacePoint& at, double width) const {
  const TangentFrame frame = frame_around(at.outside);
  const Affine& back = items_[hit.item].to_world.inverse();
  return {back.vector(width * frame.tangent), back.vector(width * frame.bitangent)};
}

Surfaces::ImagePlace Surfaces::image_place(const WorldHit& hit, const SurfacePoint& at) const {
  const Item& item = items_[hit.item];
  if (!item.mesh) {
    const Vec3d p = item.to_world.inverse().point(at.point);
    const double radius = glm::length(p);
    return {spherical_uv(p), radius > 0 ? item.scale / (2 * std::numbers::pi * radius) : 0};
  }
  if (item.mesh->uvs.empty()) return {};
  const Place found = place(hit);
  const auto& uvs = item.mesh->uvs;
  const glm::dvec2 a(uvs[found.corners[0]]), b(uvs[found.corners[1]]), c(uvs[found.corners[2]]);
  const Vec3d first = Vec3d(found.placed.b) - Vec3d(found.placed.a),
              second = Vec3d(found.placed.c) - Vec3d(found.placed.a);
  const double area = glm::length(glm::cross(first, second));
  const double image_area = std::fabs((b - a).x * (c - a).y - (b - a).y * (c - a).x);
  return {found.mixed(uvs), area > 0 ? std::sqrt(image_area / area) : 0};
}

Vec3d Surfaces::dented(const WorldHit& hit, const SurfacePoint& at, const Vec3d& normal, const Dents& dents,
                       double footprint) const {
  const Transform& to_world = items_[hit.item].to_world;
  // Normals go to the shape by the transposed matrix, and back by that of the inverse.
  const Vec3d flat = unit_or(to_world.matrix().covector(normal), normal);
  return unit_or(to_world.normal(dents.normal(flat, local(hit, at), items_[hit.item].scale * footprint)), normal);
}

TangentFrame Surfaces::tangent_frame(const WorldHit& hit, const SurfacePoint& at, const Vec3d& normal) const {
  const Item& item = items_[hit.item];
  if (!item.mesh) {
    const auto [du, dv] = spherical_derivatives(item.to_world.inverse().point(at.point));
    return frame_along(normal, item.to_world.vector(du), item.to_world.vector(dv));
  }
  if (item.mesh->uvs.empty()) return frame_around(normal);
  const Place found = place(hit);
  const auto& uvs = item.mesh->uvs;
  return triangle_frame(
      normal, {Vec3d(found.placed.a), Vec3d(found.placed.b), Vec3d(found.placed.c)},
      {glm::dvec2(uvs[found.corners[0]]), glm::dvec2(uvs[found.corners[1]]), glm::dvec2(uvs[found.corners[2]])});
}

}  // namespace sightline
