#include "sightline/scene/scene_parts.h"

#include <cmath>
#include <utility>

namespace sightline {

std::uint32_t add_geometry(Scene& scene, std::string name, MeshGeometry mesh) {
  scene.geometries.push_back({std::move(name), std::move(mesh)});
  return static_cast<std::uint32_t>(scene.geometries.size() - 1);
}

std::uint32_t add_material(Scene& scene, Material material) {
  scene.materials.push_back(std::move(material));
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

NodeId place(Scene& scene, NodeId parent, std::string name, const Transform& local, std::uint32_t geometry,
             std::uint32_t material) {
  const NodeId node = scene.graph.add(parent, std::move(name), local);
  scene.graph.set_geometry(node, geometry);
  scene.graph.set_material(node, material);
  return node;
}

NodeId add_camera(Scene& scene, NodeId parent, std::string name, const Vec3d& eye, const Vec3d& target,
                  const Vec3d& y_up, double field_of_view) {
  const Vec3d back = glm::normalize(eye - target);
  const Vec3d right = glm::normalize(glm::cross(y_up, back));
  const Vec3d up = glm::cross(back, right);
  Affine frame;
  for (int axis = 0; axis < 3; ++axis) {
    frame.rows[static_cast<std::size_t>(axis)] = {right[axis], up[axis], back[axis], eye[axis]};
  }
  const NodeId node = scene.graph.add(parent, name, Transform::of(frame));
  scene.cameras.push_back({std::move(name), node, field_of_view});
  return node;
}

NodeId add_point_light(Scene& scene, NodeId parent, std::string name, const Vec3d& at, double intensity) {
  const NodeId node = scene.graph.add(parent, name, Transform::translation(at));
  scene.lights.push_back({std::move(name), node, PointLight(), Color(1), intensity});
  return node;
}

/// The quaternion of half the turn, along (1 + cos, axis * sin). Below the equator 1 + cos cancels and is taken from
/// sin^2 instead, both scaled by 1 - cos.
Transform turn_to(const Vec3d& direction) {
  const Vec3d d = glm::normalize(direction);
  if (d.z >= 0) return Transform::rotation(glm::dquat(1 + d.z, -d.y, d.x, 0));
  if (d.x == 0 && d.y == 0) return Transform::rotation({0, 1, 0}, 180);
  return Transform::rotation(glm::dquat(d.x * d.x + d.y * d.y, -d.y * (1 - d.z), d.x * (1 - d.z), 0));
}

Transform stretch_between(const Vec3d& from, const Vec3d& to, double radius) {
  const Vec3d way = to - from;
  return Transform::translation(from) * turn_to(way) * Transform::scaling({radius, radius, glm::length(way)});
}

Scene scene_of(std::string name, std::shared_ptr<const TriangleMesh> mesh) {
  Scene scene;
  scene.name = name;
  const std::uint32_t geometry = add_geometry(scene, name, {std::move(mesh), {}, {}});
  place(scene, root_node, std::move(name), {}, geometry);
  return scene;
}

}  // namespace sightline
