#include "sightline/scene/rocket.h"

#include <string>

namespace sightline {
namespace {

constexpr double length = 4, radius = 0.5;

std::uint32_t add_geometry(Scene& scene, std::string name, SolidTree solid) {
  scene.geometries.push_back({std::move(name), std::move(solid)});
  return static_cast<std::uint32_t>(scene.geometries.size() - 1);
}

std::uint32_t add_material(Scene& scene, std::string name, const Color& color) {
  Material material;
  material.name = std::move(name);
  material.color = color;
  scene.materials.push_back(std::move(material));
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

}  // namespace

Scene rocket() {
  Scene scene;
  scene.name = "rocket";
  const std::uint32_t white = add_material(scene, "white", {0.9, 0.9, 0.9});
  const std::uint32_t red = add_material(scene, "red", {0.8, 0.1, 0.1});
  const std::uint32_t fire = add_material(scene, "fire", {1, 0.6, 0.1});
  scene.materials[fire].emission = {1, 0.6, 0.1};

  const NodeId whole = scene.graph.add(root_node, "rocket");
  const auto add = [&](std::string name, std::uint32_t geometry, std::uint32_t material, const Transform& local = {}) {
    const NodeId node = scene.graph.add(whole, std::move(name), local);
    scene.graph.set_geometry(node, geometry);
    scene.graph.set_material(node, material);
  };
  add("body", add_geometry(scene, "body", solid::Cylinder{{0, 0, 0}, {0, length, 0}, radius}), white);
  add("nose", add_geometry(scene, "nose", solid::Cone{{0, length + 1.5, 0}, {0, length, 0}, radius}), red);
  const std::uint32_t fin = add_geometry(scene, "fin", solid::Box{{radius, 0, -0.05}, {2 * radius, 1.2, 0.05}});
  for (int i = 0; i < 4; ++i) {
    add("fin " + std::to_string(i + 1), fin, red, Transform::rotation(Vec3d(0, 1, 0), 90 * i));
  }
  add("flame", add_geometry(scene, "flame", solid::Cone{{0, -1.5, 0}, {0, 0, 0}, 0.8 * radius}), fire);
  return scene;
}

}  // namespace sightline
