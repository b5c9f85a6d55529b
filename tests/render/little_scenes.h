#pragma once
/// Scenes of a few elements, written down in place.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sightline/render/renderer.h"
#include "sightline/scene/scene.h"

namespace sightline::test {

inline std::uint32_t add_material(Scene& scene, Material material) {
  scene.materials.push_back(std::move(material));
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

inline NodeId add_shape(Scene& scene, const std::string& name, std::variant<MeshGeometry, SolidTree> shape,
                        std::uint32_t material = no_item, const Transform& at = {}) {
  scene.geometries.push_back({name, std::move(shape)});
  const NodeId node = scene.graph.add(root_node, name, at);
  scene.graph.set_geometry(node, static_cast<std::uint32_t>(scene.geometries.size() - 1));
  scene.graph.set_material(node, material);
  return node;
}

inline void add_light(Scene& scene, decltype(Light::kind) kind, double intensity, const Transform& at) {
  Light light;
  light.name = "lamp" + std::to_string(scene.lights.size());
  light.node = scene.graph.add(root_node, light.name, at);
  light.kind = kind;
  light.intensity = intensity;
  scene.lights.push_back(light);
}

/// On the z axis, looking along -z.
inline void add_camera(Scene& scene, double distance, double field_of_view) {
  SceneCamera camera;
  camera.node = scene.graph.add(root_node, "camera", Transform::translation({0, 0, distance}));
  camera.field_of_view = field_of_view;
  scene.cameras.push_back(camera);
}

inline Material lambert(double albedo) {
  Material material;
  material.name = "lambert";
  material.color = Color(static_cast<float>(albedo));
  return material;
}

inline Material glass(double index = 1.5) {
  Material material;
  material.name = "glass";
  material.color = Color(1);
  material.roughness = 0;
  material.transmission = 1;
  material.refractive_index = index;
  return material;
}

inline Material mirror() {
  Material material;
  material.name = "mirror";
  material.color = Color(1);
  material.roughness = 0;
  material.metallic = 1;
  return material;
}

inline RenderSettings small(int width, int height, std::uint32_t samples = 0) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.samples = samples;
  settings.threads = 1;
  return settings;
}

/// Everything of a picture, as one tile.
struct Rendered {
  TileBuffer tile;
  RenderCounters counters;

  Vec3d mean(std::size_t pixel) const { return tile.sums[pixel].color / double(tile.sums[pixel].samples); }
  Vec3d mean(int x, int y) const {
    return mean(static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.rect.width) + static_cast<std::size_t>(x));
  }
};

inline std::vector<std::uint32_t> all_pixels(const TileRect& rect) {
  std::vector<std::uint32_t> pixels(rect.pixels());
  for (std::uint32_t i = 0; i < pixels.size(); ++i) pixels[i] = i;
  return pixels;
}

inline Rendered render(const Renderer& renderer, FactsAsked facts = FactsAsked::none) {
  Rendered result{TileBuffer({0, 0, renderer.width(), renderer.height()}), {}};
  renderer.add_samples(result.tile, all_pixels(result.tile.rect), {0, renderer.samples()}, facts, result.counters);
  return result;
}

inline Rendered render(const Scene& scene, const RenderSettings& settings) {
  return render(Renderer(std::make_shared<const Scene>(scene), settings));
}

}  // namespace sightline::test
