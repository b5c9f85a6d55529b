#include "bench/estimate.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sightline::bench {
namespace {

/// Against Wilson's formula by hand.
TEST(EstimateOfShare, HoldsWhereNothingIsFound) {
  EXPECT_NEAR(estimate_of_share(0, 10).high, 0.27753, 1e-5);
  EXPECT_EQ(estimate_of_share(0, 10).low, 0);
  EXPECT_NEAR(estimate_of_share(5, 10).low, 0.23659, 1e-5);
  EXPECT_NEAR(estimate_of_share(5, 10).high, 0.76341, 1e-5);
  EXPECT_EQ(estimate_of_share(10, 10).high, 1);
  EXPECT_THROW(estimate_of_share(0, 0), std::invalid_argument);
  EXPECT_THROW(estimate_of_share(2, 1), std::invalid_argument);
}

TEST(Estimate, MedianOfOddAndEvenCounts) {
  EXPECT_EQ(estimate({3, 1, 2}).median, 2);
  EXPECT_EQ(estimate({4, 1, 3, 2}).median, 2.5);
  EXPECT_EQ(estimate({7}).median, 7);
  EXPECT_THROW(estimate({}), std::invalid_argument);
}

/// Against the tables of the binomial distribution: P(fewer than k of n fall below the median), both sides.
TEST(Estimate, IntervalFollowsTheBinomialDistribution) {
  const auto of_first = [](int n) {
    std::vector<double> samples;
    for (int i = n; i >= 1; --i) samples.push_back(i);
    return estimate(samples);
  };
  EXPECT_EQ(of_first(1).confidence, 0);
  EXPECT_EQ(of_first(5).low, 1);
  EXPECT_EQ(of_first(5).high, 5);
  EXPECT_DOUBLE_EQ(of_first(5).confidence, 1 - 2.0 / 32);
  EXPECT_EQ(of_first(8).low, 1);  // the second would give 0.930
  EXPECT_EQ(of_first(9).low, 2);
  EXPECT_EQ(of_first(9).high, 8);
  EXPECT_DOUBLE_EQ(of_first(9).confidence, 1 - 2.0 * (1 + 9) / 512);
  EXPECT_EQ(of_first(20).low, 6);
  EXPECT_NEAR(of_first(20).confidence, 0.9586, 0.0001);
}

TEST(Estimate, OneWildSampleMovesNothing) {
  const Estimate calm = estimate({1, 2, 3, 4, 5, 6, 7, 8, 9});
  const Estimate wild = estimate({1, 2, 3, 4, 5, 6, 7, 8, 1e9});
  EXPECT_EQ(calm.median, wild.median);
  EXPECT_EQ(calm.high, wild.high);
}

TEST(Estimate, IntervalHoldsTheMedianAndIsMadeOfSamples) {
  EXPECT_TRUE(rc::check([] {
    const auto samples = *rc::gen::nonEmpty<std::vector<double>>();
    const Estimate e = estimate(samples);
    RC_ASSERT(e.low <= e.median && e.median <= e.high);
    RC_ASSERT(std::count(samples.begin(), samples.end(), e.low) > 0);
    RC_ASSERT(std::count(samples.begin(), samples.end(), e.high) > 0);
    RC_ASSERT(samples.size() < 6 || e.confidence >= 0.95);
  }));
}

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

TEST(Estimate, RatiosArePairedByRound) {
  EXPECT_EQ(paired_ratio({2, 30, absent, 8}, {1, 10, 5, 2})->median, 3);
  EXPECT_FALSE(paired_ratio({absent, 1}, {1, absent}));
}

TEST(Estimate, OfPresentLeavesOutWhatIsMissing) {
  EXPECT_FALSE(estimate_of_present({}));
  EXPECT_FALSE(estimate_of_present({absent, absent}));
  EXPECT_EQ(estimate_of_present({3, absent, 1, 2})->median, 2);
}

TEST(GeometricMeans, AreTakenIndexByIndex) {
  EXPECT_TRUE(geometric_means({}).empty());
  const auto means = geometric_means({{1, 4, absent, 2}, {4, 9, 5}});
  ASSERT_EQ(means.size(), 4u);
  EXPECT_DOUBLE_EQ(means[0], 2);
  EXPECT_DOUBLE_EQ(means[1], 6);
  EXPECT_TRUE(std::isnan(means[2])) << "missing in one series";
  EXPECT_TRUE(std::isnan(means[3])) << "past the end of one";
}

/// A ratio and its inverse have inverse means, which arithmetic ones have not.
TEST(GeometricMeans, DoNotDependOnWhichIsTheReference) {
  EXPECT_TRUE(rc::check([] {
    const auto bits = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 1000)));
    std::vector<std::vector<double>> series, inverse;
    for (const int x : bits) series.push_back({0.01 * x}), inverse.push_back({1 / (0.01 * x)});
    RC_ASSERT(std::fabs(geometric_means(series)[0] * geometric_means(inverse)[0] - 1) < 1e-9);
  }));
}

TEST(Text, DigitsEndWhereTheUncertaintyBegins) {
  EXPECT_EQ(measured_text({0.21374, 0.2137, 0.2138, 1}), "0.214");
  EXPECT_EQ(measured_text({0.21374, 0.18, 0.24, 1}), "0.21");
  EXPECT_EQ(measured_text({0.21374, 0.1, 0.5, 1}), "0.2");
  EXPECT_EQ(measured_text({1234.5, 1230, 1240, 1}), "1230");
  EXPECT_EQ(measured_text({1234.5, 900, 1900, 1}), "1200");
  EXPECT_EQ(measured_text({12.345, 12.345, 12.345, 0}), "12.3");
}

TEST(Text, NumbersKeepTheirSignificantDigits) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(16256), "16256");
  EXPECT_EQ(number_text(82.23), "82.2");
  EXPECT_EQ(number_text(0.00123456), "0.00123");
  EXPECT_EQ(number_text(0.99996), "1.000");
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(47794), "47,794");
  EXPECT_EQ(count_text(1234567), "1,234,567");
}

}  // namespace
}  // namespace sightline::bench
