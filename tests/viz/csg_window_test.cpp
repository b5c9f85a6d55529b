/// The window of the interval ladder, on a screen in memory, by events that come from the X server as a hand's would.

#include "viz/csg_window.h"

#include <gtest/gtest.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <sstream>

#include "sightline/scene/solids.h"
#include "tests/io/temporary_folder.h"
#include "viz/csg_command.h"
#include "viz/csg_table.h"
#include "viz/csg_trace.h"
#include "viz/virtual_screen.h"

// X defines words that others use; so last.
#include "tests/viz/hand.h"

namespace sightline::viz {
namespace {

constexpr int width = 800, height = 450;

/// What `--pick x,y` tells of the ray there.
nlohmann::json told_by_pick(const std::string& solid, int x, int y) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "pick.json").string();
  CLI::App app;
  CsgCommand command(app);
  app.parse("csg --solid " + solid + " --size " + std::to_string(width) + "x" + std::to_string(height) + " --pick " +
            std::to_string(x) + "," + std::to_string(y) + " --out " + out);
  testing::internal::CaptureStdout();
  const int status = command.run();
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(status, 0);
  std::ifstream file(out);
  return nlohmann::json::parse(file);
}

class WindowOfSolid {
 public:
  explicit WindowOfSolid(const std::string& name)
      : name_(name),
        solid_(load_solid(name), "box-tree"),
        window_(first(), "sightline-view csg --solid " + name, tables_),
        hand_(window_.interactor()) {}

  CsgWindow& window() { return window_; }
  Hand& hand() { return hand_; }
  nlohmann::json shown() const { return ladder_json(window_.picture().ladder, solid_, name_); }
  std::string table() const { return ladder_table(window_.picture().ladder, solid_, name_); }
  /// Printed since it was asked for last.
  std::string printed() {
    const std::string text = tables_.str();
    tables_.str("");
    return text;
  }

 private:
  CsgPicture first() const {
    const SolidInfo& info = solid_info(name_);
    const auto vector = [](const auto& v) { return Vec3d(v[0], v[1], v[2]); };
    return {solid_, solid_.climb({vector(info.origin), vector(info.direction)}, Level::watertight), name_, "", width,
            height};
  }

  std::string name_;
  LadderSolid solid_;
  std::ostringstream tables_;
  CsgWindow window_;
  Hand hand_;
};

TEST(CsgWindow, AClickChoosesTheRayOfThatPixel) {
  const VirtualScreen screen;
  for (const std::string name : {"widget", "not-a-sphere"}) {
    WindowOfSolid solid(name);
    const SolidPanel panel = CsgLayout(width, height).panel();
    int hits = 0;
    for (const auto& [x, y] : {std::pair{panel.x + panel.width / 2, panel.y + panel.height / 2},
                               {panel.x + panel.width / 2 + 31, panel.y + panel.height / 3},
                               {panel.x, panel.y},
                               {panel.x + panel.width - 1, panel.y + panel.height - 1}}) {
      solid.hand().click(x, y);
      EXPECT_EQ(solid.shown(), told_by_pick(name, x, y)) << name << ' ' << x << ' ' << y;
      EXPECT_EQ(solid.printed(), '\n' + solid.table());
      hits += solid.window().picture().ladder.hit.has_value();
    }
    EXPECT_GE(hits, 2) << name;
  }
}

TEST(CsgWindow, RBringsBackTheFirstRay) {
  const VirtualScreen screen;
  WindowOfSolid solid("widget");
  const auto first = solid.shown();
  const SolidPanel panel = CsgLayout(width, height).panel();
  for (const KeySym key : {XK_r, XK_R}) {
    solid.hand().click(panel.x + panel.width / 2, panel.y + panel.height / 2);
    EXPECT_NE(solid.shown(), first);
    solid.printed();
    solid.hand().press(key);
    EXPECT_EQ(solid.shown(), first);
    EXPECT_EQ(solid.printed(), '\n' + solid.table());
  }
}

TEST(CsgWindow, NothingElseChangesIt) {
  const VirtualScreen screen;
  WindowOfSolid solid("lens");
  const auto first = solid.shown();
  const SolidPanel panel = CsgLayout(width, height).panel();
  for (const auto& [x, y] : {std::pair{panel.x - 1, panel.y + 5},
                             {panel.x + panel.width, panel.y + 5},
                             {panel.x + 5, panel.y - 1},
                             {panel.x + 5, panel.y + panel.height},
                             {width - 1, height - 1}}) {
    solid.hand().click(x, y);
  }
  for (const KeySym key : {XK_space, XK_a, XK_Up, XK_Return}) solid.hand().press(key);
  EXPECT_EQ(solid.shown(), first);
  EXPECT_EQ(solid.printed(), "");
}

TEST(CsgWindow, QClosesIt) {
  const VirtualScreen screen;
  WindowOfSolid solid("lens");
  EXPECT_FALSE(solid.window().interactor().GetDone());
  solid.hand().press(XK_q);
  EXPECT_TRUE(solid.window().interactor().GetDone());
}

TEST(CsgWindow, ThePictureFitsTheWindow) {
  const VirtualScreen screen;
  WindowOfSolid solid("widget");
  solid.hand().resize(1000, 700 + WindowFrame::foot_height);
  EXPECT_EQ(solid.window().picture().width, 1000);
  EXPECT_EQ(solid.window().picture().height, 700);
  const SolidPanel panel = CsgLayout(1000, 700).panel();
  const int x = panel.x + panel.width / 2, y = panel.y + panel.height - 9;
  solid.hand().click(x, y);
  const auto ray = ray_through_pixel(solid.window().picture().solid, 1000, 700, x, y);
  ASSERT_TRUE(ray);
  EXPECT_EQ(solid.window().picture().ladder.ray.direction, ray->direction);
}

}  // namespace
}  // namespace sightline::viz
