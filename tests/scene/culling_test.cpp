#include "sightline/scene/culling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sightline/math/rounding.h"
#include "sightline/scene/collision.h"
#include "tests/math/exact.h"
#include "tests/scene/random_scene.h"

namespace sightline {
namespace {

using exact::Point;
using exact::Rational;

/// Points of the triangles of a node, as the world has them, in rational numbers: sums of vertices with weights.
Point point_of(const Scene& scene, NodeId node, Random& random) {
  const auto& mesh = *std::get<MeshGeometry>(scene.geometries[scene.graph.geometry(node)].shape).mesh;
  const Triangle t = mesh[random.below(mesh.size())];
  const Rational u(random.below(9), 8), v = (1 - u) * Rational(random.below(9), 8);
  const Point a = exact::point(t.a), b = exact::point(t.b), c = exact::point(t.c);
  const Point local = exact::plus(exact::plus(exact::times(1 - u - v, a), exact::times(u, b)), exact::times(v, c));
  return exact::Map(scene.graph.world(node).matrix()).image(local);
}

Vec3d rounded(const Point& p) { return {double(p[0]), double(p[1]), double(p[2])}; }

bool holds(const std::vector<NodeId>& nodes, NodeId node) {
  return std::binary_search(nodes.begin(), nodes.end(), node);
}

std::vector<NodeId> meshes_of(const LiveScene& live) {
  std::vector<NodeId> nodes;
  for (NodeId node = 0; node < live.graph().size(); ++node) {
    if (live.graph().geometry(node) < 4) nodes.push_back(node);
  }
  return nodes;
}

/// Each ray is aimed at a point of a triangle, past which double passes at 2^-50 of the distance, less than what bounds
/// are rounded outward by.
TEST(Culling, KeepsWhatRaysMeet) {
  Random random(1);
  std::size_t kept = 0, all = 0, tests = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    LiveScene live(random_scene(seed, 60));
    const std::vector<NodeId> meshes = meshes_of(live);
    for (int i = 0; i < 60; ++i) {
      const NodeId node = meshes[random.below(static_cast<std::uint32_t>(meshes.size()))];
      Ray<double> ray;
      ray.origin = 20.0 * (Vec3d(random.uniform_double(), random.uniform_double(), random.uniform_double()) - 0.5);
      ray.direction = rounded(point_of(live.scene(), node, random)) - ray.origin;
      for (const BoundKind kind : bound_kinds) {
        const Culled culled = cull(live, VolumeRay(ray), kind);
        ASSERT_TRUE(holds(culled.nodes, node)) << name_of(kind);
        kept += culled.nodes.size();
        all += live.graph().size();
        tests += culled.tests;
      }
    }
  }
  EXPECT_LT(kept, all / 3);
  EXPECT_LT(tests, all);
}

TEST(Culling, KeepsWhatACameraSees) {
  Random random(2);
  std::size_t kept = 0, all = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    LiveScene live(random_scene(seed, 60));
    for (int i = 0; i < 20; ++i) {
      const Vec3d eye = 30.0 * (Vec3d(random.uniform_double(), random.uniform_double(), random.uniform_double()) - 0.5);
      const Camera camera = Camera::looking_at(eye, Vec3d(1, 2, 0), {0, 1, 0}, 5 + 60 * random.uniform_double(), 16, 9);
      const ViewFrustum frustum(camera);
      std::array<Culled, 3> culled;
      for (const BoundKind kind : bound_kinds) {
        culled[static_cast<std::size_t>(kind)] = cull(live, frustum, kind);
        kept += culled[static_cast<std::size_t>(kind)].nodes.size();
        all += live.graph().size();
      }
      for (const NodeId node : meshes_of(live)) {
        const Vec3d way = rounded(point_of(live.scene(), node, random)) - eye;
        const double ahead = glm::dot(way, camera.forward);
        const double x = glm::dot(way, camera.right) / glm::dot(camera.right, camera.right) / ahead;
        const double y = glm::dot(way, camera.up) / glm::dot(camera.up, camera.up) / ahead;
        if (!(ahead > 0 && std::fabs(x) < 0.999 && std::fabs(y) < 0.999)) continue;
        for (const Culled& each : culled) ASSERT_TRUE(holds(each.nodes, node));
      }
    }
  }
  EXPECT_LT(kept, all / 2);
}

/// F1: tiny balls on the rays of a picture's pixels, near and far.
TEST(ViewFrustum, SeesAllRaysOfThePicture) {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    const auto number = [&] { return 100 * (2 * random.uniform_double() - 1); };
    const Camera camera =
        Camera::looking_at({number(), number(), number()}, {number(), number(), number()}, {0, 1, 0},
                           1 + 170 * random.uniform_double(), 1 + random.below(3000), 1 + random.below(3000));
    const ViewFrustum frustum(camera);
    for (int i = 0; i < 50; ++i) {
      const int x = i % 2 == 0 ? 0 : camera.width - 1, y = i % 4 < 2 ? 0 : camera.height - 1;
      const Ray<float> ray = camera.ray(x, y);
      const Rational t(std::ldexp(random.uniform_double(), static_cast<int>(random.below(30)) - 5));
      const Point p = exact::plus(exact::point(ray.origin), exact::times(t, exact::point(ray.direction)));
      const Vec3f center(rounded(p));
      const Vec3d off = glm::abs(rounded(exact::minus(p, exact::point(center))));
      const auto radius = static_cast<float>((off.x + off.y + off.z) * 1.001);
      const Sphere ball{center, radius};
      ASSERT_TRUE(exact::holds(ball, p));
      ASSERT_TRUE(frustum.may_see(ball));
      Aabb box;
      for (int axis = 0; axis < 3; ++axis) {
        box.lo[axis] = next_down(center[axis] - radius);
        box.hi[axis] = next_up(center[axis] + radius);
      }
      ASSERT_TRUE(exact::holds(box, p));
      ASSERT_TRUE(frustum.may_see(box));
      ASSERT_TRUE(frustum.may_see(Cylinder{center, Vec3f(0, 0, 1), radius, radius}));
    }
    const Vec3f behind(camera.eye - 10.0 * camera.forward);
    EXPECT_FALSE(frustum.may_see(Sphere{behind, 1}));
  }
}

/// Against all pairs: boxes exactly, others no more than their own bounds say and no less than the geometries do.
TEST(Collision, FindsAllOverlaps) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    LiveScene live(random_scene(seed, 120));
    if (seed % 3 == 0) {  // wide
      for (NodeId node = 1; node < live.graph().size(); ++node) live.move(node, root_node);
    }
    std::set<std::pair<NodeId, NodeId>> boxes, spheres, cylinders;
    for (NodeId a = 0; a < live.graph().size(); ++a) {
      for (NodeId b = a + 1; b < live.graph().size(); ++b) {
        if (live.graph().geometry(a) == no_item || live.graph().geometry(b) == no_item) continue;
        const Aabb box = live.own_bounds<Aabb>(a);
        if (may_overlap(box, live.own_bounds<Aabb>(b))) boxes.emplace(a, b);
        const Sphere sphere = live.own_bounds<Sphere>(a);
        if (may_overlap(sphere, live.own_bounds<Sphere>(b))) spheres.emplace(a, b);
        const Cylinder cylinder = live.own_bounds<Cylinder>(a);
        if (may_overlap(cylinder, live.own_bounds<Cylinder>(b))) cylinders.emplace(a, b);
      }
    }
    const auto by_boxes = find_overlaps(live, BoundKind::box), by_spheres = find_overlaps(live, BoundKind::sphere),
               by_cylinders = find_overlaps(live, BoundKind::cylinder);
    EXPECT_EQ(by_boxes.pairs, std::vector(boxes.begin(), boxes.end()));
    EXPECT_TRUE(std::includes(spheres.begin(), spheres.end(), by_spheres.pairs.begin(), by_spheres.pairs.end()));
    EXPECT_TRUE(
        std::includes(cylinders.begin(), cylinders.end(), by_cylinders.pairs.begin(), by_cylinders.pairs.end()));
  }
}

/// Balls in rational numbers: those that overlap are found by every kind.
TEST(Collision, BallsThatOverlapAreFound) {
  Random random(5);
  Scene scene;
  scene.geometries.push_back({"ball", SolidTree(solid::Sphere{{0, 0, 0}, 0.5})});
  for (int i = 0; i < 300; ++i) {
    const auto number = [&] { return (static_cast<double>(random.below(17)) - 8) / 4; };
    const NodeId node =
        scene.graph.add(random.below(scene.graph.size()), "", Transform::translation({number(), number(), number()}));
    scene.graph.set_geometry(node, 0);
  }
  LiveScene live(std::move(scene));
  std::array<Overlaps, 3> found;
  for (const BoundKind kind : bound_kinds) found[static_cast<std::size_t>(kind)] = find_overlaps(live, kind);
  int overlapping = 0;
  for (NodeId a = 1; a < live.graph().size(); ++a) {
    for (NodeId b = a + 1; b < live.graph().size(); ++b) {
      const Vec3d way = live.world(a).point(Vec3d(0)) - live.graph().world(b).point(Vec3d(0));  // multiples of 1/4
      if (glm::dot(way, way) > 1) continue;
      ++overlapping;
      for (const Overlaps& each : found) {
        ASSERT_TRUE(std::binary_search(each.pairs.begin(), each.pairs.end(), std::pair(a, b)));
      }
    }
  }
  EXPECT_GT(overlapping, 100);
}

TEST(Collision, DoesNotTakeTheSquareOfManyChildren) {
  Scene scene;
  scene.geometries.push_back({"ball", SolidTree(solid::Sphere{{0, 0, 0}, 0.5})});
  constexpr int count = 100'000;
  for (int i = 0; i < count; ++i) {
    scene.graph.set_geometry(scene.graph.add(root_node, "", Transform::translation({0.75 * i, 0, 0})), 0);
  }
  LiveScene live(std::move(scene));
  const Overlaps found = find_overlaps(live, BoundKind::sphere);
  EXPECT_EQ(found.pairs.size(), count - 1u);
  EXPECT_LT(found.tests, 2u * count);
}

/// What is hidden is as if its geometry were not there.
TEST(Culling, LeavesOutWhatIsHidden) {
  LiveScene live(random_scene(3, 60));
  const VolumeRay ray(Ray<double>{Vec3d(-20, 0.1, 0.2), Vec3d(1, 0, 0)});
  const std::vector<NodeId> all = cull(live, ray, BoundKind::box).nodes;
  ASSERT_GT(all.size(), 2u);
  live.set_visible(all.front(), false);
  std::vector<NodeId> expected;
  for (const NodeId node : all) {
    if (live.graph().is_shown(node)) expected.push_back(node);
  }
  EXPECT_LT(expected.size(), all.size());
  EXPECT_EQ(cull(live, ray, BoundKind::box).nodes, expected);
  live.set_visible(all.front(), true);
  EXPECT_EQ(cull(live, ray, BoundKind::box).nodes, all);
}

}  // namespace
}  // namespace sightline
