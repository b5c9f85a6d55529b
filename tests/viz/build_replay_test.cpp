/// Stepping through construction: what is weighed outside of the library is what its builders decided, node by node.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

#include "sightline/query/primitives_of.h"
#include "sightline/scene/scenes.h"
#include "viz/build/build_tree.h"
#include "viz/build/replay.h"

namespace sightline::viz {
namespace {

using Ids = std::vector<std::uint32_t>;

Ids sorted(Ids ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

struct Case {
  std::string accelerator, scene;
  std::vector<TracerSettings::Option> options;
  bool has_rules = false;  ///< Some nodes are divided by a rule, not by cost.
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.accelerator << " on " << c.scene;
  for (const auto& [name, value] : c.options) *out << ", " << name << " = " << value;
}

class BuildReplayOf : public testing::TestWithParam<Case> {};

struct Seen {
  std::size_t by_cost = 0, by_rule = 0, leaves = 0;
};

/// The cheapest candidate of those that are none of a rule.
double least_cost(const Decision& decision) {
  double least = 1e300;
  for (const BuildCandidate& candidate : decision.candidates) {
    if (candidate.label.empty()) least = std::min(least, candidate.cost);
  }
  return least;
}

/// Space is divided: the children's cells meet in the plane chosen. BSP trees take corners within 8 u of the scene's
/// radius for corners in the plane (B4 of bsp_tree.h).
void expect_plane(const Case& c, const BuildTree& tree, const BuildNode& node, const BuildCandidate& chosen) {
  if (c.accelerator == "bsp-tree") {
    Plane plane = chosen.plane;
    if (chosen.axis >= 0) plane.normal = Vec3d(chosen.axis == 0, chosen.axis == 1, chosen.axis == 2);
    if (chosen.axis >= 0) plane.offset = chosen.position;
    constexpr double thickness = 0x1p-20 * 8;  // more than twice the radius of these scenes
    for (const int side : {0, 1}) {
      for (const Vec3d& p : std::get<Polyhedron>(tree[node.children[side]].cell.region).vertices) {
        EXPECT_LE((side == 0 ? 1 : -1) * plane.side(p), thickness);
      }
    }
  }
  if (c.accelerator != "kd-tree") return;
  const Aabb below = std::get<Aabb>(tree[node.children[0]].cell.region);
  const Aabb above = std::get<Aabb>(tree[node.children[1]].cell.region);
  EXPECT_EQ(double(below.hi[chosen.axis]), chosen.position);
  EXPECT_EQ(double(above.lo[chosen.axis]), chosen.position);
}

TEST_P(BuildReplayOf, DecidesAsTheBuilderDid) {
  const Case& c = GetParam();
  const auto mesh = load_scene(c.scene, "");
  const PrimitivesOf primitives(*mesh);
  TracerSettings settings;
  settings.options = c.options;
  const auto tracer = make_tracer(c.accelerator, mesh, settings);
  const BuildTree tree(*tracer);
  const auto replay = make_replay(c.accelerator, primitives, settings);
  Seen seen;
  for (std::size_t i = 0; i < tree.nodes().size() && !HasFailure(); ++i) {
    SCOPED_TRACE("node " + std::to_string(i));
    const BuildNode& node = tree[i];
    const Decision decision = replay->decide(tree.way_to(i));
    EXPECT_EQ(sorted(decision.primitives), tree.primitives_below(i));
    ASSERT_EQ(decision.is_divided, !node.children.empty()) << decision.reason;
    EXPECT_FALSE(decision.reason.empty());
    if (!decision.is_divided) {
      ++seen.leaves;
      continue;
    }
    if (!decision.parts.empty()) {
      ++seen.by_cost;
      ASSERT_EQ(node.children.size(), decision.parts.size());
      for (std::size_t part = 0; part < decision.parts.size(); ++part) {
        EXPECT_EQ(sorted(decision.parts[part]), tree.primitives_below(node.children[part]));
      }
      ASSERT_TRUE(decision.chosen);
      EXPECT_EQ(decision.candidates[*decision.chosen].cost, least_cost(decision));
      continue;
    }
    ASSERT_EQ(node.children.size(), 2u);
    EXPECT_EQ(sorted(decision.below), tree.primitives_below(node.children[0]));
    EXPECT_EQ(sorted(decision.above), tree.primitives_below(node.children[1]));
    if (!decision.chosen) {
      ++seen.by_rule;
      continue;
    }
    const BuildCandidate& chosen = decision.candidates.at(*decision.chosen);
    expect_plane(c, tree, node, chosen);
    if (!chosen.label.empty()) {
      ++seen.by_rule;
      continue;
    }
    ++seen.by_cost;
    EXPECT_EQ(chosen.cost, least_cost(decision));
    EXPECT_EQ(chosen.below, decision.below.size());
    EXPECT_EQ(chosen.above, decision.above.size());
  }
  EXPECT_EQ(seen.by_rule > 0, c.has_rules);
  EXPECT_GT(seen.leaves, 20u);
  EXPECT_GT(seen.by_cost + seen.by_rule, 20u);
  std::cout << "  " << seen.by_cost << " by cost, " << seen.by_rule << " by rule, " << seen.leaves << " leaves\n";
}

INSTANTIATE_TEST_SUITE_P(
    Structures, BuildReplayOf,
    testing::Values(
        Case{"kd-tree", "teapot:4", {}}, Case{"kd-tree", "teapot:4", {{"quality", "fast"}}},
        Case{"kd-tree", "teapot:3", {{"quality", "best"}, {"max_leaf_size", "1"}}},
        Case{"kd-tree", "sticks:300", {}, true}, Case{"kd-tree", "integers:300", {{"max_leaf_size", "2"}}},
        Case{"box-tree", "teapot:4", {}}, Case{"box-tree", "teapot:4", {{"quality", "fast"}}},
        Case{"box-tree", "teapot:4", {{"quality", "best"}}}, Case{"box-tree", "sticks:300", {{"quality", "best"}}},
        Case{"box-tree", "teapot:3", {{"bins", "5"}, {"max_leaf_size", "1"}}}, Case{"sphere-tree", "teapot:4", {}},
        Case{"cylinder-tree", "teapot:4", {}}, Case{"bih", "teapot:4", {}},
        Case{"bih", "teapot:4", {{"quality", "best"}}}, Case{"bih", "teapot:4", {{"quality", "fast"}}, true},
        Case{"bsp-tree", "teapot:4", {}}, Case{"bsp-tree", "teapot:3", {{"quality", "best"}}},
        Case{"bsp-tree", "teapot:4", {{"quality", "fast"}}}, Case{"bsp-tree", "sticks:1200", {}},
        Case{"bsp-tree", "sticks:300", {{"general_planes", "false"}}, true}, Case{"wide-tree", "teapot:4", {}},
        Case{"wide-tree", "teapot:4", {{"quality", "best"}}}, Case{"wide-tree", "teapot:4", {{"quality", "fast"}}},
        Case{"wide-tree", "sticks:600", {{"splits", "100"}}}));

/// Of a grid the top level is weighed: its cells hold what the replay finds in them.
TEST(GridReplay, FindsTheCellsOfTheTopLevel) {
  for (const char* scene : {"teapot:4", "sticks:1500", "flat"}) {
    SCOPED_TRACE(scene);
    const auto mesh = load_scene(scene, "");
    const PrimitivesOf primitives(*mesh);
    const auto tracer = make_tracer("grid", mesh);
    const BuildTree tree(*tracer);
    const auto replay = make_replay("grid", primitives, {});
    const Decision decision = replay->decide({});
    ASSERT_EQ(decision.parts.size(), tree[0].children.size());
    EXPECT_GT(decision.parts.size(), 20u);
    for (std::size_t i = 0; i < decision.parts.size(); ++i) {
      const Ids weighed = sorted(decision.parts[i]), held = tree.primitives_below(tree[0].children[i]);
      EXPECT_TRUE(std::includes(weighed.begin(), weighed.end(), held.begin(), held.end()));
      // Where a cell is cut again, what only came near may be in none of its parts.
      if (tree[tree[0].children[i]].cell.is_leaf) {
        EXPECT_EQ(weighed, held);
      }
    }
    ASSERT_TRUE(decision.chosen);
    EXPECT_GT(decision.candidates.size(), 5u);
    EXPECT_THROW(replay->decide(std::vector{0}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace sightline::viz
