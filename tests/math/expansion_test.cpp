#include "sightline/math/expansion.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

namespace sightline {
namespace {

using Rational = boost::multiprecision::cpp_rational;

template <int N>
Rational value_of(const Expansion<N>& expansion) {
  Rational sum(0);
  for (int i = 0; i < expansion.size(); ++i) sum += Rational(expansion.term(i));
  return sum;
}

/// Doubles of widely different magnitudes, often equal or opposite.
rc::Gen<double> doubles() {
  return rc::gen::apply([](int mantissa, int exponent) { return std::ldexp(double(mantissa), exponent); },
                        rc::gen::inRange(-1'000'000, 1'000'000), rc::gen::inRange(-120, 120));
}

RC_GTEST_PROP(Expansion, SumsAndProductsAreExact, ()) {
  const double a = *doubles(), b = *doubles(), c = *doubles(), d = *doubles();
  const auto sum = exact_difference(a, b) + exact_difference(c, d);
  const auto product = exact_difference(a, b) * exact_difference(c, d);
  const Rational ab = Rational(a) - Rational(b), cd = Rational(c) - Rational(d);
  RC_ASSERT(value_of(sum) == ab + cd);
  RC_ASSERT(value_of(product) == ab * cd);
  RC_ASSERT(sum.sign() == Rational(ab + cd).sign());
  RC_ASSERT((product - product).sign() == 0);
  RC_ASSERT((sum - sum).size() == 0);
}

RC_GTEST_PROP(Expansion, EstimatesAreCloseToTheSum, ()) {
  const auto product = exact_difference(*doubles(), *doubles()) * exact_difference(*doubles(), *doubles());
  const Rational exact = value_of(product);
  const Rational error = abs(Rational(Rational(product.estimate()) - exact));
  RC_ASSERT(error <= abs(exact) * Rational(std::ldexp(1.0, -52)));
}

TEST(Expansion, SeesWhatRoundingHides) {
  const Expansion<2> tiny = exact_difference(1.0, 1.0 - 0x1p-53);
  EXPECT_EQ(tiny.sign(), 1);
  Expansion<4> sum(1e300);
  sum.grow(1.0);
  sum.grow(-1e300);
  EXPECT_EQ(sum.estimate(), 1.0);
}

}  // namespace
}  // namespace sightline
