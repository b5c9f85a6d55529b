#include "sightline/math/ball.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace sightline {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Rational middle_of(const DoubleBall& x) { return Rational(x.mid); }
Rational middle_of(const WideBall& x) { return Rational(x.mid.high) + Rational(x.mid.low); }

template <class B>
bool contains(const B& ball, const Rational& x) {
  return !std::isfinite(ball.radius) || abs(Rational(x - middle_of(ball))) <= Rational(ball.radius);
}

template <class B>
class BallLaws : public testing::Test {};
using Balls = testing::Types<DoubleBall, WideBall>;
TYPED_TEST_SUITE(BallLaws, Balls);

/// Chains of operations down to where everything underflows and up to where it overflows.
TYPED_TEST(BallLaws, ContainTheExactResult) {
  std::mt19937 random(5);
  const auto pick = [&](int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(random); };
  const auto number = [&](int scale) {
    return pick(0, 9) == 0 ? 0 : std::ldexp(double(pick(-1000, 1000)) + pick(-1, 1) * 0x1p-40, pick(-scale, scale));
  };
  int certain = 0;
  for (int round = 0; round < 20000; ++round) {
    const int scale = round % 2 == 0 ? 20 : 600;
    const double start = number(scale);
    TypeParam ball(start);
    Rational exact(start);
    for (int step = 0; step < 4; ++step) {
      const double other = number(scale);
      switch (pick(0, 4)) {
        case 0:
          ball = ball + TypeParam(other), exact += Rational(other);
          break;
        case 1:
          ball = ball - TypeParam(other), exact -= Rational(other);
          break;
        case 2:
          ball = ball * TypeParam(other), exact *= Rational(other);
          break;
        case 3:
          ball = ball * ball, exact *= exact;
          break;
        default:
          if (other != 0) ball = ball / TypeParam(other), exact /= Rational(other);
      }
      if (!std::isfinite(ball.radius)) break;
      ASSERT_TRUE(contains(ball, exact)) << "round " << round;
      const Sign sign = sign_of(ball);
      certain += sign.is_certain;
      if (sign.is_certain) {
        ASSERT_EQ(sign.value, exact.sign()) << "round " << round;
      }
    }
  }
  EXPECT_GT(certain, 40000);
}

}  // namespace
}  // namespace sightline
