#include "bench/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/json.h"
#include "bench/prices.h"
#include "bench/summary.h"
#include "bench/table.h"

namespace sightline::bench {
namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

ContenderReport contender(std::string name, Contender::Kind kind, std::vector<double> seconds) {
  ContenderReport report;
  report.name = std::move(name);
  report.kind = kind;
  report.bytes = {.structure = 300, .leaves = std::nullopt};
  report.bytes_when_built = 300;
  Measurement& own = report.at[index_of(Workload::primary)].emplace();
  own.rays = 1'000'000;
  own.iterations = 1;
  own.rounds = static_cast<int>(seconds.size());
  own.round_seconds = std::move(seconds);
  return report;
}

struct Example {
  Example() {
    scene.name = "teapot";
    scene.triangles = 10;
    scene.contenders.push_back(contender("kd-tree", Contender::Kind::ours, {2, 8, absent}));
    scene.contenders.back().at[index_of(Workload::primary)]->stats = TraversalStats{5'000'000, 1'000'000, 2'500'000, 0};
    scene.contenders.push_back(contender("embree", Contender::Kind::peer, {1, 2, 100}));
    plan.workloads = {Workload::primary};
    plan.rounds = 3;
    summarize(scene);
  }
  SceneReport scene;
  Plan plan;
};

/// The machine was four times slower in the second round; its ratio says nothing of that.
TEST(Report, RatiosArePairedByRound) {
  const Example example;
  const Measurement& own = *example.scene.contenders[0].at[index_of(Workload::primary)];
  EXPECT_EQ(own.ratio->median, 0.5 * (1.0 / 2 + 2.0 / 8));
  EXPECT_EQ(own.ratio->low, 0.25);
  EXPECT_EQ(own.ratio->high, 0.5);
  EXPECT_EQ(own.mrays_per_second()->median, 0.2);
  EXPECT_EQ(example.scene.contenders[1].at[index_of(Workload::primary)]->ratio->median, 1);
}

/// Fewer rays of one contender do not make it faster.
TEST(Report, RatiosArePerRay) {
  Example example;
  example.scene.contenders[0].at[index_of(Workload::primary)]->rays = 1000;
  summarize(example.scene);
  EXPECT_DOUBLE_EQ(example.scene.contenders[0].at[index_of(Workload::primary)]->ratio->high, 0.0005);
}

TEST(Report, WithoutThePeerThereIsNoRatio) {
  Example example;
  example.scene.contenders.pop_back();
  summarize(example.scene);
  EXPECT_FALSE(example.scene.contenders[0].at[index_of(Workload::primary)]->ratio);
  EXPECT_NE(table_text(example.scene, example.plan).find("kd-tree"), std::string::npos);
}

TEST(Report, JsonHoldsEverything) {
  const Example example;
  const auto json = nlohmann::json::parse(json_text({Machine{}, example.plan, {example.scene}}));
  const auto& entry = json["scenes"][0]["contenders"][0];
  EXPECT_EQ(json["scenes"][0]["name"], "teapot");
  EXPECT_EQ(json["scenes"][0]["triangles"], 10);
  EXPECT_EQ(entry["name"], "kd-tree");
  EXPECT_EQ(entry["kind"], "ours");
  EXPECT_EQ(entry["bytes_per_primitive"], 30);
  EXPECT_TRUE(entry["build_seconds"].is_null());
  const auto& primary = entry["workloads"]["primary"];
  EXPECT_EQ(primary["mrays_per_second"], 0.2);
  EXPECT_EQ(primary["ratio_to_embree"], 0.375);
  EXPECT_EQ(primary["nodes_per_ray"], 5);
  EXPECT_EQ(primary["leaves_per_ray"], 1);
  EXPECT_EQ(primary["candidates_per_ray"], 2.5);
  EXPECT_EQ(primary["round_seconds"], nlohmann::json::array({2, 8, nullptr}));
  EXPECT_EQ(json["scenes"][0]["contenders"][1]["kind"], "peer");
  EXPECT_TRUE(json["scenes"][0]["contenders"][1]["workloads"]["primary"]["nodes_per_ray"].is_null());
}

/// Ratios 1/2, 1/4 on one scene and 2, 9 on the other: geometric means 1, 3/2.
TEST(Report, SummaryIsTheGeometricMeanRoundByRound) {
  Example one, other;
  other.scene.contenders[0] = contender("kd-tree", Contender::Kind::ours, {1, 1, 1});
  other.scene.contenders[0].bytes.structure = 1200;
  other.scene.contenders[1] = contender("embree", Contender::Kind::peer, {2, 9, 1});
  const std::vector<SceneReport> scenes{one.scene, other.scene};
  const auto lines = summary_of(scenes);
  ASSERT_EQ(lines.size(), 2u);
  const auto& ratio = lines[0].ratio[index_of(Workload::primary)];
  ASSERT_TRUE(ratio);
  EXPECT_DOUBLE_EQ(ratio->low, 1);
  EXPECT_DOUBLE_EQ(ratio->high, 1.5) << "the third round is missing on one scene";
  EXPECT_DOUBLE_EQ(ratio->median, 1.25);
  EXPECT_DOUBLE_EQ(*lines[0].bytes_per_triangle, 60) << "of 30 and 120";
  EXPECT_FALSE(lines[0].ratio[index_of(Workload::build)]);
  EXPECT_DOUBLE_EQ(lines[1].ratio[index_of(Workload::primary)]->median, 1);

  EXPECT_NE(summary_text(scenes, one.plan).find("all 2 scenes"), std::string::npos);
  EXPECT_TRUE(summary_text(std::span(scenes).first(1), one.plan).empty());
  const auto json = nlohmann::json::parse(json_text({Machine{}, one.plan, scenes}));
  EXPECT_EQ(json["summary"][0]["name"], "kd-tree");
  EXPECT_DOUBLE_EQ(json["summary"][0]["ratio_to_embree"]["primary"]["median"], 1.25);
}

TEST(Report, SummaryNeedsThePeerOnEveryScene) {
  Example one, other;
  other.scene.contenders.pop_back();
  const auto lines = summary_of(std::vector<SceneReport>{one.scene, other.scene});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].ratio[index_of(Workload::primary)]);
}

/// A structure asked at both levels and in a stream, and another one. Only the first was built, in 5 seconds.
struct PricedExample : Example {
  PricedExample() {
    plan.workloads = {Workload::build, Workload::primary};
    plan.levels = {Level::watertight, Level::fast};
    plan.is_stream = true;
    scene.contenders.clear();
    const auto add = [&](const char* label, const Asking& asking, std::vector<double> seconds) {
      ContenderReport& own =
          scene.contenders.emplace_back(contender(name_of(label, asking), Contender::Kind::ours, std::move(seconds)));
      own.asking = asking;
      own.level = asking.level;
      Measurement& build = own.at[index_of(Workload::build)].emplace();
      build.rays = 1;
      build.round_seconds.assign(3, absent);
    };
    add("wide-tree", {}, {2, 8, 6});
    add("wide-tree", {Level::watertight, true}, {1, 2, 3});
    add("wide-tree", {Level::fast, false}, {1, 2, absent});
    add("kd-tree", {}, {1, 1, 1});
    scene.contenders[0].at[index_of(Workload::build)]->round_seconds = {5, 5, 5};
    scene.contenders[1].built_as = scene.contenders[2].built_as = 0;
    summarize(scene);
  }
};

TEST(Prices, AreOfOneChoicePairedByRound) {
  const PricedExample example;
  const auto prices = prices_of(std::span(&example.scene, 1));
  ASSERT_EQ(prices.size(), 2u) << "the stream is watertight: it has no price over fast single rays";
  EXPECT_EQ(prices[0].name, "wide-tree");
  EXPECT_EQ(prices[0].over, "wide-tree fast");
  const auto& ratio = prices[0].ratio[index_of(Workload::primary)];
  EXPECT_EQ(ratio->low, 2);
  EXPECT_EQ(ratio->high, 4);
  EXPECT_EQ(ratio->median, 3) << "of the two rounds that both took part in";
  EXPECT_FALSE(prices[0].ratio[index_of(Workload::build)]);
  EXPECT_EQ(prices[1].over, "wide-tree stream");
  EXPECT_EQ(prices[1].ratio[index_of(Workload::primary)]->median, 2);
  const Example asked_in_one_way;
  EXPECT_TRUE(prices_of(std::span(&asked_in_one_way.scene, 1)).empty());
}

TEST(Prices, OfSeveralScenesAreGeometricMeans) {
  const PricedExample one;
  PricedExample other;
  other.scene.contenders[2].at[index_of(Workload::primary)]->round_seconds = {0.25, 1, absent};
  const auto prices = prices_of(std::vector<SceneReport>{one.scene, other.scene});
  EXPECT_DOUBLE_EQ(prices[0].ratio[index_of(Workload::primary)]->low, 4) << "of 2 and 8";
}

TEST(Prices, OneStructureIsBuiltOnce) {
  const PricedExample example;
  EXPECT_EQ(example.scene.contenders[2].at[index_of(Workload::build)]->seconds->median, 5);
  const std::string text = table_text(example.scene, example.plan);
  EXPECT_NE(text.find("wide-tree over wide-tree fast"), std::string::npos) << text;
  EXPECT_NE(text.find("5000"), std::string::npos) << text;
  EXPECT_EQ(text.find("5000"), text.rfind("5000")) << text;

  const auto json = nlohmann::json::parse(json_text({Machine{}, example.plan, {example.scene}}));
  EXPECT_EQ(json["plan"]["levels"], (nlohmann::json{"watertight", "fast"}));
  const auto& contenders = json["scenes"][0]["contenders"];
  EXPECT_EQ(contenders[2]["level"], "fast");
  EXPECT_EQ(contenders[1]["stream"], true);
  EXPECT_EQ(contenders[2]["build_seconds"]["median"], 5);
  const auto& price = json["scenes"][0]["prices"][0];
  EXPECT_EQ(price["over"], "wide-tree fast");
  EXPECT_EQ(price["time_ratio"]["primary"]["median"], 3);
}

TEST(Report, TableIsAligned) {
  const Example example;
  const std::string text = table_text(example.scene, example.plan);
  std::vector<std::size_t> ends;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("structure") || line.starts_with("kd-tree")) ends.push_back(line.size());
  }
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0], ends[1]);
}

}  // namespace
}  // namespace sightline::bench
