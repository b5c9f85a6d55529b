#include "sightline/math/quartic.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/math/sturm.h"

namespace sightline {
namespace {

using oracle::Rational;

template <class N>
std::array<N, 5> coefficients_of(const std::array<double, 5>& highest_first) {
  std::array<N, 5> c;
  for (std::size_t i = 0; i < 5; ++i) c[i] = N(highest_first[4 - i]);
  return c;
}

/// Every root that is claimed is there, within its radius; a certain list is complete.
template <class M>
void expect_proven(const std::array<double, 5>& highest_first, bool* is_certain = nullptr) {
  const RootList list = quartic_roots(coefficients_of<Ball<M>>(highest_first));
  std::vector<Rational> rational;
  for (std::size_t i = 0; i < 5; ++i) rational.push_back(Rational(highest_first[4 - i]));
  const auto chains = oracle::chains_of(oracle::polynomial_of(rational));
  const int count = chains.empty() ? 0 : chains[0].count();
  int seen = 0, multiplicities = 0;
  Rational before(-1);
  for (int i = 0; i < list.count; ++i) {
    const Root& root = list.roots[static_cast<std::size_t>(i)];
    Rational lo = Rational(root.t) - Rational(root.radius), hi = Rational(root.t) + Rational(root.radius);
    if (i > 0 && before >= lo) lo = before;
    const int inside = chains[0].count_to(hi) - chains[0].count_to(lo) + chains[0].has_root(lo);
    if (list.is_certain) {
      ASSERT_EQ(root.multiplicity, 1);
      ASSERT_GE(inside, 1) << root.t << " +- " << root.radius;
    }
    seen += inside;
    multiplicities += root.multiplicity;
    before = hi;
  }
  ASSERT_GE(seen, count);
  ASSERT_LE(list.count, 4);
  if (list.is_certain) {
    ASSERT_EQ(list.count, count);
    ASSERT_EQ(chains.size() <= 1 || chains[1].count() == 0, true);
  } else {
    ASSERT_LE(multiplicities, 4);
  }
  if (is_certain) *is_certain = list.is_certain;
}

constexpr std::array<std::array<double, 5>, 12> simple_rows{{
    {0, 0, 1, -1e8, 1},
    {0, 0, 94906265.625, -189812534, 94906268.375},
    {0, 0, 1e100, -3e100, 2e100},
    {0, 0, 1e-30, -1, 1},
    {0, 0, 0, -1, 1},
    {0, 1, 0, -7, 6},
    {0, 1, 0, 0, -2},
    {1, -1000000.001, 1002, -2, .001},
    {1, -240, 25449, -1325880, 26471900.25},
    {1, 19.534611, -48660.891842, -476217.617178, 57126150.652217},
    {1, -198.995, 15006.6, -508127, 6.52025e6},
    {1, -10, 35, -50, 24},
}};

TEST(Quartic, SolvesTheCatalogue) {
  for (const auto& row : simple_rows) {
    SCOPED_TRACE(row[4]);
    bool is_certain = false;
    expect_proven<double>(row);
    expect_proven<DoubleDouble>(row, &is_certain);
    EXPECT_TRUE(is_certain);
    const RootList wide = quartic_roots(coefficients_of<WideBall>(row)),
                   plain = quartic_roots(coefficients_of<double>(row));
    ASSERT_EQ(plain.count, wide.count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(plain.count); ++i) {
      EXPECT_NEAR(plain.roots[i].t, wide.roots[i].t, 0x1p-25 * std::fabs(wide.roots[i].t));
      EXPECT_LE(wide.roots[i].radius, 0x1p-50 * std::fabs(wide.roots[i].t));
    }
  }
}

TEST(Quartic, CountsRootsTogetherThatItCannotTellApart) {
  const RootList four = quartic_roots(coefficients_of<WideBall>({1, -40, 600, -4000, 10000}));
  EXPECT_FALSE(four.is_certain);
  ASSERT_EQ(four.count, 1);
  EXPECT_NEAR(four.roots[0].t, 10, 0x1p-20);
  EXPECT_EQ(four.roots[0].multiplicity, 4);
  const RootList three = quartic_roots(coefficients_of<WideBall>({1, -40, 592, -3840, 9200}));
  EXPECT_FALSE(three.is_certain);
  ASSERT_EQ(three.count, 3);
  EXPECT_EQ(three.roots[0].multiplicity, 1);
  EXPECT_EQ(three.roots[1].multiplicity, 2);
  EXPECT_NEAR(three.roots[1].t, 10, 0x1p-30);
  const RootList plain = quartic_roots(coefficients_of<double>({1, 0, -2, 0, 1}));
  EXPECT_TRUE(plain.is_certain);
  ASSERT_EQ(plain.count, 2);
  EXPECT_EQ(plain.roots[0].t, -1);
  EXPECT_EQ(plain.roots[0].multiplicity, 2);
}

TEST(Quartic, ProvesWhatItClaims) {
  std::mt19937 random(2);
  const auto pick = [&](int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(random); };
  int certain = 0, wide_certain = 0;
  constexpr int rounds = 4000;
  for (int round = 0; round < rounds; ++round) {
    // Products of roots some 2^-k apart: rounding the coefficients moves them, which the oracle sees.
    const double gap = std::ldexp(1.0, -pick(0, 50));
    std::array<double, 5> p{0, 0, 0, 0, std::ldexp(1.0, pick(-40, 40))};
    const int degree = pick(1, 4);
    for (int i = 0; i < degree; ++i) {
      const double root =
          std::ldexp(pick(-3, 3) + pick(-2, 2) * gap + (pick(0, 3) == 0 ? 0.1 : 0), pick(0, 9) ? 0 : pick(-60, 60));
      for (std::size_t k = 0; k < 5; ++k) p[k] = (k < 4 ? p[k + 1] : 0) - root * p[k];
    }
    if (pick(0, 1)) p[static_cast<std::size_t>(pick(0, 4))] += pick(-1, 1) * gap;
    bool is_certain = false, is_wide_certain = false;
    expect_proven<double>(p, &is_certain);
    expect_proven<DoubleDouble>(p, &is_wide_certain);
    if (HasFatalFailure()) FAIL() << "round " << round;
    certain += is_certain;
    wide_certain += is_wide_certain;
    EXPECT_TRUE(is_wide_certain || !is_certain);
  }
  EXPECT_GT(certain, rounds / 4);
  EXPECT_GT(wide_certain, certain);
}

}  // namespace
}  // namespace sightline
