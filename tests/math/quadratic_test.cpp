#include "sightline/math/quadratic.h"

#include <gtest/gtest.h>

#include "sightline/math/quartic.h"

namespace sightline {
namespace {

/// Roots of a t^2 + 2 b t + c, in order, each within two steps of a double, or what its ball says.
template <class N>
void expect_roots(double a, double b, double c, double low, double high) {
  const RootList list = quadratic_roots(N(a), N(b), N(c));
  ASSERT_EQ(list.count, 2);
  EXPECT_TRUE(list.is_certain);
  EXPECT_NEAR(list.roots[0].t, low, 0x1p-51 * std::fabs(low));
  EXPECT_NEAR(list.roots[1].t, high, 0x1p-51 * std::fabs(high));
  EXPECT_LE(list.roots[0].radius, 0x1p-48 * std::fabs(low));
  EXPECT_LE(list.roots[1].radius, 0x1p-48 * std::fabs(high));
  EXPECT_EQ(list.begins_negative, a < 0);
}

/// Of roots of which one is 10^16 times the other, the small one is as accurate as the large one.
template <class N>
class QuadraticRoots : public ::testing::Test {};
using Numbers = ::testing::Types<double, DoubleBall, WideBall>;
TYPED_TEST_SUITE(QuadraticRoots, Numbers);

TYPED_TEST(QuadraticRoots, KeepsTheRootThatCancels) {
  for (const double sign : {1.0, -1.0}) {  // opens up and down
    expect_roots<TypeParam>(sign, sign * -0x1p26, sign, 0x1p-27 + 0x1p-81, 0x1p27 - 0x1p-27);
    expect_roots<TypeParam>(sign, sign * 0x1p26, sign, -0x1p27 + 0x1p-27, -0x1p-27 - 0x1p-81);
    expect_roots<TypeParam>(sign, sign * -0x1p26, -sign, -0x1p-27 + 0x1p-81, 0x1p27 + 0x1p-27);
  }
}

/// Kahan's example: the products agree in all but their last digits, and the roots are 1 and a little more.
TYPED_TEST(QuadraticRoots, KeepsTheDiscriminantThatCancels) {
  expect_roots<TypeParam>(94906265.625, -94906267.0, 94906268.375, 1, 1.0000000289759583);
}

/// t^3 - t and its negative, t^4 - 1 and its negative: what they are before their first root.
TEST(Quartic, KnowsHowItBegins) {
  for (const double sign : {1.0, -1.0}) {
    const auto begins_negative = [&](const std::array<double, 5>& c) {
      std::array<DoubleBall, 5> balls;
      for (std::size_t i = 0; i < 5; ++i) balls[i] = DoubleBall(sign * c[i]);
      const RootList list = quartic_roots(balls);
      EXPECT_TRUE(list.is_certain);
      return list.begins_negative;
    };
    EXPECT_EQ(begins_negative({0, -1, 0, 1, 0}), sign > 0);
    EXPECT_EQ(begins_negative({-1, 0, 0, 0, 1}), sign < 0);
    EXPECT_EQ(begins_negative({-1, 0, 1, 0, 0}), sign < 0);
    EXPECT_EQ(begins_negative({-1, 1, 0, 0, 0}), sign > 0);
  }
}

}  // namespace
}  // namespace sightline
