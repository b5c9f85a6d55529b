#include "sightline/scene/levels.h"

#include "sightline/scene/round_meshes.h"
#include "sightline/scene/scene_parts.h"

namespace sightline {
namespace {

Transform child_transform(double side, double degrees) {
  return Transform::scaling(Vec3d(0.75)) * Transform::translation({side, -0.75, 0}) *
         Transform::rotation({0, 1, 0}, degrees);
}

void grow(Scene& scene, NodeId node, int levels, double degrees) {
  place(scene, node, "sphere", Transform::scaling(Vec3d(0.5)), 0);
  if (levels == 1) return;
  grow(scene, scene.graph.add(node, "right", child_transform(1, degrees)), levels - 1, degrees);
  grow(scene, scene.graph.add(node, "left", child_transform(-1, degrees)), levels - 1, degrees);
}

}  // namespace

Scene make_levels(int levels, double degrees) {
  Scene scene;
  scene.name = "levels";
  add_geometry(scene, "sphere", make_sphere_geometry());
  scene.graph.set_material(root_node, add_material(scene, {.name = "clay", .color = {0.8f, 0.5f, 0.3f}}));
  add_camera(scene, root_node, "camera", {0, 0.5, 9}, {0, -1, 0}, {0, 1, 0}, 40);
  add_point_light(scene, root_node, "light", {4, 6, 8}, 300);
  grow(scene, scene.graph.add(root_node, "top"), levels, degrees);
  return scene;
}

void turn_levels(Scene& scene, double degrees) {
  const Transform right = child_transform(1, degrees), left = child_transform(-1, degrees);
  for (NodeId node = 0; node < scene.graph.size(); ++node) {
    if (scene.graph.name(node) == "right") scene.graph.set_local(node, right);
    if (scene.graph.name(node) == "left") scene.graph.set_local(node, left);
  }
}

}  // namespace sightline
