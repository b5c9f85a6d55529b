#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sightline/math/random.h"
#include "sightline/scene/levels.h"
#include "viz/graph/graph_scene.h"
#include "viz/graph/tree_rows.h"

namespace sightline::viz {
namespace {

SceneGraph random_tree(std::uint64_t seed, NodeId size) {
  Random random(seed);
  SceneGraph graph;
  while (graph.size() < size) {
    const auto share = std::pow(random.uniform_double(), 1 + static_cast<double>(seed % 3));
    graph.add(static_cast<NodeId>(share * graph.size()), "n" + std::to_string(graph.size()));
  }
  return graph;
}

SceneGraph chain(NodeId size) {
  SceneGraph graph;
  for (NodeId node = 1; node < size; ++node) graph.add(node - 1, "link");
  return graph;
}

/// T1 and T2, and that rows hang together.
void expect_lawful(const SceneGraph& graph, NodeId focus, std::size_t most) {
  const TreeShape shape(graph);
  const std::vector<TreeRow> rows = tree_rows(graph, shape, focus, most);
  ASSERT_LE(rows.size(), most);
  ASSERT_EQ(rows.front().node, root_node);
  std::set<NodeId> shown;
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TreeRow& row = rows[i];
    hidden += row.hidden;
    if (row.node != no_node) {
      ASSERT_TRUE(shown.insert(row.node).second);
    }
    if (row.node == no_node) {
      ASSERT_GT(row.hidden, 0u);
    }
    ASSERT_EQ(row.parent < 0, i == 0);
    if (i == 0) continue;
    const TreeRow& above = rows[static_cast<std::size_t>(row.parent)];
    ASSERT_LT(row.parent, static_cast<int>(i));
    ASSERT_EQ(row.indent, above.indent + 1);
    if (row.node == no_node) continue;
    NodeId up = graph.parent(row.node);
    while (up != above.node && up != no_node) up = graph.parent(up);
    ASSERT_EQ(up, above.node);
  }
  ASSERT_TRUE(shown.contains(focus));
  ASSERT_EQ(shown.size() + hidden, graph.size());
  if (graph.size() <= most) {
    ASSERT_EQ(shown.size(), graph.size());
  }
  if (2 * shape.depths[focus] + 3 > most) return;
  for (NodeId up = focus; up != no_node; up = graph.parent(up)) ASSERT_TRUE(shown.contains(up));
}

TEST(TreeRows, CountEveryNodeOnce) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto size = static_cast<NodeId>(1 + seed * seed / 7);
    const SceneGraph graph = random_tree(seed, size);
    for (const std::size_t most : {8u, 13u, 20u, 45u}) {
      for (const NodeId focus : {NodeId(0), size / 2, size - 1}) expect_lawful(graph, focus, most);
    }
  }
}

TEST(TreeRows, ShortenDeepAndWideTrees) {
  const SceneGraph deep = chain(10'000);
  expect_lawful(deep, 9'999, 20);
  expect_lawful(deep, 5'000, 20);
  expect_lawful(deep, root_node, 20);
  SceneGraph wide;
  for (int i = 0; i < 100'000; ++i) wide.add(root_node, "leaf");
  expect_lawful(wide, 77'777, 20);
  expect_lawful(wide, root_node, 20);
  const TreeShape shape(deep);
  EXPECT_EQ(shape.deepest, 9'999u);
  EXPECT_EQ(shape.sizes[root_node], 10'000u);
  EXPECT_EQ(shape.sizes[9'999], 1u);
}

TEST(TreeRows, ShowFirstWhatIsNearTheFocus) {
  const Scene scene = make_levels(6);
  const TreeShape shape(scene.graph);
  const NodeId focus = node_by_name(scene.graph, "/top/left/right/left");
  const auto rows = tree_rows(scene.graph, shape, focus, 16);
  const auto has = [&](NodeId node) {
    return std::any_of(rows.begin(), rows.end(), [&](const TreeRow& row) { return row.node == node; });
  };
  for (const char* path : {"/top/left/right/left/sphere", "/top/left/right/left/right", "/top/left/right/right"}) {
    EXPECT_TRUE(has(node_by_name(scene.graph, path))) << path;
  }
  EXPECT_FALSE(has(node_by_name(scene.graph, "/top/right/right")));
}

TEST(NodeByName, FindsPathsEndsNamesAndNumbers) {
  const Scene scene = make_levels(4);
  const SceneGraph& graph = scene.graph;
  EXPECT_EQ(node_by_name(graph, "/"), root_node);
  EXPECT_EQ(graph.path(node_by_name(graph, "/top/left/right")), "/top/left/right");
  EXPECT_EQ(graph.path(node_by_name(graph, "left/right")), "/top/left/right");
  EXPECT_EQ(graph.path(node_by_name(graph, "right")), "/top/right");
  EXPECT_EQ(graph.path(node_by_name(graph, "sphere")), "/top/sphere");
  EXPECT_EQ(node_by_name(graph, "#7"), 7u);
  for (const std::string wrong : {"", "lefty", "#", "#33", "#-1", "#1x", "//", "/left", "op", "ft/right"}) {
    EXPECT_THROW(node_by_name(graph, wrong), std::invalid_argument) << wrong;
  }
  try {
    node_by_name(graph, "/top/SPHERES");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("such as sphere"), std::string::npos) << error.what();
  }
  EXPECT_THROW(node_by_name(SceneGraph(), "x"), std::invalid_argument);
}

}  // namespace
}  // namespace sightline::viz
