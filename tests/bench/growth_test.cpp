#include "bench/growth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "bench/json.h"

namespace sightline::bench {
namespace {

TEST(PowerFit, FindsAPowerLaw) {
  const std::vector<double> x{10, 100, 1000, 5000};
  std::vector<double> y;
  for (const double each : x) y.push_back(3 * std::pow(each, 0.7));
  const auto fit = fit_power(x, y);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->exponent, 0.7, 1e-12);
  EXPECT_NEAR(fit->factor, 3, 1e-11);
  EXPECT_NEAR(fit->standard_error.value(), 0, 1e-12);
}

/// By hand: x = e^0, e^1, e^2 and y = e^0, e^2, e^1 have a slope of 1/2, residuals -1/2, 1, -1/2, and Sxx = 2.
TEST(PowerFit, StandardErrorIsTheTextbooks) {
  const double e = std::exp(1.0);
  const auto fit = fit_power(std::vector{1.0, e, e * e}, std::vector{1.0, e * e, e});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->exponent, 0.5, 1e-12);
  EXPECT_NEAR(fit->standard_error.value(), std::sqrt(1.5 / 1 / 2), 1e-12);
}

TEST(PowerFit, SaysNoMoreThanItCan) {
  EXPECT_FALSE(fit_power({}, {}));
  EXPECT_FALSE(fit_power(std::vector{5.0}, std::vector{1.0}));
  EXPECT_FALSE(fit_power(std::vector{5.0, 5.0}, std::vector{1.0, 2.0})) << "one size only";
  const auto two = fit_power(std::vector{1.0, 4.0}, std::vector{1.0, 2.0});
  ASSERT_TRUE(two);
  EXPECT_NEAR(two->exponent, 0.5, 1e-12);
  EXPECT_FALSE(two->standard_error);
  EXPECT_THROW(fit_power(std::vector{1.0}, {}), std::invalid_argument);
}

TEST(Growth, SizesAreTwoADecade) {
  EXPECT_EQ(growth_scenes("soup", 3000), (std::vector<std::string>{"soup:1000", "soup:3162"}));
  EXPECT_EQ(growth_scenes("soup", most_growth_limit).back(), "soup:10000000");
  EXPECT_EQ(growth_scenes("terrain", most_growth_limit).front(), "terrain:22");
  EXPECT_EQ(growth_scenes("terrain", most_growth_limit).back(), "terrain:2236");
  EXPECT_TRUE(is_growth_family("terrain"));
  EXPECT_FALSE(is_growth_family("teapot"));
}

SceneReport scene(std::size_t triangles, bool has_slow) {
  SceneReport report;
  report.triangles = triangles;
  const auto add = [&](const char* name, double exponent) {
    ContenderReport& contender = report.contenders.emplace_back();
    contender.name = name;
    Measurement& build = contender.at[index_of(Workload::build)].emplace();
    build.rays = 1;
    build.round_seconds = {std::pow(static_cast<double>(triangles), exponent)};
    Measurement& primary = contender.at[index_of(Workload::primary)].emplace();
    primary.rays = triangles;  // seconds a ray do not grow, however many there are
    primary.round_seconds = {2.0 * static_cast<double>(triangles)};
  };
  add("kd-tree", 1.1);
  if (has_slow) add("slow", 2);
  summarize(report);
  return report;
}

TEST(Growth, FitsEachContenderOverTheSizesThatItHas) {
  const std::vector<SceneReport> scenes{scene(1000, true), scene(3000, true), scene(10'000, false)};
  const auto lines = growth_of(scenes);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NEAR(lines[0].fit[index_of(Workload::build)]->exponent, 1.1, 1e-9);
  EXPECT_NEAR(lines[0].fit[index_of(Workload::primary)]->exponent, 0, 1e-9);
  EXPECT_EQ(lines[0].left_out_from, 0u);
  EXPECT_NEAR(lines[1].fit[index_of(Workload::build)]->exponent, 2, 1e-9);
  EXPECT_EQ(lines[1].left_out_from, 10'000u);
  EXPECT_FALSE(lines[0].fit[index_of(Workload::shadow)]);

  Plan plan;
  plan.growth = "soup";
  plan.workloads = {Workload::build, Workload::primary};
  const std::string text = growth_text(scenes, plan);
  EXPECT_NE(text.find("1.10 +- 0.00"), std::string::npos) << text;
  EXPECT_NE(text.find("slow is left out from 10,000 triangles on"), std::string::npos) << text;

  const auto json = nlohmann::json::parse(json_text({Machine{}, plan, scenes}, lines));
  EXPECT_EQ(json["growth"]["family"], "soup");
  EXPECT_NEAR(json["growth"]["contenders"][0]["fits"]["build"]["exponent"].get<double>(), 1.1, 1e-9);
  EXPECT_EQ(json["growth"]["contenders"][1]["left_out_from"], 10'000);
  EXPECT_TRUE(json["summary"].is_null());
}

}  // namespace
}  // namespace sightline::bench
