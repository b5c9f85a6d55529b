/// The window of a scene graph, on a screen in memory.

#include "viz/graph/graph_window.h"

#include <gtest/gtest.h>

#include <sstream>

#include "viz/graph/bound_lines.h"
#include "viz/graph/graph_scene.h"
#include "viz/graph/tree_panel.h"
#include "viz/virtual_screen.h"

// X defines words that others use; so last.
#include "tests/viz/hand.h"

namespace sightline::viz {
namespace {

constexpr int width = 1000, height = 625;

struct Pixel {
  int x, y;
};

class WindowOfScene {
 public:
  explicit WindowOfScene(const std::string& name)
      : played_(load_played_scene(name, "")),
        scene_(std::move(played_.scene)),
        window_(scene_, played_.controller.get(), played_.duration, name, look(), width, height, tables_),
        hand_(window_.interactor()) {}

  LiveScene& scene() { return scene_; }
  GraphWindow& window() { return window_; }
  Hand& hand() { return hand_; }
  NodeId node(const std::string& path) const { return node_by_name(scene_.graph(), path); }
  NodeId chosen() const { return window_.picture().look.selected; }
  std::string printed() {
    const std::string text = tables_.str();
    tables_.str("");
    return text;
  }

  /// Where a point of the world is in the picture.
  Pixel pixel_of(const Vec3d& p) const {
    const GraphLayout layout = window_.picture().layout();
    const PanelFrame space = layout.frames().front().space;
    const auto at = window_.camera().project(p);
    return {static_cast<int>((space.x + (at->x + 1) / 2 * space.width) * layout.unit()),
            static_cast<int>((space.y + (1 - at->y) / 2 * space.height) * layout.unit())};
  }
  Pixel pixel_of(NodeId node) { return pixel_of(scene_.world(node).matrix().column(3)); }
  Pixel row_of(NodeId node) const {
    const GraphPicture& picture = window_.picture();
    const GraphLayout layout = picture.layout();
    const PanelFrame& tree = layout.frames().front().tree;
    const TreePanel panel(picture.drawn, picture.look.selected, tree);
    for (int y = 0; y < height; ++y) {
      const int x = static_cast<int>((tree.x + 0.5 * tree.width) * layout.unit());
      if (panel.node_at({x / layout.unit(), y / layout.unit()}) == node) return {x, y + 3};
    }
    ADD_FAILURE() << "no row of node " << node;
    return {0, 0};
  }

 private:
  GraphLook look() {
    GraphLook look;
    look.deepest = 3;
    return look;
  }

  PlayedScene played_;
  LiveScene scene_;
  std::ostringstream tables_;
  GraphWindow window_;
  Hand hand_;
};

TEST(GraphWindow, DraggingAThingMovesItsNodeInThePicturesPlane) {
  const VirtualScreen screen;
  WindowOfScene shown("levels:3");
  const NodeId sphere = shown.node("/top/sphere"), left = shown.node("/top/left");
  const NodeId small = shown.node("/top/left/left/sphere");
  const Vec3d before = shown.scene().world(sphere).matrix().column(3);
  const Pixel from = shown.pixel_of(sphere);
  shown.hand().hold(from.x, from.y);
  EXPECT_EQ(shown.chosen(), sphere);
  shown.hand().move(from.x + 20, from.y - 15);
  shown.hand().move(from.x + 50, from.y - 40);
  ASSERT_TRUE(shown.window().change());
  const Change change = *shown.window().change();
  EXPECT_EQ(change.way, (std::vector{sphere, shown.node("/top"), root_node}));
  EXPECT_EQ(shown.window().picture().frames.front().told, change.way);
  EXPECT_TRUE(is_same(change.before->bounds[left], change.after->bounds[left]));
  const Vec3d by = shown.scene().world(sphere).matrix().column(3) - before;
  EXPECT_LT(glm::length(by - change.by), 1e-12);
  EXPECT_NEAR(glm::dot(by, shown.window().camera().axes.z), 0, 1e-12);
  const Pixel to = shown.pixel_of(sphere);
  EXPECT_NEAR(to.x, from.x + 50, 5);  // what was taken hold of is in front of the middle
  EXPECT_NEAR(to.y, from.y - 40, 5);
  EXPECT_EQ(shown.printed(), "");
  shown.hand().let_go(from.x + 50, from.y - 40);
  EXPECT_NE(shown.printed().find("3rd"), std::string::npos);
  shown.hand().move(from.x + 90, from.y);
  EXPECT_EQ(shown.scene().world(sphere).matrix().column(3), before + by);

  // Of a node that is chosen, any thing below will do.
  const Pixel row = shown.row_of(left);
  shown.hand().click(row.x, row.y);
  EXPECT_EQ(shown.chosen(), left);
  const Pixel at = shown.pixel_of(small);
  const Vec3d was = shown.scene().world(left).matrix().column(3);
  shown.hand().hold(at.x, at.y);
  EXPECT_EQ(shown.chosen(), left);
  shown.hand().move(at.x - 30, at.y);
  shown.hand().let_go(at.x - 30, at.y);
  EXPECT_GT(glm::length(shown.scene().world(left).matrix().column(3) - was), 0.05);

  shown.hand().press(XK_r);
  EXPECT_EQ(shown.scene().world(sphere).matrix().column(3), before);
  EXPECT_EQ(shown.chosen(), root_node);
}

TEST(GraphWindow, DraggingBesideThingsTurnsTheView) {
  const VirtualScreen screen;
  WindowOfScene shown("levels:2");
  const PanelFrame space = shown.window().picture().layout().frames().front().space;
  const double unit = shown.window().picture().layout().unit();
  const int x = static_cast<int>((space.x + 6) * unit), y = static_cast<int>((space.y + 6) * unit);
  const GraphLook first = shown.window().picture().look;
  const Vec3d eye = shown.window().camera().eye;
  shown.hand().hold(x, y);
  shown.hand().move(x + 50, y + 10);
  shown.hand().let_go(x + 50, y + 10);
  EXPECT_LT(shown.window().picture().look.azimuth, first.azimuth);
  EXPECT_NE(shown.window().camera().eye, eye);
  EXPECT_FALSE(shown.window().change());
}

TEST(GraphWindow, KeysChooseAndQCloses) {
  const VirtualScreen screen;
  WindowOfScene shown("rocket");
  const Pixel row = shown.row_of(shown.node("/rocket/nose"));
  shown.hand().click(row.x, row.y);
  EXPECT_EQ(shown.chosen(), shown.node("/rocket/nose"));
  shown.hand().press(XK_Up);
  EXPECT_EQ(shown.chosen(), shown.node("/rocket"));
  shown.hand().press(XK_Down);
  EXPECT_EQ(shown.chosen(), shown.node("/rocket/body"));
  shown.hand().press(XK_b);
  EXPECT_EQ(shown.window().picture().look.kind, BoundKind::sphere);
  EXPECT_TRUE(std::holds_alternative<Sphere>(shown.window().picture().frames.front().bounds->bounds[root_node]));
  shown.hand().press(XK_t);
  EXPECT_FALSE(shown.window().picture().look.has_things);
  shown.hand().resize(1200, 700);
  EXPECT_EQ(shown.window().picture().width, 1200);
  EXPECT_FALSE(shown.window().interactor().GetDone());
  shown.hand().press(XK_q);
  EXPECT_TRUE(shown.window().interactor().GetDone());
}

}  // namespace
}  // namespace sightline::viz
