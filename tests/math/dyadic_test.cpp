#include "sightline/math/dyadic.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

namespace sightline {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

constexpr double infinity = std::numeric_limits<double>::infinity();

Rational value_of(const Dyadic& x) {
  const Rational power = Rational(Integer(1) << static_cast<unsigned>(std::abs(x.exponent())));
  const Rational mantissa = Rational(Integer(x.mantissa().get_str()));
  return x.exponent() < 0 ? Rational(mantissa / power) : Rational(mantissa * power);
}

/// Any finite double, those next to others among them.
rc::Gen<double> doubles() {
  return rc::gen::apply(
      [](int mantissa, int step, int exponent) { return std::ldexp(double(mantissa) + step * 0x1p-40, exponent); },
      rc::gen::inRange(-4000, 4000), rc::gen::inRange(-1, 2), rc::gen::element(0, 1, 40, -40, 900, -900, -1040, -1074));
}

RC_GTEST_PROP(Dyadic, ComputesExactly, ()) {
  const double a = *doubles(), b = *doubles(), c = *doubles();
  const Dyadic sum = Dyadic(a) + Dyadic(b) * Dyadic(c), difference = Dyadic(a) - Dyadic(b), negated = -Dyadic(a);
  RC_ASSERT(value_of(sum) == Rational(a) + Rational(b) * Rational(c));
  RC_ASSERT(value_of(difference) == Rational(a) - Rational(b));
  RC_ASSERT(value_of(negated) == -Rational(a));
  RC_ASSERT(sum.sign() == Rational(Rational(a) + Rational(b) * Rational(c)).sign());
  RC_ASSERT((Dyadic(a) < Dyadic(b)) == (a < b));
  RC_ASSERT((Dyadic(a) == Dyadic(b)) == (a == b));
  RC_ASSERT(Dyadic(a).nearest() == a);
}

RC_GTEST_PROP(Dyadic, RoundsSumsAsTheProcessorDoes, ()) {
  const double a = *doubles(), b = *doubles();
  RC_ASSERT((Dyadic(a) + Dyadic(b)).nearest() == a + b);
  RC_ASSERT((Dyadic(a) - Dyadic(b)).nearest() == a - b);
  RC_ASSERT((Dyadic(a) * Dyadic(b)).nearest() == a * b);
  const double c = *doubles();
  RC_ASSERT((Dyadic(a) * Dyadic(b) + Dyadic(c)).nearest() == std::fma(a, b, c));
}

TEST(Dyadic, RoundsAtTheEndsOfTheRange) {
  const Dyadic tiny(0x1p-1074), one(1), huge(std::numeric_limits<double>::max());
  EXPECT_EQ(tiny.scaled(-1).nearest(), 0);
  EXPECT_EQ((tiny.scaled(-1) + tiny.scaled(-90)).nearest(), 0x1p-1074);
  EXPECT_EQ((tiny.scaled(-1) - tiny.scaled(-90)).nearest(), 0);
  EXPECT_TRUE(std::signbit((-tiny.scaled(-1)).nearest()));
  EXPECT_TRUE(std::signbit((-tiny.scaled(-100)).nearest()));
  EXPECT_EQ((tiny + tiny.scaled(-1)).nearest(), 0x1p-1073);
  EXPECT_EQ(Dyadic::power_of_two(1024).nearest(), infinity);
  EXPECT_EQ((-Dyadic::power_of_two(5000)).nearest(), -infinity);
  const Dyadic half_step = Dyadic::power_of_two(970);
  EXPECT_EQ((huge + half_step).nearest(), infinity);
  EXPECT_EQ((huge + half_step - one).nearest(), std::numeric_limits<double>::max());
  EXPECT_EQ(Dyadic().nearest(), 0);
  EXPECT_THROW(Dyadic{infinity}, std::invalid_argument);
  EXPECT_THROW(Dyadic{std::nan("")}, std::invalid_argument);
}

}  // namespace
}  // namespace sightline
