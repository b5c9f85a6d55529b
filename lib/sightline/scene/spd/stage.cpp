#include "sightline/scene/spd/stage.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace sightline::spd {

Scene stage(const char* name, Up up, const View& view, const Vec3d& subject, std::initializer_list<Vec3d> lights) {
  Scene scene;
  scene.name = name;
  if (up == Up::z) scene.graph.set_local(root_node, Transform::rotation({1, 0, 0}, -90));
  add_camera(scene, root_node, "camera", view.from, view.at, view.up, view.angle);
  const double brightness = 0.5 / std::sqrt(static_cast<double>(lights.size()));
  int number = 0;
  for (const Vec3d& light : lights) {
    const Vec3d way = light - subject;
    add_point_light(scene, root_node, "light " + std::to_string(++number), light,
                    std::numbers::pi * brightness * glm::dot(way, way));
  }
  return scene;
}

std::uint32_t add_surface(Scene& scene, const char* name, const Surface& surface) {
  const double sum = surface.diffuse + surface.specular + surface.transmission;
  Material material;
  material.name = name;
  material.color = static_cast<float>(std::min(1.0, sum)) * surface.color;
  material.metallic = surface.specular / sum;
  material.transmission = surface.transmission / sum;
  if (material.metallic > 0 || material.transmission > 0) material.roughness = 0;
  if (material.transmission > 0) material.refractive_index = surface.refractive_index;
  return add_material(scene, std::move(material));
}

}  // namespace sightline::spd
