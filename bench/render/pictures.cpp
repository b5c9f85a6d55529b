#include "bench/render/pictures.h"

#include <numbers>

#include "bench/solids/povray_text.h"
#include "bench/solids/scene.h"
#include "sightline/texture/wood.h"

namespace sightline::bench {
namespace {

/// Where the light comes from.
const Vec3d to_lamp = glm::normalize(Vec3d(-2, 4, 3));

/// One solid of a white Lambert surface, which the lamp's irradiance pi makes as bright as the cosine.
std::shared_ptr<Scene> scene_of(const SolidTree& solid) {
  auto scene = std::make_shared<Scene>();
  Material material;
  material.name = "surface";
  material.color = Color(1);
  scene->materials.push_back(material);
  scene->geometries.push_back({"solid", solid});
  const NodeId node = scene->graph.add(root_node, "solid");
  scene->graph.set_geometry(node, 0);
  scene->graph.set_material(node, 0);

  // A turn that takes -z to where light goes.
  const Vec3d right = glm::normalize(glm::cross(Vec3d(0, 1, 0), to_lamp)), up = glm::cross(to_lamp, right);
  Affine turn;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<glm::length_t>(i);
    turn.rows[i] = {right[axis], up[axis], to_lamp[axis], 0};
  }
  Light lamp;
  lamp.name = "lamp";
  lamp.node = scene->graph.add(root_node, "lamp", Transform::of(turn));
  lamp.kind = DirectionalLight{};
  lamp.intensity = std::numbers::pi;
  scene->lights.push_back(lamp);
  return scene;
}

std::string povray_scene(const Camera& camera, const SolidTree& solid, const std::string& pigment) {
  return povray_text(camera) + "light_source { " + povray_text(100.0 * to_lamp) + ", rgb 1 parallel point_at 0 }\n" +
         povray_text(solid, " pigment { " + pigment + " } finish { ambient 0 diffuse 1 }");
}

/// Rings around the y axis, moved by one octave of noise, in two colors: as ours, with POV-Ray's own noise.
std::string wood_pigment() {
  const WoodOptions wood;
  return "wood turbulence 0.25 octaves 1 color_map { [0 rgb " + povray_text(Vec3d(wood.early)) + "] [1 rgb " +
         povray_text(Vec3d(wood.late)) + "] } rotate 90*x scale 1/3";
}

}  // namespace

std::vector<RenderPicture> render_pictures() {
  std::vector<RenderPicture> pictures;
  const SolidTree of_widget = widget(Vec3d(0), 1), sphere = solid::Sphere{};
  pictures.push_back({"widget", "box & sphere - three cylinders", scene_of(of_widget),
                      [=](const Camera& camera) { return povray_scene(camera, of_widget, "rgb 1"); }});
  const std::shared_ptr<Scene> wood = scene_of(sphere);
  wood->textures.push_back({"wood", std::string("wood:texture_frequency=3"), false, nullptr});
  wood->materials[0].color_texture = 0;
  pictures.push_back({"wood", "a sphere of wood, rings moved by noise", wood,
                      [=](const Camera& camera) { return povray_scene(camera, sphere, wood_pigment()); }, false});
  return pictures;
}

}  // namespace sightline::bench
