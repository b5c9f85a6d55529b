/// All pages in one window, on a screen in memory, by events that come from the X server as a hand's would.

#include "viz/pages/one_window.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "tests/io/temporary_folder.h"
#include "viz/command_text.h"
#include "viz/view.h"
#include "viz/virtual_screen.h"

// X defines words that others use; so last.
#include "tests/viz/hand.h"

namespace sightline::viz {
namespace {

constexpr int width = 1200, height = 751;

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What pages print is not what these tests are about.
class Quiet {
 public:
  Quiet() : usual_(std::cout.rdbuf(printed_.rdbuf())) {}
  ~Quiet() { std::cout.rdbuf(usual_); }

 private:
  std::ostringstream printed_;
  std::streambuf* usual_;
};

class WindowOfPages {
 public:
  explicit WindowOfPages(const PageState& state = {.scene = "teapot:3"}, const char* page = "partitions")
      : window_(state, *page_named(page), width, height, {},
                [](const auto& words, WindowFrame* frame) { return run_view(words, "", frame); }),
        hand_(window_.frame().interactor()) {}

  OneWindow& window() { return window_; }
  Hand& hand() { return hand_; }
  std::string name() const { return std::string(page_infos[window_.page()].name); }
  std::vector<std::string> words() const { return words_of(window_.shown().command()); }
  std::string value(const std::string& option) const { return value_in(words(), option).value_or(""); }

 private:
  Quiet quiet_;
  OneWindow window_;
  Hand hand_;
};

TEST(OneWindow, EveryPageIsItsCommand) {
  const VirtualScreen screen;
  const TemporaryFolder folder;
  WindowOfPages pages;
  for (std::size_t page = 0; page < page_infos.size(); ++page) {
    SCOPED_TRACE(page_infos[page].name);
    pages.hand().press(static_cast<KeySym>(XK_F1 + page));
    ASSERT_EQ(pages.window().page(), page);
    EXPECT_EQ(pages.window().message(), "");
    if (page_infos[page].has_camera) {
      pages.hand().hold(500, 400);
      pages.hand().move(540, 430);
      pages.hand().let_go(540, 430);
    }
    pages.hand().press(XK_Down);
    if (pages.name() == "noise") pages.hand().press(XK_3);  // one panel, which takes less time than all
    pages.hand().press(XK_h);
    EXPECT_TRUE(pages.window().shown().has_help());
    if (pages.name() == "compare" || pages.name() == "csg") continue;  // they have tests of their own
    const std::string shown = (folder.path() / "shown.png").string(), told = (folder.path() / "told.png").string();
    pages.window().shown().write_png(shown);
    std::vector<std::string> words = pages.words();
    ASSERT_EQ(words.at(0), "sightline-view");
    ASSERT_EQ(words.at(1), page_infos[page].name);
    words.erase(words.begin());
    words.insert(words.end(), {"--out", told});
    EXPECT_EQ(run_view(words, ""), 0);
    EXPECT_TRUE(bytes_of(shown) == bytes_of(told)) << pages.window().shown().command();
  }
}

TEST(OneWindow, CarriesSceneStructureRayAndCamera) {
  const VirtualScreen screen;
  WindowOfPages pages({.accelerator = "box-tree", .scene = "teapot:3"});
  pages.hand().press(XK_F2);
  EXPECT_EQ(pages.value("--accel"), "box-tree");
  const std::string usual = pages.value("--ray");
  pages.hand().hold(400, 300);
  pages.hand().move(440, 310);
  pages.hand().let_go(440, 310);
  pages.hand().click(400, 300);
  const std::string ray = pages.value("--ray"), azimuth = pages.value("--azimuth");
  EXPECT_NE(ray, usual);
  EXPECT_NE(azimuth, "");
  for (const KeySym key : {XK_F4, XK_F5, XK_F7, XK_F2}) {
    pages.hand().press(key);
    if (key == XK_F7) continue;
    EXPECT_EQ(pages.value("--ray"), ray) << pages.name();
    EXPECT_EQ(pages.value("--azimuth"), azimuth) << pages.name();
    EXPECT_EQ(pages.value("--scene"), "teapot:3") << pages.name();
  }
  EXPECT_EQ(pages.value("--accel"), "box-tree");
}

TEST(OneWindow, TheBarSwitchesAndAChangesTheStructure) {
  const VirtualScreen screen;
  WindowOfPages pages;
  pages.hand().click(static_cast<int>(pages.window().place_of(2)), 20);
  EXPECT_EQ(pages.name(), "build");
  const std::string before = pages.value("--accel");
  pages.hand().press(XK_a);
  EXPECT_EQ(pages.name(), "build");
  EXPECT_NE(pages.value("--accel"), before);
  EXPECT_EQ(pages.window().message(), "");
  // A page is left as it was, and found so again.
  pages.hand().press(XK_Right);
  const std::string step = pages.value("--step");
  EXPECT_EQ(step, "1");
  pages.hand().press(XK_F8);
  EXPECT_EQ(pages.name(), "graph");
  pages.hand().press(XK_F3);
  EXPECT_EQ(pages.value("--step"), step);
  pages.hand().press(XK_q);
  EXPECT_TRUE(pages.window().frame().interactor().GetDone());
}

TEST(OneWindow, AClickOnTheHeatMapWalksThatRay) {
  const VirtualScreen screen;
  WindowOfPages pages({.scene = "teapot:3"}, "heat");
  pages.hand().click(width / 2, height / 2);
  EXPECT_EQ(pages.name(), "walk");
  const std::string ray = pages.value("--ray");
  pages.hand().press(XK_F4);
  EXPECT_EQ(pages.value("--ray"), ray);
}

TEST(OneWindow, FitsItsPagesWhenItsSizeChanges) {
  const VirtualScreen screen;
  WindowOfPages pages;
  pages.hand().resize(1250, 800);
  EXPECT_EQ(pages.value("--size"), "1250x" + std::to_string(800 - WindowBar::height - WindowFrame::foot_height));
  pages.hand().press(XK_F2);
  EXPECT_EQ(pages.value("--size"), "1250x" + std::to_string(800 - WindowBar::height));
}

TEST(OneWindow, TellsWhatAPageRefuses) {
  const VirtualScreen screen;
  WindowOfPages pages({.accelerator = "brute-force", .scene = "teapot:3"});
  pages.hand().press(XK_F3);
  EXPECT_EQ(pages.name(), "partitions");
  EXPECT_NE(pages.window().message().find("--accel brute-force: expected one of"), std::string::npos)
      << pages.window().message();
}

TEST(CommandText, IsReadBack) {
  const std::vector<std::string> words{"walk", "--scene", "it's a mesh.ply", "--ray=-1,2", "", "a\\b"};
  std::string command;
  for (const std::string& word : words) command += (command.empty() ? "" : " ") + quoted(word);
  EXPECT_EQ(words_of(command), words);
}

TEST(PageWords, KeepWhatAPageWasLeftWith) {
  PageState state{.accelerator = "bih", .scene = "dragon:3", .settings = {"kd-tree.max_depth=3", "bih.lazy=true"}};
  const PageInfo& build = page_infos[*page_named("build")];
  const auto fresh = page_words(build, state, "1200x700");
  EXPECT_EQ(fresh, (std::vector<std::string>{"build", "--accel=bih", "--scene=dragon:3", "--set=bih.lazy=true",
                                             "--size=1200x700"}));
  const std::vector<std::string> left{"build", "--accel", "bih", "--scene", "dragon:3", "--step", "7"};
  EXPECT_EQ(value_in(page_words(build, state, "1200x700", left), "--step"), "7");
  state.accelerator = "kd-tree";
  EXPECT_FALSE(value_in(page_words(build, state, "1200x700", left), "--step"));
}

}  // namespace
}  // namespace sightline::viz
