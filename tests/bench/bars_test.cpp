#include "bench/bars.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sightline::bench {
namespace {

TEST(Bars, AreLogarithmic) {
  EXPECT_EQ(bar_text(1), "          |          ");
  EXPECT_EQ(bar_text(2), "          |##        ");
  EXPECT_EQ(bar_text(0.25), "      ####|          ");
  EXPECT_EQ(bar_text(32), "          |##########");
}

TEST(Bars, OfWhatIsTooLongGoOn) {
  EXPECT_EQ(bar_text(1e9), "          |#########>");
  EXPECT_EQ(bar_text(1e-9), "<#########|          ");
  for (const double ratio : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(bar_text(ratio), bar_text(1)) << ratio;
  }
}

SceneReport scene(std::string name, double ratio) {
  SceneReport report;
  report.name = std::move(name);
  for (const char* contender : {"kd-tree", "embree"}) {
    ContenderReport& own = report.contenders.emplace_back();
    own.name = contender;
    Measurement& bounce = own.at[index_of(Workload::bounce)].emplace();
    bounce.rays = 1;
    bounce.round_seconds = {own.name == "embree" ? ratio : 1};
  }
  summarize(report);
  return report;
}

TEST(Bars, StandSceneBesideScene) {
  const std::vector<SceneReport> scenes{scene("teapot", 0.5), scene("sticks", 4)};
  const std::string text = bars_text(scenes, Plan{});
  EXPECT_NE(text.find("speed on bounce rays"), std::string::npos) << text;
  EXPECT_NE(text.find("kd-tree                       ##|                      |####\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("\nembree"), std::string::npos) << "it is the line in the middle";
  EXPECT_TRUE(bars_text(std::span(scenes).first(1), Plan{}).empty());
  Plan build_only;
  build_only.workloads = {Workload::build};
  EXPECT_TRUE(bars_text(scenes, build_only).empty());
}

}  // namespace
}  // namespace sightline::bench
