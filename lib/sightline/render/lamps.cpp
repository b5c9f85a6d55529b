#include "sightline/render/lamps.h"

#include <numbers>

#include "sightline/texture/tangent_frame.h"

namespace sightline {
namespace {

double cosine_of_degrees(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

}  // namespace

std::vector<Lamp> lamps_of(const Scene& scene) {
  std::vector<Lamp> lamps;
  for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    if (!scene.graph.is_shown(light.node)) continue;
    const Transform world = scene.graph.world(light.node);
    Lamp lamp;
    lamp.light = i;
    lamp.position = world.point(Vec3d(0));
    lamp.axis = world.vector({0, 0, -1});
    if (!normalize_safely(lamp.axis)) continue;
    lamp.strength = static_cast<float>(light.intensity) * light.color;
    if (lamp.strength == Color(0)) continue;
    if (std::holds_alternative<DirectionalLight>(light.kind)) lamp.kind = Lamp::Kind::directional;
    if (const auto* spot = std::get_if<SpotLight>(&light.kind)) {
      lamp.kind = Lamp::Kind::spot;
      lamp.cos_inner = cosine_of_degrees(spot->inner_angle);
      lamp.cos_outer = cosine_of_degrees(spot->outer_angle);
    }
    if (const auto* area = std::get_if<AreaLight>(&light.kind)) {
      lamp.kind = Lamp::Kind::area;
      lamp.right = world.vector({area->width, 0, 0});
      lamp.up = world.vector({0, area->height, 0});
      // Of a sheared rectangle too, and toward -z of the node where that is not at right angles.
      Vec3d across = glm::cross(lamp.right, lamp.up);
      lamp.area = glm::length(across);
      if (!(lamp.area > 0) || !normalize_safely(across)) continue;
      lamp.axis = glm::dot(across, lamp.axis) < 0 ? -across : across;
    }
    lamps.push_back(lamp);
  }
  return lamps;
}

}  // namespace sightline
