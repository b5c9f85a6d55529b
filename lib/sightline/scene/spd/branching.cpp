/// Databases that branch.

#include <array>

#include "sightline/scene/round_meshes.h"
#include "sightline/scene/spd/databases.h"
#include "sightline/scene/spd/stage.h"

namespace sightline::spd {
namespace {

/// Four corners of the cube from -1 to 1, which are those of a tetrahedron.
constexpr std::array<Vec3d, 4> tetra_corners{{{-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {1, 1, 1}}};

/// The branches at the end of a branch, whose length is the unit.
struct Branching {
  double angle;       ///< From the direction of the branch, in degrees.
  double divergence;  ///< Around it.
  double length;
};
constexpr std::array<Branching, 2> branchings{{{40, 90, 0.65}, {25, 230, 0.7}}};
constexpr double trunk_radius = 0.15;
constexpr double taper = 0.67;  ///< Of radii, along each branch. Lengths shrink by other shares.

class Tree {
 public:
  explicit Tree(Scene& scene)
      : scene_(scene),
        cone_(add_geometry(scene, "cone", make_frustum_geometry(taper))),
        sphere_(add_geometry(scene, "sphere", make_sphere_geometry())) {}

  /// Along the node's z from 0 to 1. `radius` is in units of the node.
  void grow(NodeId node, double radius, int levels) {
    place(scene_, node, "branch", Transform::scaling({radius, radius, 1}), cone_);
    place(scene_, node, "end", Transform::translation({0, 0, 1}) * Transform::scaling(Vec3d(taper * radius)), sphere_);
    if (levels == 0) return;
    for (const Branching& next : branchings) {
      const Transform local = Transform::translation({0, 0, 1}) * Transform::scaling(Vec3d(next.length)) *
                              Transform::rotation({0, 0, 1}, next.divergence) *
                              Transform::rotation({1, 0, 0}, next.angle);
      grow(scene_.graph.add(node, "", local), taper * radius / next.length, levels - 1);
    }
  }

 private:
  Scene& scene_;
  std::uint32_t cone_, sphere_;
};

}  // namespace

Scene make_tetra(int levels) {
  // Up is toward the first corner, where his camera has it; the coordinates are left alone.
  Scene scene =
      stage("tetra", Up::y,
            {{1.022846, -3.177154, -2.174512}, {-0.004103, -0.004103, 0.216539}, {-0.816497, -0.816497, 0.816497}},
            {0, 0, 0}, {{1.876066, -18.123936, -5.000422}});
  std::vector<Vec3f> corners(tetra_corners.begin(), tetra_corners.end());
  std::vector<TriangleMesh::Corners> faces{{0, 1, 2}, {3, 2, 1}, {2, 3, 0}, {1, 0, 3}};
  const std::uint32_t tetrahedron = add_geometry(
      scene, "tetrahedron", {std::make_shared<const TriangleMesh>(std::move(corners), std::move(faces)), {}, {}});
  const NodeId first = scene.graph.add(root_node, "tetra");
  scene.graph.set_material(first, add_surface(scene, "red", {{1, 0.2f, 0.2f}}));
  const auto split = [&](auto&& again, NodeId node, int depth) -> void {
    if (depth == 1) {
      scene.graph.set_geometry(node, tetrahedron);
      return;
    }
    for (const Vec3d& corner : tetra_corners) {
      const Transform local = Transform::translation(0.5 * corner) * Transform::scaling(Vec3d(0.5));
      again(again, scene.graph.add(node, "", local), depth - 1);
    }
  };
  split(split, first, levels);
  return scene;
}

Scene make_tree(int levels) {
  Scene scene =
      stage("tree", Up::z, {{4.5, 0.4, 2}, {0, 0, 1.5}, {0, 0, 1}}, {0, 0, 1.5},
            {{-5, 5, 50}, {30, -30, 30}, {-40, -30, 20}, {10, 30, 40}, {-30, 40, 10}, {50, 25, 20}, {-10, -60, 30}});
  const std::uint32_t field =
      add_geometry(scene, "field", make_quad_geometry({50, 50, 0}, {-50, 50, 0}, {-50, -50, 0}, {50, -50, 0}));
  place(scene, root_node, "field", {}, field, add_surface(scene, "grass", {{0.2f, 0.7f, 0.2f}}));
  const NodeId trunk = scene.graph.add(root_node, "tree");
  scene.graph.set_material(trunk, add_surface(scene, "wood", {{0.55f, 0.4f, 0.2f}}));
  Tree(scene).grow(trunk, trunk_radius, levels);
  return scene;
}

}  // namespace sightline::spd
