#include "bench/render/scaling.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/render/instructions.h"
#include "bench/verify.h"

namespace sightline::bench {
namespace {

ScalingPlan little_plan() {
  ScalingPlan plan;
  plan.scenes = {"cornell"};
  plan.threads = {1, 2};
  plan.width = 48;
  plan.height = 40;
  plan.samples = 1;
  plan.rounds = 2;
  plan.data_dir = std::filesystem::path(SIGHTLINE_SOURCE_DIR) / "data";
  return plan;
}

TEST(Scaling, TellsRaysAndSpeedUps) {
  Progress progress;
  const auto json = nlohmann::json::parse(json_text(run_scaling(little_plan(), progress)));
  const auto& scene = json.at("scenes").at(0);
  EXPECT_GT(scene.at("rays"), 48 * 40);
  EXPECT_EQ(scene.at("rows").at(0).at("speed_up").at("median"), 1);
  const double speed_up = scene.at("rows").at(1).at("speed_up").at("median");
  EXPECT_DOUBLE_EQ(scene.at("rows").at(1).at("efficiency").at("median"), speed_up / 2);
}

TEST(Scaling, RatesAreRaysOverTime) {
  ScalingReport report;
  report.plan = little_plan();
  const Estimate first{2, 1, 4, 0.95};
  report.scenes = {{"scene", "plain", 0, 8'000'000, {{1, {2}, first, Estimate{1, 1, 1, 0}}}}};
  const auto json = nlohmann::json::parse(json_text(report));
  const auto& rate = json.at("scenes").at(0).at("rows").at(0).at("rays_per_second");
  EXPECT_EQ(rate.at("median"), 4e6);
  EXPECT_EQ(rate.at("low"), 2e6);
  EXPECT_EQ(rate.at("high"), 8e6);
}

TEST(Scaling, RefusesAPictureThatIsWrong) {
  Progress progress;
  ScalingPlan plan = little_plan();
  plan.spoiled = "2";
  EXPECT_THROW(run_scaling(plan, progress), WrongHits);
}

TEST(Instructions, AreTheTotalThatCallgrindWrites) {
  EXPECT_EQ(total_of("events: Ir\nfn=(1) totals: 3\n\ntotals: 1234567890123\n"), 1'234'567'890'123u);
  EXPECT_THROW(total_of("events: Ir\n"), std::runtime_error);
  EXPECT_THROW(total_of("\ntotals: 0\n"), std::runtime_error);
}

}  // namespace
}  // namespace sightline::bench
