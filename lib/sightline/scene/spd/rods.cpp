/// Databases of cylinders with spheres at their ends.

#include <array>
#include <cmath>
#include <numbers>

#include "sightline/scene/round_meshes.h"
#include "sightline/scene/spd/databases.h"
#include "sightline/scene/spd/stage.h"

namespace sightline::spd {
namespace {

struct Parts {
  std::uint32_t sphere, cylinder;
};

Parts add_parts(Scene& scene) {
  return {add_geometry(scene, "sphere", make_sphere_geometry()),
          add_geometry(scene, "cylinder", make_frustum_geometry())};
}

Transform ball(const Vec3d& center, double radius) {
  return Transform::translation(center) * Transform::scaling(Vec3d(radius));
}

constexpr std::array<Vec3d, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

}  // namespace

Scene make_rings(int size) {
  constexpr double radius = 0.07412;
  const double distance = 1 / std::sin(std::numbers::pi / 8);
  const Vec3d eye(-1, -distance, 0.5);
  Scene scene = stage("rings", Up::z, {eye, eye + Vec3d(0, 1, 0), {0, 0, 1}}, {0, distance * (size + 1) / 2, 0},
                      {{3, -distance, 3}, {-4, -distance, 1}, {2, -distance, -4}});
  const double depth = distance * (size + 1);
  const double half = 1.01 * (depth - eye.y) * std::tan(std::numbers::pi / 8);  // a little more than the camera sees
  const auto corner = [&](int x, int z) { return Vec3f(Vec3d(eye.x + x * half, depth, eye.z + z * half)); };
  const std::uint32_t wall =
      add_geometry(scene, "wall", make_quad_geometry(corner(1, 1), corner(-1, 1), corner(-1, -1), corner(1, -1)));
  place(scene, root_node, "wall", {}, wall, add_surface(scene, "wall", {{1, 1, 1}}));

  const Parts parts = add_parts(scene);
  std::array<Vec3d, 5> corners;
  for (std::size_t i = 0; i < 5; ++i) {
    corners[i] = Transform::rotation({0, 0, 1}, 72.0 * static_cast<double>(i)).vector({1 / (1 + radius), 0, 0});
  }
  // One ring lies flat, the others are tilted as much as two faces of a dodecahedron.
  const double tilt = 2 * std::acos(0.5 / std::sin(std::numbers::pi / 5)) * (180 / std::numbers::pi);
  constexpr std::array<Color, 6> colors{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}}};
  std::array<Transform, 6> turns;
  std::array<std::uint32_t, 6> materials;
  for (std::size_t ring = 0; ring < 6; ++ring) {
    if (ring > 0) {
      turns[ring] = Transform::rotation({0, 0, 1}, 36 * (2 * static_cast<double>(ring) - 1)) *
                    Transform::rotation({1, 0, 0}, tilt);
    }
    materials[ring] = add_surface(scene, "ring", {colors[ring], 0.5, 0.2});
  }
  for (int layer = 0; layer < size; ++layer) {
    for (int z = -layer; z <= layer; z += 2) {
      for (int x = -layer; x <= layer; x += 2) {
        const NodeId object = scene.graph.add(root_node, "", Transform::translation({x, distance * (layer + 1), z}));
        for (std::size_t i = 0; i < 6; ++i) {
          const NodeId ring = scene.graph.add(object, "", turns[i]);
          scene.graph.set_material(ring, materials[i]);
          for (std::size_t k = 0; k < 5; ++k) {
            place(scene, ring, "", stretch_between(corners[k], corners[(k + 4) % 5], radius), parts.cylinder);
            place(scene, ring, "", ball(corners[k], radius), parts.sphere);
          }
        }
      }
    }
  }
  return scene;
}

Scene make_lattice(int size) {
  const double cell = 1.0 / size, ball_radius = cell / 4, rod_radius = cell / 16;
  // Rods end within the spheres.
  const double inset = 0.99 * ball_radius * (1 - std::sqrt(rod_radius / ball_radius));
  const double middle = (size / 2 + 0.5) * cell;
  Scene scene = stage("lattice", Up::y, {{middle, 1, 1 - cell / 2}, {middle, -1, -1 - cell / 2}, {0.2, 1, 0}, 60},
                      {0.5, 0.5, 0.5},
                      {{2, 0.5, 0.5}, {-1, 0.5, 0.5}, {0.5, 2, 0.5}, {0.5, -1, 0.5}, {0.5, 0.5, 2}, {0.5, 0.5, -1}});
  const Parts parts = add_parts(scene);
  const std::uint32_t mirror = add_surface(scene, "mirror", {{0.9f, 0.9f, 0.9f}, 0.5, 0.5});
  std::array<std::uint32_t, 3> rods;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rods[axis] = add_surface(scene, "rod", {Color(0.1f) + 0.8f * Color(axes[axis]), 0.99});
  }
  for (int x = 0; x <= size; ++x) {
    for (int y = 0; y <= size; ++y) {
      for (int z = 0; z <= size; ++z) {
        const NodeId node = scene.graph.add(root_node, "", Transform::translation(Vec3d(x, y, z) * cell));
        place(scene, node, "", Transform::scaling(Vec3d(ball_radius)), parts.sphere, mirror);
        const std::array<int, 3> place_of{x, y, z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if (place_of[axis] == size) continue;
          place(scene, node, "", stretch_between(inset * axes[axis], (cell - inset) * axes[axis], rod_radius),
                parts.cylinder, rods[axis]);
        }
      }
    }
  }
  return scene;
}

Scene make_jacks(int levels) {
  Scene scene = stage("jacks", Up::y, {{0, 0, -8}, {0, 0, 0}, {0, 1, 0}, 25}, {0, 0, 0}, {{-10, 3, -20}});
  const Parts parts = add_parts(scene);
  const NodeId all =
      scene.graph.add(root_node, "jacks", Transform::rotation({1, 0, 0}, -30) * Transform::rotation({0, 1, 0}, -20));
  scene.graph.set_material(all, add_surface(scene, "pink", {{0.737f, 0.561f, 0.561f}, 0.7, 0.7}));
  const auto add_jack = [&](NodeId node) {
    const NodeId jack = scene.graph.add(node, "jack", Transform::scaling(Vec3d(0.75)));  // so that they never touch
    for (const Vec3d& axis : axes) place(scene, jack, "", stretch_between(-axis, axis, 0.1), parts.cylinder);
    for (const double side : {1.0, -1.0}) {
      for (const Vec3d& axis : axes) place(scene, jack, "", ball(side * axis, 0.2), parts.sphere);
    }
  };
  const auto grow = [&](auto&& again, NodeId node, int depth) -> void {
    add_jack(node);
    if (depth == 1) return;
    for (int octant = 0; octant < 8; ++octant) {
      const Vec3d center(octant & 4 ? 0.5 : -0.5, octant & 2 ? 0.5 : -0.5, octant & 1 ? 0.5 : -0.5);
      again(again, scene.graph.add(node, "", ball(center, 0.5)), depth - 1);
    }
  };
  grow(grow, all, levels);
  return scene;
}

}  // namespace sightline::spd
