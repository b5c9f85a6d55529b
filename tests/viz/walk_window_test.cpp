/// The window of a walk, on a screen in memory.

#include "viz/walk/walk_window.h"

#include <gtest/gtest.h>

#include <sstream>

#include "sightline/scene/scenes.h"
#include "tests/io/temporary_folder.h"
#include "viz/virtual_screen.h"

// X defines words that others use; so last.
#include "tests/viz/hand.h"

namespace sightline::viz {
namespace {

constexpr int width = 1200, height = 675;

class WindowOfWalk {
 public:
  explicit WindowOfWalk(const std::string& accelerator, const TracerSettings& settings = {})
      : mesh_(load_scene("teapot:4", "")),
        tracer_(make_tracer(accelerator, mesh_, settings)),
        first_(model_of(*tracer_, usual_ray(mesh_->bounds()))),
        window_(first_, 0, look(), commands_),
        hand_(window_.interactor()) {
    window_.set_picture_folder(folder_.path());
  }

  const WalkModel& first() const { return first_; }
  WalkWindow& window() { return window_; }
  Hand& hand() { return hand_; }
  std::string printed() {
    const std::string text = commands_.str();
    commands_.str("");
    return text;
  }
  void click(double x, double y) {
    const double unit = look().layout().unit();
    hand_.click(static_cast<int>(x * unit), static_cast<int>(y * unit));
  }
  static WalkLook look() {
    WalkLook look;
    look.width = width, look.height = height;
    return look;
  }

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  std::unique_ptr<Tracer> tracer_;
  WalkModel first_;
  TemporaryFolder folder_;
  std::ostringstream commands_;
  WalkWindow window_;
  Hand hand_;
};

TEST(WalkWindow, KeysGoThroughTheSteps) {
  const VirtualScreen screen;
  WindowOfWalk shown("kd-tree");
  const std::size_t last = shown.first().last_step();
  ASSERT_GT(last, 8u);
  shown.hand().press(XK_Left);
  EXPECT_EQ(shown.window().step(), 0u);
  shown.hand().press(XK_Right);
  shown.hand().press(XK_Right);
  EXPECT_EQ(shown.window().step(), 2u);
  shown.hand().press(XK_Left);
  EXPECT_EQ(shown.window().step(), 1u);
  shown.hand().press(XK_End);
  EXPECT_EQ(shown.window().step(), last);
  shown.hand().press(XK_Right);
  EXPECT_EQ(shown.window().step(), last);
  shown.hand().press(XK_Home);
  EXPECT_EQ(shown.window().step(), 0u);
  shown.hand().press(XK_Page_Down);
  EXPECT_EQ(shown.window().step(), leaf_beside(shown.first().walk, 0, 1));
  shown.hand().press(XK_h);
  EXPECT_TRUE(shown.window().has_help());
  shown.hand().press(XK_h);
  shown.hand().press(XK_space);
  EXPECT_TRUE(shown.window().is_playing());
  shown.hand().press(XK_space);
  EXPECT_FALSE(shown.window().is_playing());
  shown.hand().press(XK_s);
  const std::string printed = shown.printed();
  EXPECT_NE(printed.find("--ray=" + text_of(shown.first().walk.ray)), std::string::npos) << printed;
  EXPECT_NE(printed.find("--step " + std::to_string(shown.window().step())), std::string::npos) << printed;
  EXPECT_FALSE(shown.window().interactor().GetDone());
  shown.hand().press(XK_q);
  EXPECT_TRUE(shown.window().interactor().GetDone());
}

TEST(WalkWindow, ClicksChooseStepsAndRays) {
  const VirtualScreen screen;
  WindowOfWalk shown("box-tree");
  const Walk& walk = shown.first().walk;
  const WalkLayout layout = WindowOfWalk::look().layout();
  const std::vector<Tick> ticks = lay_out_timeline(walk, layout.timeline);
  shown.click(ticks[5].x + 0.5 * ticks[5].width, layout.timeline.y + 40);
  EXPECT_EQ(shown.window().step(), ticks[5].shown);

  const TreeLayout tree =
      lay_out_tree(walk, states_at(walk, ticks[5].shown), current_cell(walk, ticks[5].shown), layout.tree);
  shown.click(tree.nodes.front().x, tree.nodes.front().y);
  EXPECT_EQ(shown.window().step(), 0u);

  const Panel& space = layout.space;
  const double x = space.x + 0.5 * space.width, y = space.y + 0.5 * space.height;
  shown.click(x, y);
  const Ray<float> ray = shown.window().model().walk.ray;
  EXPECT_NE(text_of(ray), text_of(walk.ray));
  EXPECT_TRUE(shown.window().model().walk.hit.is_hit()) << "the teapot is in the middle";
  EXPECT_EQ(shown.window().step(), shown.window().model().last_step());
  EXPECT_EQ(shown.window().look().azimuth, WindowOfWalk::look().azimuth + aside);
  const double unit = layout.unit();
  const auto same =
      ray_through_pixel(shown.first(), WindowOfWalk::look(), static_cast<int>(x * unit), static_cast<int>(y * unit));
  ASSERT_TRUE(same);
  EXPECT_EQ(text_of(*same), text_of(ray)) << "as --pick chooses it";
  shown.hand().press(XK_r);
  EXPECT_EQ(text_of(shown.window().model().walk.ray), text_of(walk.ray));
}

TEST(WalkWindow, DraggingTurnsTheViewAndKeepsTheRay) {
  const VirtualScreen screen;
  WindowOfWalk shown("sphere-tree");
  shown.hand().hold(300, 250);
  shown.hand().move(340, 240);
  shown.hand().move(360, 230);
  shown.hand().let_go(360, 230);
  EXPECT_LT(shown.window().look().azimuth, WindowOfWalk::look().azimuth);
  EXPECT_EQ(text_of(shown.window().model().walk.ray), text_of(shown.first().walk.ray));
  shown.hand().resize(1280, 720);
  EXPECT_EQ(shown.window().look().width, 1280);
}

TEST(WalkWindow, GrowsALazyTree) {
  const VirtualScreen screen;
  WindowOfWalk shown("bih", {{{"lazy", "true"}}});
  const std::size_t before = shown.first().walk.all_cells;
  shown.hand().click(380, 300);
  const WalkModel& model = shown.window().model();
  EXPECT_EQ(model.cells_before, before);
  EXPECT_GT(model.walk.all_cells, before);
  EXPECT_EQ(shown.window().step(), 0u);
  shown.hand().press(XK_s);
  EXPECT_NE(shown.printed().find("--earlier=" + text_of(shown.first().walk.ray)), std::string::npos);
}

}  // namespace
}  // namespace sightline::viz
