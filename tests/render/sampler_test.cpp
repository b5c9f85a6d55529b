#include "sightline/render/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace sightline {
namespace {

/// A (0, k, 2)-net: of 2^k points each rectangle of 2^-a by 2^(a - k) holds one, for every a.
TEST(Sampler, SamplesOfAPixelAreANet) {
  for (const std::uint32_t pixel : {0u, 1u, 77u, 100000u}) {
    for (const int k : {1, 3, 6, 10}) {
      for (int a = 0; a <= k; ++a) {
        std::set<std::pair<int, int>> rectangles;
        for (std::uint32_t i = 0; i < 1u << k; ++i) {
          const glm::dvec2 p = Sampler(5, pixel, i).square(Draw::pixel);
          ASSERT_GE(p.x, 0);
          ASSERT_LT(p.x, 1);
          ASSERT_GE(p.y, 0);
          ASSERT_LT(p.y, 1);
          rectangles.insert({static_cast<int>(std::ldexp(p.x, a)), static_cast<int>(std::ldexp(p.y, k - a))});
        }
        EXPECT_EQ(rectangles.size(), 1u << k) << "pixel " << pixel << ", " << k << " bits, " << a << " across";
      }
    }
  }
}

/// So do aligned blocks further on: a pass of samples is as even as the first.
TEST(Sampler, LaterBlocksAreNetsToo) {
  for (std::uint32_t block = 1; block < 8; ++block) {
    std::set<int> columns, rows;
    for (std::uint32_t i = 0; i < 16; ++i) {
      const glm::dvec2 p = Sampler(9, 3, 16 * block + i).square(Draw::light, 1, 2);
      columns.insert(static_cast<int>(16 * p.x));
      rows.insert(static_cast<int>(16 * p.y));
    }
    EXPECT_EQ(columns.size(), 16u);
    EXPECT_EQ(rows.size(), 16u);
  }
}

/// Correlation of what two purposes, pixels, steps or seeds get: beyond 5 deviations of chance none.
TEST(Sampler, PurposesPixelsStepsAndSeedsAreIndependent) {
  constexpr int count = 1 << 14;
  const auto correlation = [&](auto&& first, auto&& second) {
    double sum = 0;
    for (std::uint32_t i = 0; i < count; ++i) sum += (first(i) - 0.5) * (second(i) - 0.5);
    return 12 * sum / std::sqrt(double(count));  // of deviation 1 for independent ones
  };
  // One sample each of many pixels: samples of one pixel are even, not independent.
  const auto of = [](std::uint64_t seed, Draw purpose, std::uint32_t step, std::uint32_t which, std::uint32_t shift) {
    return [=](std::uint32_t i) { return Sampler(seed, i + shift, 3).square(purpose, step, which).x; };
  };
  const auto base = of(1, Draw::light, 0, 0, 0);
  EXPECT_LT(std::fabs(correlation(base, of(1, Draw::lens, 0, 0, 0))), 5);
  EXPECT_LT(std::fabs(correlation(base, of(1, Draw::light, 1, 0, 0))), 5);
  EXPECT_LT(std::fabs(correlation(base, of(1, Draw::light, 0, 1, 0))), 5);
  EXPECT_LT(std::fabs(correlation(base, of(1, Draw::light, 0, 0, 1))), 5);
  EXPECT_LT(std::fabs(correlation(base, of(2, Draw::light, 0, 0, 0))), 5);
  EXPECT_GT(correlation(base, base), 100);
}

/// Samples at every 16th number, as those that one moment of an open shutter gets, lie all over the pixel.
TEST(Sampler, EverySixteenthSampleIsSpread) {
  for (std::uint32_t moment = 0; moment < 16; ++moment) {
    double sum = 0;
    int count = 0;
    for (std::uint32_t pixel = 0; pixel < 64; ++pixel) {
      for (std::uint32_t i = moment; i < 256; i += 16, ++count) sum += Sampler(4, pixel, i).square(Draw::pixel).x;
    }
    EXPECT_NEAR(sum / count, 0.5, 5 * std::sqrt(1.0 / 12 / count)) << moment;
  }
}

}  // namespace
}  // namespace sightline
