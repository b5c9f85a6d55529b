#include "sightline/math/rounding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sightline/math/random.h"

namespace sightline {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(Rounding, StepsToTheNeighbour) {
  for (const float x : {0.f, -0.f, 1.f, -1.f, 1e-45f, -1e-45f, 3.4e38f, -3.4e38f, 0.1f}) {
    EXPECT_EQ(next_up(x), std::nextafter(x, infinity)) << x;
    EXPECT_EQ(next_down(x), std::nextafter(x, -infinity)) << x;
    EXPECT_EQ(next_up(double(x)), std::nextafter(double(x), double(infinity))) << x;
  }
  EXPECT_EQ(next_up(infinity), infinity);
  EXPECT_EQ(next_down(-infinity), -infinity);
  EXPECT_EQ(next_up(-infinity), std::nextafter(-infinity, 0.f));
  EXPECT_TRUE(std::isnan(next_up(std::nanf(""))));
}

TEST(Rounding, OfDoublesEnclosesThem) {
  Random random(1);
  for (int i = 0; i < 100'000; ++i) {
    const double x = std::ldexp(random.uniform_double() - 0.5, int(random.below(300)) - 160);
    const float down = round_down(x), up = round_up(x);
    ASSERT_LE(double(down), x);
    ASSERT_GE(double(up), x);
    ASSERT_TRUE(up == down || up == next_up(down));
  }
  EXPECT_EQ(round_down(0.5), 0.5f);
  EXPECT_EQ(round_up(0.5), 0.5f);
  EXPECT_EQ(round_down(1e300), std::numeric_limits<float>::max());
  EXPECT_EQ(round_up(1e300), infinity);
}

TEST(Rounding, ToIndicesIsGuarded) {
  EXPECT_EQ(clamp_to_index(2.99f, 8), 2);
  EXPECT_EQ(clamp_to_index(-0.5f, 8), 0);
  EXPECT_EQ(clamp_to_index(8.f, 8), 7);
  EXPECT_EQ(clamp_to_index(3e9f, 8), 7);
  EXPECT_EQ(clamp_to_index(infinity, 8), 7);
  EXPECT_EQ(clamp_to_index(-infinity, 8), 0);
  EXPECT_EQ(clamp_to_index(std::nanf(""), 8), 0);
  EXPECT_EQ(clamp_to_index(0.7, 1), 0);
}

/// A float taken to double and back is itself: what GCC 12's SLP vectorizer breaks unless the build guards against it.
TEST(Rounding, SurvivesTheCompiler) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const double wide[6] = {random.uniform_double(), random.uniform_double(), random.uniform_double(),
                            random.uniform_double(), random.uniform_double(), random.uniform_double()};
    float narrow[6];
    double back[6];
    for (int k = 0; k < 6; ++k) narrow[k] = static_cast<float>(wide[k] * 1.1 - 16. * wide[5 - k]);
    for (int k = 0; k < 6; ++k) back[k] = narrow[k];
    for (int k = 0; k < 6; ++k) {
      volatile float stored = static_cast<float>(back[k]);
      ASSERT_EQ(double(stored), back[k]);
    }
  }
}

}  // namespace
}  // namespace sightline
