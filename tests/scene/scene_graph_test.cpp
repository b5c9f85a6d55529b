#include "sightline/scene/scene_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "sightline/math/random.h"

namespace sightline {
namespace {

Transform random_transform(Random& random) {
  const auto number = [&] { return 2 * random.uniform_double() - 1; };
  return Transform::translation({number(), number(), number()}) *
         Transform::rotation(Vec3d(number(), number(), 1), 360 * number()) * Transform::scaling(Vec3d(0.5, -1, 2));
}

TEST(SceneGraph, AFingerIsPlacedByTheProductOfItsAncestors) {
  Random random(1);
  SceneGraph graph;
  Transform product;
  NodeId node = root_node;
  for (const char* name : {"person", "torso", "arm", "hand", "finger"}) {
    const Transform local = random_transform(random);
    node = graph.add(node, name, local);
    product = product * local;
    EXPECT_EQ(graph.world(node), product);
  }
  EXPECT_EQ(graph.path(node), "/person/torso/arm/hand/finger");
  EXPECT_EQ(graph.find("/person/torso/arm/hand/finger"), node);
}

TEST(SceneGraph, PathsLeadBack) {
  SceneGraph graph;
  const NodeId a = graph.add(root_node, "a"), b = graph.add(a, ""), c = graph.add(b, "c"), twin = graph.add(a, "");
  EXPECT_EQ(graph.path(c), "/a/2/c");
  for (const NodeId node : {root_node, a, b, c, twin}) EXPECT_EQ(graph.find(graph.path(node)), node);
  for (const char* none : {"/b", "a", "/a/", "//", "/a//c", "/a/7", "/a/2/c/d"})
    EXPECT_EQ(graph.find(none), no_node) << none;
}

/// Against lists of children, under random changes.
TEST(SceneGraph, MovesLikeLists) {
  Random random(2);
  SceneGraph graph;
  std::vector<std::vector<NodeId>> children(1);
  std::vector<NodeId> parents{no_node};
  const auto is_below = [&](NodeId node, NodeId above) {
    while (node != no_node && node != above) node = parents[node];
    return node == above;
  };
  int refused = 0;
  for (int i = 0; i < 5000; ++i) {
    if (random.below(4) == 0) {
      const NodeId parent = random.below(graph.size());
      children[parent].push_back(graph.add(parent, "", random_transform(random)));
      children.emplace_back();
      parents.push_back(parent);
      continue;
    }
    const NodeId node = random.below(graph.size()), parent = random.below(graph.size());
    if (node == root_node || is_below(parent, node)) {  // G2
      ASSERT_THROW(graph.move(node, parent), std::invalid_argument);
      ++refused;
      continue;
    }
    graph.move(node, parent);
    std::erase(children[parents[node]], node);
    children[parent].push_back(node);
    parents[node] = parent;
  }
  EXPECT_GT(refused, 50);
  for (NodeId node = 0; node < graph.size(); ++node) {
    EXPECT_EQ(graph.parent(node), parents[node]);
    std::vector<NodeId> found;
    for (NodeId child = graph.first_child(node); child != no_node; child = graph.next_sibling(child))
      found.push_back(child);
    ASSERT_EQ(found, children[node]);
  }
  std::vector<NodeId> order, expected;
  graph.for_each([&](NodeId node, const Transform& world) {
    order.push_back(node);
    ASSERT_EQ(world, graph.world(node)) << graph.path(node);
  });
  std::vector<NodeId> waiting{root_node};
  while (!waiting.empty()) {
    const NodeId node = waiting.back();
    waiting.pop_back();
    expected.push_back(node);
    waiting.insert(waiting.end(), children[node].rbegin(), children[node].rend());
  }
  EXPECT_EQ(order, expected);
  const NodeId part = children[root_node].front();
  graph.for_each(
      [&](NodeId node, const Transform& world) { ASSERT_TRUE(is_below(node, part) && world == graph.world(node)); },
      part);
}

/// Against the definition, node by node.
TEST(SceneGraph, HidesAllBelowWhatIsHidden) {
  Random random(5);
  SceneGraph graph;
  for (int i = 0; i < 400; ++i) graph.add(random.below(graph.size()), "", random_transform(random));
  EXPECT_TRUE(graph.is_visible(root_node) && graph.is_visible(400));
  for (int i = 0; i < 40; ++i) graph.set_visible(1 + random.below(graph.size() - 1), random.below(4) == 0);
  std::vector<NodeId> order, expected;
  graph.for_each([&](NodeId node, const Transform&) {
    bool is_shown = true;
    for (NodeId above = node; above != no_node; above = graph.parent(above)) is_shown &= graph.is_visible(above);
    EXPECT_EQ(graph.is_shown(node), is_shown);
    if (is_shown) expected.push_back(node);
  });
  graph.for_each_shown([&](NodeId node, const Transform& world) {
    order.push_back(node);
    EXPECT_EQ(world, graph.world(node));
  });
  EXPECT_EQ(order, expected);
  EXPECT_GT(order.size(), 20u);
  EXPECT_LT(order.size(), 380u);
  graph.set_visible(root_node, false);
  graph.for_each_shown([](NodeId, const Transform&) { FAIL() << "the root is hidden"; });
  graph.set_visible(root_node, true);
  EXPECT_TRUE(graph.is_shown(root_node));
}

TEST(SceneGraph, RefusesCyclesByName) {
  SceneGraph graph;
  const NodeId a = graph.add(root_node, "a"), b = graph.add(a, "b");
  for (const NodeId parent : {a, b}) {
    try {
      graph.move(a, parent);
      FAIL() << "expected a cycle to be refused";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("not below /a, found " + graph.path(parent)), std::string::npos)
          << error.what();
    }
  }
  EXPECT_THROW(graph.move(root_node, b), std::invalid_argument);
  EXPECT_EQ(graph.parent(b), a);
}

TEST(SceneGraph, MayBeDeep) {
  constexpr int depth = 10'000;
  SceneGraph graph;
  NodeId node = root_node;
  for (int i = 0; i < depth; ++i) node = graph.add(node, "", Transform::translation({1, 0, 0}));
  EXPECT_EQ(graph.world(node).point(Vec3d(0)), Vec3d(depth, 0, 0));
  int count = 0;
  graph.for_each([&](NodeId at, const Transform& world) {
    ++count;
    ASSERT_EQ(world.point(Vec3d(0)).x, at);
  });
  EXPECT_EQ(count, depth + 1);
  EXPECT_THROW(graph.move(1, node), std::invalid_argument);
  EXPECT_EQ(graph.find(graph.path(node)), node);
}

TEST(SceneGraph, MayBeWide) {
  constexpr NodeId width = 100'000;
  SceneGraph graph;
  for (NodeId i = 1; i <= width; ++i) graph.add(root_node, "", Transform::translation(Vec3d(i)));
  NodeId expected = 0;
  graph.for_each([&](NodeId node, const Transform& world) {
    ASSERT_EQ(node, expected++);
    ASSERT_EQ(world.point(Vec3d(0)).y, node);
  });
  EXPECT_EQ(expected, width + 1);
  graph.move(width, 1);
  graph.move(2, 1);
  EXPECT_EQ(graph.next_sibling(1), 3u);
  EXPECT_EQ(graph.next_sibling(width - 1), no_node);
  const NodeId last = graph.add(root_node, "");
  EXPECT_EQ(graph.next_sibling(width - 1), last);
}

}  // namespace
}  // namespace sightline
