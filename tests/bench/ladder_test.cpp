#include "bench/render/ladder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "bench/verify.h"

namespace sightline::bench {
namespace {

LadderPlan little_plan() {
  LadderPlan plan;
  plan.width = 40;
  plan.height = 30;
  plan.rounds = 1;
  plan.data_dir = std::filesystem::path(SIGHTLINE_SOURCE_DIR) / "data";
  return plan;
}

TEST(Ladder, HasARungForEachEffectOnOneBelow) {
  Effects all;
  std::vector<std::string> below{""};
  for (const Rung& rung : make_ladder(little_plan().data_dir)) {
    EXPECT_NE(std::find(below.begin(), below.end(), rung.over), below.end()) << rung.name;
    below.push_back(rung.name);
    all = all | rung.adds;
  }
  EXPECT_EQ(all.count(), static_cast<int>(effect_count));
}

TEST(Ladder, CountsWhatARungIsThereFor) {
  Progress progress;
  const LadderReport report = run_ladder(little_plan(), progress);
  const Effects uncounted{Effect::instances, Effect::solids};
  for (const RungReport& row : report.rungs) {
    EXPECT_GE(row.counters.camera_rays, 40u * 30 * row.rung.samples) << row.rung.name;
    EXPECT_TRUE(row.seconds) << row.rung.name;
    EXPECT_EQ(row.over.has_value(), !row.rung.over.empty()) << row.rung.name;
    if (row.rung.effect && !uncounted.has(*row.rung.effect)) {
      EXPECT_GT(row.counters[*row.rung.effect], 0u) << row.rung.name;
    }
  }
}

TEST(Ladder, RefusesAPictureThatIsWrong) {
  Progress progress;
  LadderPlan plan = little_plan();
  plan.spoiled = "fog";
  try {
    run_ladder(plan, progress);
    FAIL() << "expected to be refused";
  } catch (const WrongHits& error) {
    EXPECT_NE(std::string(error.what()).find("fog is wrong"), std::string::npos) << error.what();
  }
}

TEST(Ladder, FindsWhatIsCountedThoughOff) {
  RenderCounters counters;
  counters.camera_rays = 9;
  counters[Effect::hard_shadow] = 5;
  EXPECT_EQ(counted_though_off({Effect::hard_shadow}, counters), std::nullopt);
  EXPECT_EQ(counted_though_off({Effect::soft_shadow}, counters), Effect::hard_shadow);
}

TEST(Ladder, ResolvesWhatIsNotOne) {
  RungReport row;
  EXPECT_FALSE(row.is_resolved());
  row.over = Estimate{1.1, 0.9, 1.2, 0.95};
  EXPECT_FALSE(row.is_resolved());
  row.over = Estimate{1.1, 1, 1.2, 0.95};
  EXPECT_FALSE(row.is_resolved());
  row.over = Estimate{1.1, 1.05, 1.2, 0.95};
  EXPECT_TRUE(row.is_resolved());
  row.over = Estimate{0.9, 0.8, 0.95, 0.95};
  EXPECT_TRUE(row.is_resolved());
}

}  // namespace
}  // namespace sightline::bench
