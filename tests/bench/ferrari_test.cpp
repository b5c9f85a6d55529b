#include "bench/peers/ferrari.h"

#include <gtest/gtest.h>

#include "bench/torus/rays.h"

namespace sightline::bench {
namespace {

void expect_roots(double a, double b, double c, double d, const std::vector<double>& expected) {
  std::array<double, 4> roots;
  const int count = ferrari_roots(a, b, c, d, roots);
  ASSERT_EQ(count, static_cast<int>(expected.size()));
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(roots[i], expected[i], 0x1p-30);
}

TEST(Ferrari, SolvesQuartics) {
  expect_roots(-10, 35, -50, 24, {1, 2, 3, 4});
  expect_roots(0, -5, 0, 4, {-2, -1, 1, 2});  // in the square alone
  expect_roots(-1, 1, -1, 0, {0, 1});         // x (x - 1) (x^2 + 1)
  expect_roots(0, -3, 2, 0, {-2, 0, 1, 1});
  expect_roots(0, 2, 0, 1, {});
  expect_roots(1, 2, 3, 4, {});
}

TEST(Ferrari, MeetsToriWhereTheyAre) {
  const Torus torus{Vec3d(0), Vec3d(0, 0, 1), 1, 0.5};
  for (const TorusRays& set : torus_rays(torus, 500)) {
    if (set.name == "grazing") continue;
    int hits = 0;
    for (const Ray<double>& ray : set.rays) {
      std::array<double, 4> roots;
      const RootList truth = torus_roots(torus, ray, Level::exact);
      ASSERT_EQ(ferrari_roots(torus, ray, roots), truth.count);
      hits += truth.count > 0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(truth.count); ++i) {
        EXPECT_NEAR(roots[i], truth.roots[i].t, 0x1p-16);
      }
    }
    EXPECT_EQ(hits, set.name == "mixed" ? 250 : 500);
  }
}

/// Which is why the count is a column of the table.
TEST(Ferrari, MiscountsAlongTheSurface) {
  const Torus torus{Vec3d(0), Vec3d(0, 0, 1), 1, 0.5};
  const std::vector<Ray<double>> rays = torus_rays(torus, 10'000)[2].rays;
  std::size_t wrong = 0;
  for (const Ray<double>& ray : rays) {
    std::array<double, 4> roots;
    wrong += ferrari_roots(torus, ray, roots) != torus_roots(torus, ray, Level::exact).count;
  }
  EXPECT_EQ(rays.size(), 1000u);
  EXPECT_GT(wrong, 10u);
}

}  // namespace
}  // namespace sightline::bench
