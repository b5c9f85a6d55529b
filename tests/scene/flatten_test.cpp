#include "sightline/scene/flatten.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <stdexcept>
#include <string>

#include "tests/scene/closed.h"

namespace sightline {
namespace {

using Rational = boost::multiprecision::cpp_rational;

std::shared_ptr<const TriangleMesh> make_tetrahedron() {
  const std::vector<Vec3f> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<TriangleMesh::Corners> triangles{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return std::make_shared<const TriangleMesh>(corners, triangles);
}

Scene scene_of(std::shared_ptr<const TriangleMesh> mesh) {
  Scene scene;
  scene.geometries.push_back({"mesh", MeshGeometry{std::move(mesh), {}, {}}});
  return scene;
}

NodeId add(Scene& scene, NodeId parent, const std::string& name, const Transform& local, std::uint32_t geometry = 0) {
  const NodeId node = scene.graph.add(parent, name, local);
  scene.graph.set_geometry(node, geometry);
  return node;
}

std::string refusal(const Scene& scene) {
  try {
    instances_of(scene);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "placed";
}

TEST(Flatten, EmptyScene) {
  const SceneInstances placed = instances_of(Scene());
  EXPECT_EQ(placed.instances.size(), 0u);
  EXPECT_EQ(placed.instances.flattened().size(), 0u);
  EXPECT_TRUE(placed.origins.empty());
}

TEST(Flatten, LeavesOutMeshesWithoutTriangles) {
  Scene scene = scene_of(std::make_shared<const TriangleMesh>());
  add(scene, root_node, "nothing", {});
  EXPECT_EQ(instances_of(scene).instances.size(), 0u);
}

TEST(Flatten, PlacesSolidsByTheProductOfTransforms) {
  Scene scene;
  scene.geometries.push_back({"ball", SolidTree(solid::Sphere{{1, 0, 0}, 1})});
  const NodeId above = scene.graph.add(root_node, "above", Transform::translation({3, 4, 5}));
  add(scene, above, "ball", Transform::rotation({0, 0, 1}, 90) * Transform::scaling({2, 2, 2}));
  const SceneSolids placed = solids_of(scene);
  ASSERT_EQ(placed.solids.size(), 1u);
  const Aabb bounds = placed.solids[0]->bounds();
  EXPECT_TRUE(bounds.contains(Aabb{{1, 4, 3}, {5, 8, 7}}));  // around (3, 6, 5)
  EXPECT_TRUE((Aabb{{0.999f, 3.999f, 2.999f}, {5.001f, 8.001f, 7.001f}}).contains(bounds));
}

TEST(Flatten, LeavesOutWhatIsHidden) {
  Scene scene = scene_of(make_tetrahedron());
  const NodeId a = add(scene, root_node, "a", {}), b = add(scene, a, "b", {}), c = add(scene, root_node, "c", {});
  scene.graph.set_visible(a, false);
  const SceneInstances placed = instances_of(scene);
  ASSERT_EQ(placed.instances.size(), 1u);
  EXPECT_EQ(placed.origins[0].node, c);
  scene.graph.set_visible(a, true);
  scene.graph.set_visible(b, false);
  EXPECT_EQ(instances_of(scene).instances.size(), 2u);
}

TEST(Flatten, NamesNodesDepthFirstWithTheNearestMaterial) {
  Scene scene = scene_of(make_tetrahedron());
  scene.geometries.push_back(scene.geometries[0]);  // the same mesh
  scene.geometries.push_back({"unused", MeshGeometry{make_tetrahedron(), {}, {}}});
  scene.materials.resize(2);
  scene.geometries.push_back({"solid", SolidTree()});
  SceneGraph& graph = scene.graph;
  const NodeId left = add(scene, root_node, "left", {});
  const NodeId right = add(scene, root_node, "right", {}, no_item);
  const NodeId leaf = add(scene, left, "leaf", {}, 1);
  const NodeId solid = add(scene, right, "solid", {}, 3);
  const NodeId far = add(scene, solid, "far", {});
  graph.set_material(root_node, 1);
  graph.set_material(left, 0);
  graph.move(left, right);  // behind the solid and its child, and below a node of a greater number

  const SceneInstances placed = instances_of(scene);
  EXPECT_EQ(placed.solids_left_out, 1u);
  ASSERT_EQ(placed.origins.size(), 3u);
  ASSERT_EQ(placed.instances.size(), 3u);
  EXPECT_EQ(placed.instances.meshes().size(), 1u);
  const NodeId nodes[] = {far, left, leaf};
  const std::uint32_t materials[] = {1, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(placed.origins[i].node, nodes[i]);
    EXPECT_EQ(placed.origins[i].material, materials[i]);
  }
}

TEST(Flatten, RefusesByPathWhatFloatCannotPlace) {
  const auto with = [](const Transform& outer, const Transform& inner) {
    Scene scene = scene_of(make_tetrahedron());
    const NodeId arm = scene.graph.add(root_node, "arm", outer);
    add(scene, arm, "hand", inner);
    return refusal(scene);
  };
  const Transform tiny = Transform::scaling(Vec3d(1e-30)), flat = Transform::scaling({1, 1e-300, 1}),
                  huge = Transform::scaling(Vec3d(1e30)), far = Transform::translation(Vec3d(3e38));
  EXPECT_EQ(with(tiny, tiny), "node /arm/hand: expected a matrix that can be inverted in float");
  EXPECT_EQ(with({}, flat), "node /arm/hand: expected a matrix that can be inverted in float");
  EXPECT_EQ(with(flat, flat), "node /arm/hand: expected a matrix that can be inverted in float");
  EXPECT_EQ(with(huge, huge), "node /arm/hand: expected a matrix of numbers that are finite in float");
  EXPECT_EQ(with(Transform::scaling(Vec3d(1e300)), Transform::scaling(Vec3d(1e300))),
            "node /arm/hand: expected a matrix of numbers that are finite in float");
  EXPECT_EQ(with(far, Transform::scaling(Vec3d(1e38))), "node /arm/hand: expected vertices within the range of float");
  EXPECT_EQ(with(tiny, huge), "placed");
}

/// Whole numbers and powers of two stay small here, so that nothing is rounded and places are exact.
RC_GTEST_PROP(Flatten, PlacesVerticesByTheProductOfTransforms, ()) {
  using Matrix = std::array<std::array<Rational, 4>, 4>;
  Scene scene = scene_of(make_tetrahedron());
  Matrix product{};
  for (std::size_t i = 0; i < 4; ++i) product[i][i] = 1;
  NodeId node = root_node;
  const int steps = *rc::gen::inRange(0, 6);
  for (int step = 0; step < steps; ++step) {
    Matrix local{};
    local[3][3] = 1;
    const auto whole = [] { return *rc::gen::inRange(-4, 5); };
    Affine map;
    do {
      for (auto& row : map.rows) {
        for (double& number : row) number = whole();
      }
    } while (determinant_sign(map) == 0);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 4; ++k) local[i][k] = Rational(map.rows[i][k]);
    }
    Matrix next{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t j = 0; j < 4; ++j) next[i][k] += product[i][j] * local[j][k];
      }
    }
    product = next;
    node = scene.graph.add(node, "", Transform::of(map));
  }
  scene.graph.set_geometry(node, 0);

  const TriangleMesh placed = instances_of(scene).instances.flattened();
  const auto mesh = make_tetrahedron();
  RC_ASSERT(placed.size() == mesh->size());
  RC_ASSERT(volume(placed) > 0);  // outside stays outside, mirrored or not
  for (std::size_t i = 0; i < placed.positions().size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Rational expected = product[axis][3];
      for (std::size_t k = 0; k < 3; ++k) {
        expected += product[axis][k] * Rational(mesh->positions()[i][static_cast<int>(k)]);
      }
      RC_ASSERT(Rational(placed.positions()[i][static_cast<int>(axis)]) == expected);
    }
  }
}

}  // namespace
}  // namespace sightline
