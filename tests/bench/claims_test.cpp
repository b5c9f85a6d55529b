#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "bench/claims/order_tree.h"
#include "bench/claims/point_tree.h"
#include "bench/claims/rules.h"
#include "bench/claims/run.h"
#include "bench/claims/tools.h"
#include "bench/verify.h"
#include "sightline/math/random.h"
#include "sightline/query/queries.h"
#include "sightline/scene/procedural.h"

namespace sightline::bench {
namespace {

using enum Condition::Kind;

Figure measured(double median, double half_width) {
  return {"figure", {median, median - half_width, median + half_width, 0.95}, "x"};
}

TEST(ClaimRules, KnowOnWhichSideAnIntervalIs) {
  EXPECT_EQ(side_of({2, 1.5, 2.5, 0.95}, 1), Side::above);
  EXPECT_EQ(side_of({2, 1.5, 2.5, 0.95}, 3), Side::below);
  EXPECT_EQ(side_of({2, 1.5, 2.5, 0.95}, 2.4), Side::unclear);
  EXPECT_EQ(side_of({2, 2, 2, 1}, 2), Side::unclear);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(side_of({nan, nan, nan, 0}, 1), Side::unclear);
}

TEST(ClaimRules, MakeEachVerdict) {
  const Condition good{needed, measured(2, 0.1), Side::above, 1}, bad{needed, measured(0.5, 0.1), Side::above, 1},
      open{needed, measured(1, 0.1), Side::above, 1}, wish{wanted, measured(0.5, 0.1), Side::below, 1},
      lost{wanted, measured(0.5, 0.1), Side::above, 1}, vague{wanted, measured(1, 0.1), Side::above, 1};
  const auto verdict = [](std::vector<Condition> all) { return judge(all).verdict; };
  EXPECT_EQ(verdict({good, wish}), Verdict::holds);
  EXPECT_EQ(verdict({good, lost}), Verdict::with_limit);
  EXPECT_EQ(verdict({good, lost, vague}), Verdict::with_limit);
  EXPECT_EQ(verdict({good, vague}), Verdict::not_resolved);
  EXPECT_EQ(verdict({good, open, lost}), Verdict::not_resolved);
  EXPECT_EQ(verdict({good, open, bad, wish}), Verdict::fails);
  EXPECT_EQ(verdict({}), Verdict::not_resolved);
}

TEST(ClaimRules, NameWhatDecided) {
  std::vector<Condition> all(5, {wanted, {"time of a ray", {0.5, 0.4, 0.6, 0.95}, "x"}, Side::above, 1});
  Finding finding;
  conclude(finding, all, "Not for rays");
  EXPECT_EQ(finding.verdict, Verdict::with_limit);
  EXPECT_EQ(finding.reason.find("Not for rays: time of a ray is 0.500x (0.400 to 0.600), not above 1; "), 0u);
  EXPECT_NE(finding.reason.find("and 2 more like that."), std::string::npos);
  all[0].kind = needed;
  conclude(finding, all, "Not for rays");
  EXPECT_EQ(finding.verdict, Verdict::fails);
  EXPECT_EQ(finding.reason.find("Not for rays"), std::string::npos);
}

TEST(ClaimRules, TakeStudentsIntervalOfAnExponent) {
  const Growth exact = growth_of("", "", "", {1, 10, 100, 1000}, {3, 30, 300, 3000});
  EXPECT_NEAR(exponent_of(exact).median, 1, 1e-12);
  EXPECT_NEAR(exponent_of(exact).high - exponent_of(exact).low, 0, 1e-6);
  const Growth scattered = growth_of("", "", "", {1, 10, 100, 1000}, {3, 33, 270, 3100});
  const Estimate estimate = exponent_of(scattered);
  EXPECT_NEAR(estimate.high - estimate.median, 4.303 * *scattered.fit->standard_error, 1e-9);  // two degrees of freedom
  EXPECT_EQ(side_of(exponent_of(growth_of("", "", "", {1, 10}, {3, 30})), 5), Side::unclear);
}

TEST(ClaimTools, GrowInHalfDecades) {
  EXPECT_EQ(growing_sizes({}, 100'000, 0), (std::vector<std::size_t>{1000, 3162, 10'000, 31'623, 100'000}));
  Effort little;
  little.share = 0.02;
  EXPECT_EQ(growing_sizes(little, 10'000, 0), (std::vector<std::size_t>{20, 63, 200}));
}

TEST(ClaimTools, RefuseHitsThatDiffer) {
  const auto soup = std::make_shared<const TriangleMesh>(make_soup(100));
  auto moved = soup->positions();
  for (Vec3f& p : moved) p.x += 0.01f;
  const auto other = std::make_shared<const TriangleMesh>(moved, soup->triangles());
  const auto rays = mixed_rays(soup, 100, 1);
  const std::vector<TracerPtr> same{traced("kd-tree", soup), traced("bih:lazy=true", soup)},
      different{traced("kd-tree", soup), traced("box-tree", other)};
  EXPECT_NO_THROW(require_same_hits("soup", same, rays));
  EXPECT_THROW(require_same_hits("soup", different, rays), WrongHits);
}

TEST(ClaimTools, TimeLinesInTurns) {
  const auto work = [](int count) {
    return Line{[count] {
                  double sum = 0;
                  for (int i = 0; i < count; ++i) sum += std::sqrt(static_cast<double>(i));
                  return sum;
                },
                static_cast<double>(count)};
  };
  Effort effort;
  effort.rounds = 5, effort.share = 0.01;
  const Line lines[] = {work(20'000), work(200'000)};
  const Times times = time_lines(effort, "roots", lines);
  EXPECT_EQ(times.rounds(1).size(), 5u);
  EXPECT_GT(times.nanoseconds(0).median, 0.05);
  const Estimate ratio = times.ratio(1, 0);  // of a unit, so about 1
  EXPECT_GT(ratio.median, 0.2);
  EXPECT_LT(ratio.median, 5);
}

TEST(PointTree, FindsWhatIsInARange) {
  Random random(3);
  std::vector<std::array<float, 3>> points(500);
  for (auto& p : points) {
    for (float& x : p) x = static_cast<float>(random.below(8));  // many are equal
  }
  const auto balanced = PointTree<3>::balanced(points);
  PointTree<3> grown;
  for (const auto& p : points) grown.insert(p);
  for (int i = 0; i < 100; ++i) {
    std::array<float, 3> lo, hi;
    std::uint64_t inside = 0;
    for (std::size_t a = 0; a < 3; ++a) lo[a] = static_cast<float>(random.below(8)), hi[a] = lo[a] + 2;
    for (const auto& p : points) {
      inside += lo[0] <= p[0] && p[0] <= hi[0] && lo[1] <= p[1] && p[1] <= hi[1] && lo[2] <= p[2] && p[2] <= hi[2];
    }
    EXPECT_EQ(balanced.search(lo, hi).reported, inside);
    EXPECT_EQ(grown.search(lo, hi).reported, inside);
    EXPECT_LT(balanced.search(lo, hi).visited, 500u);
  }
  PointTree<3> sorted;
  std::uint64_t compared = 0;
  for (int i = 0; i < 100; ++i) compared += sorted.insert({float(i), float(i), float(i)});
  EXPECT_EQ(compared, 100u * 99 / 2);
}

struct Walked {
  const OrderTree& tree;
  ChildOrder order;

  template <class Visit>
  void traverse(const Ray<float>& ray, const Visit& visit, VolumeTests& tests) const {
    tree.traverse(ray, order, visit, tests);
  }
};

TEST(OrderTree, FindsTheSameHitsHoweverItIsGrouped) {
  const auto mesh = std::make_shared<const TriangleMesh>(make_integers(300));
  const auto rays = mixed_rays(mesh, 400, 1);
  ASSERT_EQ(rays.size(), 400u);
  std::vector<Hit<float>> expected(rays.size());
  traced("brute-force", mesh)->closest_hits(std::span<const Ray<float>>(rays), std::span(expected));
  std::vector<std::uint32_t> ids(mesh->size());
  std::iota(ids.begin(), ids.end(), 0u);
  std::uint64_t unsorted = 0;
  for (const bool is_sorted : {false, true}) {
    const OrderTree tree(*mesh, ids, is_sorted);
    const IndexedLeaves<TriangleMesh> leaves(*mesh, tree.leaf_order());
    for (const ChildOrder order : {ChildOrder::as_they_come, ChildOrder::nearer_first}) {
      VolumeTests tests;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(closest_hit(Walked{tree, order}, leaves, rays[i], tests), expected[i]);
      }
      if (!is_sorted) unsorted = tests.volumes;
      EXPECT_TRUE(!is_sorted || tests.volumes < unsorted);
    }
  }
}

TEST(Claims, HaveNamesAndAllThatTheySay) {
  std::set<std::string_view> names;
  for (const Claim& claim : claims()) {
    names.insert(claim.name);
    EXPECT_NE(claim.measure, nullptr) << claim.name;
    for (const std::string_view text : {claim.statement, claim.experiment, claim.rule}) {
      EXPECT_TRUE(text.ends_with('.')) << text;
    }
  }
  EXPECT_EQ(names.size(), claims().size());
  for (const char* name : {"bsp_cost", "kd_build", "kd_search", "lazy_bih", "bounding_spheres", "unordered_hierarchies",
                           "grid_cells", "matrices", "csg", "noise"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

/// As small as they can be: what comes out says nothing but has its form.
class SmallClaims : public testing::Test {
 protected:
  static const ClaimsReport& report() {
    static const ClaimsReport made = [] {
      ClaimsPlan plan;
      plan.is_quick = true, plan.rounds = 3, plan.share = 0.1;
      for (const Claim& claim : claims()) plan.claims.push_back(&claim);
      Progress progress;
      return run_claims(plan, progress, [](const ClaimsReport&, const ClaimReport&) {});
    }();
    return made;
  }
};

TEST_F(SmallClaims, HaveFiguresInOrderAndAReason) {
  ASSERT_EQ(report().claims.size(), claims().size());
  for (const ClaimReport& claim : report().claims) {
    EXPECT_FALSE(claim.finding.figures.empty()) << claim.claim->name;
    EXPECT_FALSE(claim.finding.reason.empty()) << claim.claim->name;
    for (const Figure& figure : claim.finding.figures) {
      EXPECT_LE(figure.value.low, figure.value.median) << figure.name;
      EXPECT_LE(figure.value.median, figure.value.high) << figure.name;
    }
    for (const Growth& growth : claim.finding.growths) {
      EXPECT_EQ(growth.x.size(), growth.y.size()) << growth.name;
      EXPECT_GE(growth.x.size(), 2u) << growth.name;
    }
  }
}

TEST_F(SmallClaims, AreTextJsonAndAPage) {
  const auto json = nlohmann::json::parse(json_text(report()));
  ASSERT_EQ(json["claims"].size(), claims().size());
  const std::set<std::string> verdicts{"holds", "holds with a limit", "does not hold", "not resolved"};
  const std::string all = verdicts_text(report()), page = page_text(report());
  for (std::size_t i = 0; i < claims().size(); ++i) {
    const ClaimReport& claim = report().claims[i];
    const std::string name(claims()[i].name), text = claim_text(claim);
    EXPECT_EQ(json["claims"][i]["name"], name);
    EXPECT_TRUE(verdicts.contains(json["claims"][i]["verdict"]));
    EXPECT_EQ(json["claims"][i]["figures"].size(), claim.finding.figures.size());
    EXPECT_NE(all.find(name), std::string::npos);
    EXPECT_NE(page.find('"' + name + '"'), std::string::npos);
    for (const char* label : {"statement", "experiment", "rule", "verdict", "interval"}) {
      EXPECT_NE(text.find(label), std::string::npos) << name << ' ' << label;
    }
    EXPECT_NE(text.find(name_of(claim.finding.verdict)), std::string::npos);
  }
  EXPECT_EQ(page.find("http"), page.find("http://www.w3.org/2000/svg"));  // a name, not an address
}

}  // namespace
}  // namespace sightline::bench
