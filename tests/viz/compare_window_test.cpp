/// The window of comparisons, on a screen in memory, by events that come from the X server as a hand's would.

#include "viz/compare/compare_window.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <sstream>

#include "sightline/scene/scenes.h"
#include "tests/io/temporary_folder.h"
#include "viz/compare/compare_command.h"
#include "viz/compare/compare_data.h"
#include "viz/virtual_screen.h"

// X defines words that others use; so last.
#include "tests/viz/hand.h"

namespace sightline::viz {
namespace {

constexpr int width = 960, height = 540;

class WindowOfThree {
 public:
  WindowOfThree()
      : session_(compared(), source()), window_(session_, look(), width, height, out_), hand_(interactor()) {}

  CompareWindow& window() { return window_; }
  Hand& hand() { return hand_; }
  const CompareLook& shown() const { return window_.look(); }
  std::string printed() {
    const std::string text = out_.str();
    out_.str("");
    return text;
  }
  CompareLayout layout() const { return {width, height, shown().alone ? std::size_t(1) : std::size_t(3)}; }
  const TriangleMesh& mesh() const { return session_.compared().front().tracer->mesh(); }

 private:
  static std::vector<Compared> compared() {
    const auto mesh = load_scene("teapot:3", "");
    std::vector<Compared> all;
    for (const char* name : {"box-tree", "grid", "kd-tree"}) all.push_back({name, make_tracer(name, mesh)});
    return all;
  }
  static CompareSource source() {
    return {"box-tree,grid,kd-tree", "teapot:3", {"box-tree", "grid", "kd-tree"}, {}, {}, "compare"};
  }
  CompareLook look() const {
    CompareLook look;
    look.ray = ray_across(*session_.compared().front().tracer);
    return look;
  }
  vtkRenderWindowInteractor& interactor() { return window_.interactor(); }

  std::ostringstream out_;
  CompareSession session_;
  CompareWindow window_;
  Hand hand_;
};

/// What the program tells of a command line, as data.
nlohmann::json told_by(const std::string& line) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out.json").string(), data;
  CLI::App app;
  CompareCommand command(app, data);
  app.parse(line.substr(line.find(' ') + 1) + " --out " + out);
  testing::internal::CaptureStdout();
  EXPECT_EQ(command.run(), 0);
  testing::internal::GetCapturedStdout();
  std::ifstream file(out);
  return nlohmann::json::parse(file);
}

TEST(CompareWindow, AClickChoosesTheRayForAll) {
  const VirtualScreen screen;
  WindowOfThree three;
  for (std::size_t panel = 0; panel < 3; ++panel) {
    const PixelFrame f = three.layout().pictures()[panel];
    const int x = f.x + f.width / 2 + 9 * static_cast<int>(panel), y = f.y + f.height / 2 + 4;
    three.hand().click(x, y);
    const auto ray = ray_through_pixel(three.mesh(), three.shown(), three.layout(), x, y);
    ASSERT_TRUE(ray);
    EXPECT_EQ(three.shown().ray.origin, ray->origin);
    EXPECT_EQ(three.shown().ray.direction, ray->direction);
    ASSERT_EQ(three.window().findings().walks.size(), 3u);
    for (const Walk& walk : three.window().findings().walks) {
      EXPECT_EQ(walk.ray.direction, ray->direction);
      EXPECT_TRUE(walk.hit.is_hit());
    }
    EXPECT_NE(three.printed().find("the same bits in all 3 structures"), std::string::npos);
  }
  const CompareLook before = three.shown();
  three.hand().click(3, 3);  // beside all panels
  EXPECT_EQ(three.shown(), before);
  EXPECT_EQ(three.printed(), "");
}

/// What is seen in an inset is asked from its camera: the middle of it is the hit that it shows.
TEST(CompareWindow, AClickOnAnInsetChoosesWhatItShows) {
  const VirtualScreen screen;
  WindowOfThree three;
  const Hit<float> hit = three.window().findings().walks.front().hit;
  ASSERT_TRUE(hit.is_hit());
  const ComparePicture picture = three.window().picture();
  const CompareLayout places = picture.layout();
  const PanelFrame panel = places.units(places.pictures()[1]);
  const auto inset = picture.inset_in(three.window().findings().walks[1], panel);
  ASSERT_TRUE(inset);
  const int x = static_cast<int>((inset->frame.x + inset->frame.width / 2) * places.unit());
  const int y = static_cast<int>((inset->frame.y + inset->frame.height / 2) * places.unit());
  three.hand().click(x, y);
  const Vec3d eye(three.shown().ray.origin);
  EXPECT_LT(glm::length(eye - inset->camera.eye), 1e-5);
  ASSERT_TRUE(three.window().findings().walks.front().hit.is_hit());
  EXPECT_EQ(three.window().findings().walks.front().hit.prim_id, hit.prim_id);
}

TEST(CompareWindow, TheCommandLineShowsTheSameAgain) {
  const VirtualScreen screen;
  WindowOfThree three;
  const PixelFrame f = three.layout().pictures()[1];
  three.hand().hold(f.x + 60, f.y + 60);
  three.hand().move(f.x + 100, f.y + 75);
  three.hand().let_go(f.x + 100, f.y + 75);
  EXPECT_NE(three.shown().azimuth, 24);
  EXPECT_NE(three.shown().elevation, 20);
  EXPECT_EQ(three.printed(), "");  // turning is no click
  three.hand().click(f.x + f.width / 2, f.y + f.height / 2);
  for (const KeySym key : {XK_m, XK_c, XK_d, XK_d}) three.hand().press(key);
  three.printed();
  const TemporaryFolder folder;
  three.window().set_picture_folder(folder.path());
  three.hand().press(XK_s);
  const std::string path = (folder.path() / "compare-1.png").string();
  EXPECT_TRUE(std::filesystem::exists(path));
  EXPECT_EQ(three.printed(), three.window().command() + " --out " + path + '\n');
  const auto json = told_by(three.window().command());
  const CompareLook& look = three.shown();
  EXPECT_EQ(json["picture"]["azimuth"], look.azimuth);
  EXPECT_EQ(json["picture"]["elevation"], look.elevation);
  EXPECT_EQ(json["against"], "kd-tree");
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(json["ray"]["origin"][axis].get<float>(), look.ray.origin[axis]);
    EXPECT_EQ(json["ray"]["direction"][axis].get<float>(), look.ray.direction[axis]);
  }
  const CompareFindings& findings = three.window().findings();
  ASSERT_EQ(findings.traced.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<std::uint32_t> work = work_of(findings.traced[i], WorkKind::all);
    const WorkStatistics s = statistics_of(std::span<const std::uint32_t>(work));
    EXPECT_EQ(json["structures"][i]["pixels"]["all"]["total"], s.total);
    EXPECT_EQ(json["structures"][i]["walk"]["nodes"], findings.walks[i].statistics().nodes);
  }
}

TEST(CompareWindow, KeysCycleAndSingleOut) {
  const VirtualScreen screen;
  WindowOfThree three;
  const CompareLook first = three.shown();
  for (const CompareKind kind :
       {CompareKind::work, CompareKind::difference, CompareKind::histogram, CompareKind::walk}) {
    three.hand().press(XK_m);
    EXPECT_EQ(three.shown().kind, kind);
    EXPECT_EQ(three.window().findings().traced.size(), kind == CompareKind::walk ? 0u : 3u);
  }
  three.hand().press(XK_2);
  EXPECT_EQ(three.shown().alone, 1u);
  EXPECT_NE(three.window().command().find("--alone 2"), std::string::npos);
  three.hand().press(XK_4);  // there are three
  EXPECT_EQ(three.shown().alone, 1u);
  three.hand().press(XK_2);
  EXPECT_FALSE(three.shown().alone);
  three.hand().press(XK_3);
  three.hand().press(XK_0);
  EXPECT_FALSE(three.shown().alone);
  for (const WorkKind kind : {WorkKind::nodes, WorkKind::candidates, WorkKind::all}) {
    three.hand().press(XK_c);
    EXPECT_EQ(three.shown().work, kind);
  }
  three.hand().press(XK_h);
  EXPECT_TRUE(three.window().has_help());
  three.hand().press(XK_h);
  EXPECT_FALSE(three.window().has_help());
  three.hand().press(XK_z);
  EXPECT_EQ(three.shown(), first);
  three.hand().press(XK_d);
  EXPECT_EQ(three.shown().against, 1u);
  three.hand().press(XK_r);
  EXPECT_EQ(three.shown(), first);
  EXPECT_FALSE(three.window().interactor().GetDone());
  three.hand().press(XK_q);
  EXPECT_TRUE(three.window().interactor().GetDone());
}

TEST(CompareWindow, FitsTheWindow) {
  const VirtualScreen screen;
  WindowOfThree three;
  three.hand().resize(1100, 700);
  EXPECT_EQ(three.window().width(), 1100);
  EXPECT_EQ(three.window().height(), 700);
}

}  // namespace
}  // namespace sightline::viz
