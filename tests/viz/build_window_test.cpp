/// The window that steps through a construction, on a screen in memory.

#include "viz/build/build_window.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "sightline/scene/scenes.h"
#include "tests/io/temporary_folder.h"
#include "viz/build/build_chart.h"
#include "viz/virtual_screen.h"

// X defines words that others use; so last.
#include "tests/viz/hand.h"

namespace sightline::viz {
namespace {

BuildStory story_of(const std::string& accelerator) {
  AcceleratorSpec spec{accelerator, accelerator, {}};
  return BuildStory(load_scene("teapot:3", ""), spec, "teapot:3", "");
}

TEST(BuildWindow, KeysWalkTheTree) {
  const PictureScreen screen;
  const BuildStory story = story_of("kd-tree");
  const BuildTree& tree = story.tree();
  std::ostringstream commands;
  BuildWindow window(story, 0, {.width = 1200, .height = 675}, commands);
  Hand hand(window.interactor());
  hand.press(XK_Right);
  EXPECT_EQ(window.node(), tree.steps()[1]);
  hand.press(XK_Right);
  EXPECT_EQ(window.node(), tree.steps()[2]);
  hand.press(XK_Left);
  EXPECT_EQ(window.node(), tree.steps()[1]);
  hand.press(XK_Down);
  EXPECT_EQ(tree[window.node()].parent, tree.steps()[1]);
  hand.press(XK_Up);
  EXPECT_EQ(window.node(), tree.steps()[1]);
  EXPECT_EQ(window.step().step, 1u);
  hand.press(XK_Tab);
  EXPECT_EQ(window.node(), tree[0].children[1]);
  hand.press(XK_Home);
  EXPECT_EQ(window.node(), 0u);
  hand.press(XK_Left);  // nothing is before the root
  hand.press(XK_Up);
  EXPECT_EQ(window.node(), 0u);
  hand.press(XK_h);
  EXPECT_TRUE(window.has_help());
  hand.press(XK_h);
  EXPECT_FALSE(window.has_help());
  EXPECT_EQ(window.node(), 0u);
  const TemporaryFolder folder;
  window.set_picture_folder(folder.path());
  hand.press(XK_s);
  hand.press(XK_s);
  for (const char* name : {"build-1.png", "build-2.png"}) {
    const std::string path = (folder.path() / name).string();
    EXPECT_TRUE(std::filesystem::exists(path));
    EXPECT_NE(commands.str().find(window.command() + " --out " + path + "\n"), std::string::npos);
  }
}

TEST(BuildTree, StepsComeBreadthFirst) {
  const BuildStory story = story_of("box-tree");
  const BuildTree& tree = story.tree();
  ASSERT_GT(tree.steps().size(), 20u);
  EXPECT_EQ(tree.steps()[0], 0u);
  int depth = 0;
  for (const std::size_t node : tree.steps()) {
    EXPECT_FALSE(tree[node].cell.is_leaf);
    EXPECT_GE(tree[node].cell.depth, depth);
    depth = tree[node].cell.depth;
    EXPECT_EQ(tree.named(tree[node].cell.node), node);
  }
  // From a leaf, Right leads back to the division that made it.
  std::size_t leaf = 0;
  while (!tree[leaf].children.empty()) leaf = tree[leaf].children[0];
  EXPECT_EQ(node_after(tree, leaf, "Right"), tree[leaf].parent);
  EXPECT_EQ(node_after(tree, leaf, "Down"), std::nullopt);
  EXPECT_EQ(node_after(tree, tree.steps().back(), "Right"), std::nullopt);
}

TEST(CostChart, ShowsWhatWasTakenAndWhatALeafCosts) {
  for (const char* accelerator : {"kd-tree", "box-tree", "bih"}) {
    const BuildStory story = story_of(accelerator);
    const BuildStep step = story.step_at(0);
    ASSERT_TRUE(step.decision.chosen);
    const CostRange range = cost_range(step.decision);
    const double taken = step.decision.candidates[*step.decision.chosen].cost;
    EXPECT_LT(range.lo, taken);
    EXPECT_LT(taken, step.decision.leaf_cost);
    EXPECT_LT(step.decision.leaf_cost, range.hi);
    EXPECT_LT(range.beyond, step.decision.candidates.size());
  }
}

TEST(CostText, IsShort) {
  EXPECT_EQ(cost_text(37.21), "37.2");
  EXPECT_EQ(cost_text(219.4), "219");
  EXPECT_EQ(cost_text(16256), "16,256");
  EXPECT_EQ(cost_text(1234567), "1,234,567");
  EXPECT_EQ(cost_text(0), "0");
  EXPECT_EQ(place_text(1, -1.25), "y = -1.25");
}

}  // namespace
}  // namespace sightline::viz
