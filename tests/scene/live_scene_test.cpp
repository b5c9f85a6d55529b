#include "sightline/scene/live_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "sightline/shape/instances.h"
#include "tests/math/exact.h"
#include "tests/scene/random_scene.h"

namespace sightline {
namespace {

using exact::Point;
using exact::Rational;

template <class V>
bool is_same(const V& a, const V& b) {
  if constexpr (std::is_same_v<V, Aabb>) return a == b || (a.is_empty() && b.is_empty());
  if constexpr (std::is_same_v<V, Sphere>) return a.center == b.center && a.radius == b.radius;
  if constexpr (std::is_same_v<V, Cylinder>) {
    return a.center == b.center && a.axis == b.axis && a.radius == b.radius && a.half_length == b.half_length;
  }
}

/// Points of a geometry that its bounds have to hold: vertices, or points on the ball in rational numbers.
std::vector<Point> points_of(const Geometry& geometry) {
  std::vector<Point> points;
  if (const auto* mesh = std::get_if<MeshGeometry>(&geometry.shape)) {
    for (const Vec3f& p : mesh->mesh->positions()) points.push_back(exact::point(p));
    return points;
  }
  const auto& ball = std::get<solid::Sphere>(std::get<SolidTree>(geometry.shape).shape);
  for (int m = -3; m <= 3; ++m) {
    for (int n = -3; n <= 3; ++n) {
      const Rational sum = m * m + n * n, radius(ball.radius);
      const Point way{2 * m / (sum + 1), 2 * n / (sum + 1), (sum - 1) / (sum + 1)};
      points.push_back(exact::plus(exact::point(ball.center), exact::times(radius, way)));
    }
  }
  return points;
}

void expect_held(LiveScene& live, NodeId node, const Point& p) {
  ASSERT_TRUE(exact::holds(live.bounds<Aabb>(node), p));
  ASSERT_TRUE(exact::holds(live.bounds<Sphere>(node), p));
  ASSERT_TRUE(exact::holds(live.bounds<Cylinder>(node), p));
}

TEST(LiveScene, BoundsHoldAllBelow) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    LiveScene live(random_scene(seed, 40));
    const Scene& scene = live.scene();
    for (NodeId node = 0; node < scene.graph.size(); ++node) {
      if (scene.graph.geometry(node) == no_item) continue;
      const Geometry& geometry = scene.geometries[scene.graph.geometry(node)];
      const Affine world = scene.graph.world(node).matrix();
      for (const Point& p : points_of(geometry)) {
        const Point image = exact::Map(world).image(p);
        ASSERT_TRUE(exact::holds(live.own_bounds<Aabb>(node), image));
        ASSERT_TRUE(exact::holds(live.own_bounds<Sphere>(node), image));
        ASSERT_TRUE(exact::holds(live.own_bounds<Cylinder>(node), image));
        for (NodeId above = node; above != no_node; above = scene.graph.parent(above)) expect_held(live, above, image);
      }
      const auto* mesh = std::get_if<MeshGeometry>(&geometry.shape);
      if (mesh == nullptr) continue;
      const Placement placement(world, 0);
      for (const Vec3f& p : mesh->mesh->positions()) expect_held(live, root_node, exact::point(placement.point(p)));
    }
  }
}

/// Asked at random while it changes at random, a scene has the places and bounds of one that was made as it is then.
TEST(LiveScene, FollowsEveryChange) {
  Random random(7);
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    LiveScene live(random_scene(seed, 30));
    for (int i = 0; i < 60; ++i) {
      const NodeId node = random.below(live.graph().size());
      switch (random.below(8)) {
        case 0:
          live.add(node, "", random_place(random), random.below(2) == 0 ? no_item : random.below(5));
          break;
        case 1:
          try {
            live.move(node, random.below(live.graph().size()));
          } catch (const std::invalid_argument&) {
          }
          break;
        case 2:
          live.set_geometry(node, random.below(3) == 0 ? no_item : random.below(5));
          break;
        case 3:
          if (random.below(5) == 0) live.replace_geometry(random.below(4), {"mesh", random_mesh(random)});
          break;
        case 4:
          live.world(node);
          break;
        case 5:
          with_kind(bound_kinds[random.below(3)], [&]<class V>(const V&) { live.bounds<V>(node); });
          break;
        default:
          live.set_local(node, random_place(random));
      }
      if (random.below(6) != 0) continue;
      LiveScene fresh(live.scene());
      const NodeId asked = random.below(live.graph().size());
      ASSERT_EQ(live.world(asked), live.graph().world(asked));
      with_kind(bound_kinds[random.below(3)], [&]<class V>(const V&) {
        ASSERT_TRUE(is_same(live.bounds<V>(asked), fresh.bounds<V>(asked))) << "seed " << seed << ", step " << i;
        ASSERT_TRUE(is_same(live.own_bounds<V>(asked), fresh.own_bounds<V>(asked)));
        ASSERT_TRUE(is_same(live.bounds<V>(root_node), fresh.bounds<V>(root_node)));
      });
    }
  }
}

// ---- What it costs

/// Ten children a node, `levels` deep; a mesh at each leaf. The last node is a leaf.
Scene tree(int levels) {
  Scene scene = random_scene(1, 0);
  std::vector<NodeId> level{root_node};
  for (int i = 0; i < levels; ++i) {
    std::vector<NodeId> next;
    for (const NodeId node : level) {
      for (int k = 0; k < 10; ++k) {
        next.push_back(scene.graph.add(node, "", Transform::translation({double(k), double(i), 0})));
        if (i == levels - 1) scene.graph.set_geometry(next.back(), 0);
      }
    }
    level = std::move(next);
  }
  return scene;
}

TEST(LiveScene, AChangeTouchesAsManyNodesAsItIsDeep) {
  constexpr int levels = 5;
  LiveScene live(tree(levels));
  const NodeId leaf = live.graph().size() - 1;
  ASSERT_EQ(live.graph().size(), 111'111u);
  live.bounds<Aabb>(root_node);
  EXPECT_EQ(live.counters().bounds, 111'111u);
  const LiveScene::Counters before = live.counters();
  live.set_local(leaf, Transform::translation({100, 0, 0}));
  EXPECT_EQ(live.counters().marked - before.marked, levels + 1u);
  EXPECT_EQ(live.counters().bounds, before.bounds);
  EXPECT_GT(live.bounds<Aabb>(root_node).hi.x, 99);
  EXPECT_EQ(live.counters().bounds - before.bounds, levels + 1u);
  EXPECT_EQ(live.counters().worlds - before.worlds, 1u);
  EXPECT_EQ(live.counters().children_read - before.children_read, 10u * levels);
  live.bounds<Aabb>(root_node);
  EXPECT_EQ(live.counters().bounds - before.bounds, levels + 1u);
}

/// L2: the second change finds the way marked, one beside it goes up to where they meet.
TEST(LiveScene, ChangesGoNoWayTwice) {
  LiveScene live(tree(4));
  for (const BoundKind kind : bound_kinds) live.refresh(kind);
  const NodeId leaf = live.graph().size() - 1, sibling = leaf - 1, cousin = leaf - 10;
  std::vector<std::vector<NodeId>> ways;
  std::vector<NodeId> changed;
  const auto subscription = live.subscribe([&](const LiveScene::Bubble& bubble) {
    changed.push_back(bubble.node);
    ways.emplace_back(bubble.way.begin(), bubble.way.end());
  });
  for (const NodeId node : {leaf, leaf, sibling, cousin}) live.set_local(node, Transform::translation({0, 0, 9}));
  EXPECT_EQ(changed, (std::vector{leaf, leaf, sibling, cousin}));
  const NodeId parent = live.graph().parent(leaf), above = live.graph().parent(parent),
               top = live.graph().parent(above);
  EXPECT_EQ(ways[0], (std::vector{leaf, parent, above, top, root_node}));
  EXPECT_EQ(ways[1], std::vector<NodeId>{});
  EXPECT_EQ(ways[2], std::vector{sibling});
  EXPECT_EQ(ways[3], (std::vector{cousin, live.graph().parent(cousin)}));
  live.unsubscribe(subscription);
  live.refresh(BoundKind::box);
  live.set_local(leaf, {});
  EXPECT_EQ(ways.size(), 4u);
}

/// L3: those below a change are not visited before they are asked for.
TEST(LiveScene, AMovedPartIsVisitedWhenAskedFor) {
  LiveScene live(tree(4));
  live.refresh(BoundKind::box);
  const NodeId part = live.graph().first_child(root_node), other = live.graph().next_sibling(part);
  const LiveScene::Counters before = live.counters();
  live.set_local(part, Transform::translation({0, 0, 50}));
  EXPECT_EQ(live.counters().marked - before.marked, 2u);
  EXPECT_EQ(live.counters().worlds, before.worlds);
  live.bounds<Aabb>(other);
  EXPECT_EQ(live.counters().bounds, before.bounds);
  NodeId leaf = part;
  while (live.graph().first_child(leaf) != no_node) leaf = live.graph().first_child(leaf);
  EXPECT_EQ(live.world(leaf), live.graph().world(leaf));
  EXPECT_EQ(live.counters().worlds - before.worlds, 4u);
  EXPECT_GT(live.bounds<Aabb>(part).lo.z, 48);
  EXPECT_EQ(live.counters().worlds - before.worlds, 1111u);
  EXPECT_EQ(live.counters().bounds - before.bounds, 1111u);
}

TEST(LiveScene, MayBeDeepAndWide) {
  Scene deep = random_scene(1, 0);
  NodeId node = root_node;
  for (int i = 0; i < 10'000; ++i) {
    node = deep.graph.add(node, "", Transform::translation({0.125, 0, 0}));
    deep.graph.set_geometry(node, i % 5);
  }
  LiveScene live(std::move(deep));
  for (const BoundKind kind : bound_kinds) live.refresh(kind);
  EXPECT_NEAR(live.bounds<Aabb>(root_node).hi.x, 1250, 2);
  EXPECT_LT(live.bounds<Sphere>(root_node).radius, 640);
  EXPECT_LT(live.bounds<Cylinder>(root_node).radius, 2);
  live.set_local(1, Transform::translation({1000, 0, 0}));
  EXPECT_NEAR(live.bounds<Aabb>(root_node).hi.x, 2250, 2);
  EXPECT_THROW(live.move(1, node), std::invalid_argument);

  Scene wide = random_scene(1, 0);
  for (int i = 0; i < 100'000; ++i) {
    wide.graph.set_geometry(wide.graph.add(root_node, "", Transform::translation({0, 0.01 * i, 0})), 4);
  }
  LiveScene broad(std::move(wide));
  for (const BoundKind kind : bound_kinds) broad.refresh(kind);
  EXPECT_NEAR(broad.bounds<Aabb>(root_node).hi.y, 1000.5, 0.1);
  EXPECT_LT(broad.bounds<Sphere>(root_node).radius, 502);
  EXPECT_LT(broad.bounds<Cylinder>(root_node).radius, 1);
}

TEST(LiveScene, BoundsOfSpheresDoNotGrowFromLevelToLevel) {
  LiveScene live(tree(4));
  const Aabb& box = live.bounds<Aabb>(root_node);
  EXPECT_LE(live.bounds<Sphere>(root_node).radius, ball_around(box).radius);
}

TEST(LiveScene, HoldsWhatHasNoBoundsByEverything) {
  Scene scene = random_scene(3, 10);
  scene.geometries.push_back({"ground", SolidTree(solid::HalfSpace{{0, 1, 0}, 0})});
  LiveScene live(std::move(scene));
  const NodeId ground = live.add(root_node, "ground", {}, 5), empty = live.add(root_node, "empty");
  EXPECT_TRUE(is_unbounded(live.bounds<Aabb>(root_node)));
  EXPECT_TRUE(is_unbounded(live.bounds<Sphere>(root_node)));
  EXPECT_TRUE(is_unbounded(live.bounds<Cylinder>(ground)));
  EXPECT_TRUE(is_nothing(live.bounds<Cylinder>(empty)));
  live.set_geometry(ground, no_item);
  EXPECT_FALSE(is_unbounded(live.bounds<Sphere>(root_node)));
}

TEST(LiveScene, RefusesByName) {
  const auto expect_refused = [](const auto& act, const std::string& says) {
    try {
      act();
      FAIL() << "expected a refusal that says " << says;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  };
  Scene scene;
  const NodeId person = scene.graph.add(root_node, "person"), arm = scene.graph.add(person, "arm");
  scene.graph.set_geometry(arm, 3);
  expect_refused([&] { LiveScene{scene}; }, "/person/arm");
  scene.graph.set_geometry(arm, no_item);
  LiveScene live(scene);
  expect_refused([&] { live.set_geometry(person, 0); }, "/person");
  live.set_local(person, Transform::scaling(Vec3d(1e200)));
  live.set_local(arm, Transform::scaling(Vec3d(1e200)));
  expect_refused([&] { live.world(arm); }, "/person/arm");
  live.set_local(arm, Transform::scaling(Vec3d(1e-200)));  // and goes on
  EXPECT_EQ(live.world(arm), live.graph().world(arm));
  expect_refused([&] { live.apply(std::vector<NodePose>{{77, {}}}); }, "77");
}

}  // namespace
}  // namespace sightline
