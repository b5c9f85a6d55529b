#include <array>
#include <cmath>
#include <numbers>

#include "sightline/scene/round_meshes.h"
#include "sightline/scene/spd/databases.h"
#include "sightline/scene/spd/stage.h"

namespace sightline::spd {
namespace {

constexpr double child_scale = 1.0 / 3;

/// Where a sphere's children are, seen from it, with its own parent at -z: six around the equator, three above.
std::array<Vec3d, 9> child_directions() {
  std::array<Vec3d, 9> directions;
  for (int i = 0; i < 9; ++i) {
    const bool is_above = i >= 6;
    const double azimuth = is_above ? 45 + 120 * i : 15 + 60 * i;
    const Vec3d flat = Transform::rotation({0, 0, 1}, azimuth).vector({1, 0, 0});
    directions[static_cast<std::size_t>(i)] = is_above ? flat / std::sqrt(3.0) + Vec3d(0, 0, std::sqrt(2.0 / 3)) : flat;
  }
  return directions;
}

/// What turns +z to a child's direction by the shortest way decides where its own children are. Of those straight
/// below, real arithmetic has x = y = 0, and any way is shortest: rounding must not choose. It moves directions by less
/// than 2^-45 within five levels, where all others are 2^-16 off at least.
Transform pole_turn(const Vec3d& direction) {
  const bool is_straight_below = direction.z < 0 && std::hypot(direction.x, direction.y) < 0x1p-40;
  return turn_to(is_straight_below ? Vec3d(0, 0, -1) : direction);
}

class Flake {
 public:
  Flake(Scene& scene, std::uint32_t sphere, std::uint32_t material)
      : scene_(scene), sphere_(sphere), material_(material) {}

  void grow(NodeId node, const Transform& turn, int levels) {
    if (levels == 0) return;
    for (const Vec3d& direction : directions_) {
      const Transform child_turn = pole_turn(turn.vector(direction));
      const Transform local = Transform::translation((1 + child_scale) * direction) * (turn.inverted() * child_turn) *
                              Transform::scaling(Vec3d(child_scale));
      grow(place(scene_, node, "", local, sphere_, material_), child_turn, levels - 1);
    }
  }

 private:
  Scene& scene_;
  std::uint32_t sphere_, material_;
  std::array<Vec3d, 9> directions_ = child_directions();
};

}  // namespace

Scene make_balls(int levels) {
  Scene scene =
      stage("balls", Up::z, {{2.1, 1.3, 1.7}, {0, 0, 0}, {0, 0, 1}}, {0, 0, 0}, {{4, 3, 2}, {1, -4, 4}, {-3, 1, 5}});
  const std::uint32_t floor = add_geometry(
      scene, "floor", make_quad_geometry({12, 12, -0.5f}, {-12, 12, -0.5f}, {-12, -12, -0.5f}, {12, -12, -0.5f}));
  place(scene, root_node, "floor", {}, floor, add_surface(scene, "floor", {{1, 0.75f, 0.33f}, 0.8}));

  const std::uint32_t sphere = add_geometry(scene, "sphere", make_sphere_geometry());
  const std::uint32_t material = add_surface(scene, "mirror", {{1, 0.9f, 0.7f}, 0.5, 0.5});
  const NodeId first = place(scene, root_node, "flake", Transform::scaling(Vec3d(0.5)), sphere, material);
  Flake(scene, sphere, material).grow(first, {}, levels);
  return scene;
}

Scene make_shells(int size) {
  Scene scene = stage("shells", Up::z, {{-6, -60, 35}, {0, 8, -15}, {0, 0, 1}}, {0, 0, -15}, {{-100, -100, 100}});
  const std::uint32_t sphere = add_geometry(scene, "sphere", make_sphere_geometry());
  const NodeId shell = scene.graph.add(root_node, "shell");
  scene.graph.set_material(shell, add_surface(scene, "shell", {{1, 0.8f, 0.4f}, 0.8, 0.2}));
  // Nine turns, a third of them beyond radius 1.
  const int steps = 180 << size;
  for (int i = -steps / 3 * 2; i <= steps / 3; ++i) {
    const double degrees = 9 * 360.0 * i / steps;
    const double radius = std::exp(0.15 * degrees * (std::numbers::pi / 180));
    const Vec3d around = Transform::rotation({0, 0, 1}, degrees).vector({0, 1, 0});
    const Vec3d at(-radius * around.x, radius * around.y, -2 * radius);
    place(scene, shell, "", Transform::translation(at) * Transform::scaling(Vec3d(radius)), sphere);
  }
  return scene;
}

}  // namespace sightline::spd
