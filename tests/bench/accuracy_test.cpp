#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "bench/accuracy/axis.h"
#include "bench/accuracy/error_sum.h"
#include "bench/accuracy/front.h"
#include "bench/accuracy/oracle.h"
#include "bench/accuracy/run.h"

namespace sightline::bench {
namespace {

/// Rounds around a time, a hundredth up and down.
Candidate candidate(double error, double seconds) {
  Candidate made{error, {}};
  for (int i = 0; i < 9; ++i) made.round_seconds.push_back(seconds * (1 + 0.01 * (i % 3 - 1)));
  return made;
}

TEST(Front, HasWhatNothingBeatsInBoth) {
  const std::vector<Candidate> all{candidate(1, 10), candidate(2, 5), candidate(3, 7), candidate(0, 20)};
  const auto found = standings(all);
  EXPECT_EQ(found[0].place, Place::on_front);
  EXPECT_EQ(found[1].place, Place::on_front);
  EXPECT_EQ(found[3].place, Place::on_front);
  ASSERT_EQ(found[2].place, Place::dominated);
  EXPECT_EQ(found[2].by, 1u);
  EXPECT_NEAR(found[2].ratio.median, 7.0 / 5, 1e-9);
}

TEST(Front, NamesTheFastestOfThoseThatDominate) {
  const std::vector<Candidate> all{candidate(1, 10), candidate(1, 20), candidate(1, 5)};
  const auto found = standings(all);
  EXPECT_EQ(found[1].place, Place::dominated);
  EXPECT_EQ(found[1].by, 2u);
  EXPECT_EQ(found[2].place, Place::on_front);
}

TEST(Front, DoesNotDecideWhatScatters) {
  Candidate one = candidate(1, 10), other = candidate(1, 10);
  for (std::size_t i = 0; i < one.round_seconds.size(); ++i) one.round_seconds[i] *= i % 2 == 0 ? 1.2 : 0.8;
  const auto found = standings(std::vector{one, other});
  EXPECT_EQ(found[0].place, Place::not_resolved);
  EXPECT_EQ(found[0].by, 1u);
  EXPECT_EQ(found[1].place, Place::not_resolved);
}

/// No interval of a median of five has a confidence of 95 %, whatever the five say.
TEST(Front, DecidesNothingInFewRounds) {
  Candidate fast = candidate(1, 10), slow = candidate(1, 1000);
  for (const int rounds : {least_rounds - 1, least_rounds}) {
    fast.round_seconds.assign(static_cast<std::size_t>(rounds), 1);
    slow.round_seconds.assign(static_cast<std::size_t>(rounds), 2);
    const auto found = standings(std::vector{fast, slow});
    EXPECT_EQ(found[1].place, rounds < least_rounds ? Place::not_resolved : Place::dominated);
    EXPECT_EQ(found[0].place, rounds < least_rounds ? Place::not_resolved : Place::on_front);
  }
}

TEST(Front, LeavesOutWhatHasNoError) {
  const auto found = standings(std::vector{candidate(not_asked, 1), candidate(1, 10)});
  EXPECT_EQ(found[0].place, Place::unknown);
  EXPECT_EQ(found[1].place, Place::on_front);
}

TEST(ErrorSum, TellsLargestMeanAndShare) {
  ErrorSum sum;
  EXPECT_TRUE(std::isnan(sum.errors().maximum));
  EXPECT_TRUE(std::isnan(sum.errors().wrong_per_million));
  sum.add(-3), sum.add(4);
  for (int i = 0; i < 1000; ++i) sum.decide(i != 0);
  EXPECT_EQ(sum.errors().maximum, 4);
  EXPECT_DOUBLE_EQ(sum.errors().rms, std::sqrt(12.5));
  EXPECT_DOUBLE_EQ(sum.errors().wrong_per_million, 1000);
  EXPECT_EQ(sum.errors().wrong, 1u);
  EXPECT_EQ(sum.errors().decisions, 1000u);
  EXPECT_EQ(wrong_interval(sum.errors()), "177 to 5643");
  sum.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(std::isinf(sum.errors().maximum));
}

double work(int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += std::sqrt(static_cast<double>(i));
  return sum;
}

std::vector<Panel> fake_panels(const Effort& effort) {
  EXPECT_EQ(effort.seed, 5u);
  Panel panel{"fake", "of no use", "root", "of nothing", ErrorKind::maximum, 1, {}};
  panel.choices = {{"little", {1e-3, 1e-4, 7}, [] { return work(2'000); }, {{"bytes", 12}}},
                   {"much", {1e-6, 1e-7, 0}, [] { return work(200'000); }, {{"bytes", 13}}},
                   {"in vain </script>", {1e-3, 1e-4, 7}, [] { return work(400'000); }, {{"bytes", 14}}}};
  return {panel};
}

class AccuracyReportTest : public testing::Test {
 protected:
  static AccuracyReport report() {
    static const Axis axis{"fakes", "what nobody asks", fake_panels};
    AccuracyPlan plan;
    plan.axes = {&axis}, plan.rounds = 7, plan.slot_seconds = 0, plan.seed = 5;
    Progress progress;
    return run_accuracy(plan, progress, [](const AccuracyReport&, const AxisReport&) {});
  }
};

TEST_F(AccuracyReportTest, PlacesChoicesByWhatTheyTake) {
  const AccuracyReport made = report();
  const auto& choices = made.axes.at(0).panels.at(0).choices;
  EXPECT_EQ(choices[0].standing.place, Place::on_front);
  EXPECT_EQ(choices[1].standing.place, Place::on_front);
  EXPECT_EQ(choices[2].standing.place, Place::dominated);
  EXPECT_EQ(choices[2].round_seconds.size(), 7u);
  EXPECT_GT(choices[1].seconds.median, 10 * choices[0].seconds.median);
  EXPECT_GT(made.axes[0].panels[0].same.median, 0.2);
}

TEST_F(AccuracyReportTest, IsATableJsonAndAPage) {
  const AccuracyReport made = report();
  const std::string table = table_text(made.axes[0]);
  for (const char* word :
       {"fakes: what nobody asks", "little", "much", "1.0e-03", "ns/root", "front", "A/A", "bytes"}) {
    EXPECT_NE(table.find(word), std::string::npos) << word;
  }
  const auto json = nlohmann::json::parse(json_text(made));
  EXPECT_EQ(json["seed"], 5);
  const auto& choices = json["axes"][0]["panels"][0]["choices"];
  EXPECT_EQ(choices[0]["place"], "front");
  EXPECT_EQ(choices[1]["maximum_error"], 1e-6);
  EXPECT_EQ(choices[0]["round_seconds"].size(), 7u);
  EXPECT_EQ(choices[2]["place"], "dominated");
  const std::string page = page_text(made);
  EXPECT_EQ(page.find("in vain </script>"), std::string::npos);  // else the data would end there
  EXPECT_NE(page.find("in vain \\u003c/script>"), std::string::npos);
  EXPECT_EQ(page.find("http"), page.find("http://www.w3.org/2000/svg"));  // a name, not an address
}

TEST(Axes, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Axis& axis : accuracy_axes()) names.insert(axis.name);
  EXPECT_EQ(names.size(), accuracy_axes().size());
  EXPECT_EQ(names.size(), 16u);
}

TEST(Oracle, KnowsWhatIsKnown) {
  const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto inside = true_crossing(triangle, {{0.25, 0.5, -2}, {0, 0, 1}});
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->t.high, 2);
  EXPECT_EQ(inside->u.high, 0.25);
  EXPECT_EQ(inside->v.high, 0.5);
  EXPECT_TRUE(true_crossing(triangle, {{0, 0, -1}, {0, 0, 1}}));          // a corner
  EXPECT_FALSE(true_crossing(triangle, {{-0x1p-80, 0, -1}, {0, 0, 1}}));  // hardly beside it
  EXPECT_FALSE(true_crossing(triangle, {{0.25, 0.25, 0}, {1, 0, 0}}));    // edge-on
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(truly_meets(box, {{-1, 1, 1}, {1, 0, 0}}));  // along an edge
  EXPECT_FALSE(truly_meets(box, {{-1, 1 + 0x1p-50, 1}, {1, 0, 0}}));
  EXPECT_FALSE(truly_meets(box, {{2, 0.5, 0.5}, {1, 0, 0}}));  // behind
  const auto roots = true_quadratic_roots(1, -1.5, 2);         // (t - 1) (t - 2)
  ASSERT_EQ(roots.size(), 2u);
  EXPECT_EQ(roots[0].high, 1);
  EXPECT_EQ(roots[1].off(2), 0);
  EXPECT_EQ(true_quadratic_roots(1, -1, 1).size(), 1u);
  EXPECT_EQ(true_quadratic_roots(1, -1, 1 + 0x1p-52).size(), 0u);
  EXPECT_EQ(true_sphere_roots({0, 0, 0}, 1, {{-3, 1, 0}, {1, 0, 0}}).size(), 1u);
  const auto torus = true_torus_roots(0.25, {{-3, 0, 0}, {1, 0, 0}});
  ASSERT_EQ(torus.size(), 4u);
  EXPECT_LT(std::fabs(torus[0].off(1.75)), 0x1p-100);
  EXPECT_LT(std::fabs(torus[3].off(4.25)), 0x1p-100);
  EXPECT_EQ(true_torus_roots(0.25, {{-3, 0, 0.25}, {1, 0, 0}}).size(), 2u);  // touches on top, twice
  const auto walk = true_walk({1, 0, 0, 1}, {1, 0, 0}, 3);                   // three quarters of a square
  EXPECT_EQ(walk[0].high, 0);
  EXPECT_EQ(walk[1].high, 1);
}

}  // namespace
}  // namespace sightline::bench
