#include "sightline/math/algebraic_root.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <random>

#include "tests/math/sturm.h"

namespace sightline {
namespace {

using oracle::Rational;

constexpr double infinity = std::numeric_limits<double>::infinity();

Rational value_of(const Dyadic& x) {
  const Rational power = Rational(oracle::Integer(1) << static_cast<unsigned>(std::abs(x.exponent())));
  const Rational mantissa = Rational(oracle::Integer(x.mantissa().get_str()));
  return x.exponent() < 0 ? Rational(mantissa / power) : Rational(mantissa * power);
}

std::vector<Rational> values_of(const ExactPolynomial& p) {
  std::vector<Rational> values;
  for (const Dyadic& c : p) values.push_back(value_of(c));
  return values;
}

ExactPolynomial operator*(const ExactPolynomial& a, const ExactPolynomial& b) {
  ExactPolynomial product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] = product[i + j] + a[i] * b[j];
  }
  return product;
}

ExactPolynomial of_doubles(std::initializer_list<double> highest_first) {
  ExactPolynomial p;
  for (const double c : highest_first) p.insert(p.begin(), Dyadic(c));
  return p;
}

/// q x - p.
ExactPolynomial linear(double p, double q = 1) { return {Dyadic(-p), Dyadic(q)}; }

std::vector<oracle::FoundRoot> found(const ExactPolynomial& p) {
  std::vector<oracle::FoundRoot> roots;
  for (const AlgebraicRoot& root : real_roots(p)) roots.push_back({root.nearest(), root.multiplicity()});
  return roots;
}

bool are_right(const ExactPolynomial& p) {
  const std::vector<AlgebraicRoot> roots = real_roots(p);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    for (std::size_t j = 0; j < roots.size(); ++j) {
      if (AlgebraicRoot::compare(roots[i], roots[j]) != (i < j ? -1 : i > j)) return false;
    }
    if (roots[i].sign_of(p) != 0) return false;
  }
  return oracle::are_all_roots(values_of(p), found(p));
}

struct Row {
  const char* name;
  ExactPolynomial polynomial;
  std::vector<oracle::FoundRoot> roots;
};

TEST(AlgebraicRoot, SolvesTheCatalogue) {
  const double root8 = 2.8284271247461903;  // 10 +- this are not the nearest doubles; the oracle tells those
  const std::vector<Row> rows = {
      {"quad-cancel", of_doubles({1, -1e8, 1}), {{1.0000000000000001e-8, 1}, {1e8 - 1e-8, 1}}},
      {"quad-kahan-disc", of_doubles({94906265.625, -189812534, 94906268.375}), {{1, 1}, {1.0000000289759583, 1}}},
      {"quad-overflow", of_doubles({1e200, -3e200, 2e200}), {}},
      {"quad-underflow", of_doubles({0x1p-665, -3 * 0x1p-665, 0x1p-664}), {{1, 1}, {2, 1}}},
      {"quad-linear-limit", of_doubles({1e-30, -1, 1}), {{1, 1}, {1e30, 1}}},
      {"quad-linear", of_doubles({0, -1, 1}), {{1, 1}}},
      {"quartic-quadruple", linear(10) * linear(10) * linear(10) * linear(10), {{10, 4}}},
      {"quartic-double-sign",
       linear(10) * linear(10) * of_doubles({1, -20, 92}),
       {{10 - root8, 1}, {10, 2}, {10 + root8, 1}}},
      {"quartic-mixed-scale", of_doubles({1, -1000000.001, 1002, -2, .001}), {}},
      {"quartic-diagrams7",
       of_doubles({1, -240, 25449, -1325880, 26471900.25}),
       {{50.645112696944665, 1}, {69.35488730305534, 1}}},
      {"quartic-celeritas", of_doubles({1, 19.534611, -48660.891842, -476217.617178, 57126150.652217}), {}},
      {"quartic-rpoly5", of_doubles({1, -198.995, 15006.6, -508127, 6.52025e6}), {}},
  };
  const std::vector<std::size_t> counts = {2, 2, 2, 2, 2, 1, 1, 3, 2, 2, 4, 0};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const auto& [name, p, expected] = rows[row];
    EXPECT_TRUE(are_right(p)) << name;
    const auto roots = found(p);
    ASSERT_EQ(roots.size(), counts[row]) << name;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(roots[i].nearest, expected[i].nearest, 0x1p-50 * std::fabs(expected[i].nearest)) << name;
      EXPECT_EQ(roots[i].multiplicity, expected[i].multiplicity) << name;
    }
  }
}

TEST(AlgebraicRoot, KnowsConstantsAndZeros) {
  EXPECT_TRUE(real_roots({}).empty());
  EXPECT_TRUE(real_roots({Dyadic(0.0), Dyadic(0.0)}).empty());
  EXPECT_TRUE(real_roots({Dyadic(7)}).empty());
  const auto zero = found({Dyadic(0.0), Dyadic(0.0), Dyadic(0.0), Dyadic(3)});
  ASSERT_EQ(zero.size(), 1u);
  EXPECT_EQ(zero[0].nearest, 0);
  EXPECT_EQ(zero[0].multiplicity, 3);
  EXPECT_TRUE(are_right(linear(0) * linear(0) * of_doubles({1, 0, -2})));
  EXPECT_TRUE(are_right(linear(0) * of_doubles({1, 0, 1}) * linear(-3)));
}

TEST(AlgebraicRoot, RoundsHalfwayToEven) {
  const Dyadic step = Dyadic::power_of_two(-53);
  for (int k = 0; k < 8; ++k) {
    const Dyadic halfway = Dyadic(1) + step * Dyadic(2 * k + 1);
    const double expected = 1 + 0x1p-52 * (k + k % 2);
    EXPECT_EQ(real_roots({-halfway, Dyadic(1)})[0].nearest(), expected);
    const ExactPolynomial pair = ExactPolynomial{-halfway, Dyadic(1)} * of_doubles({1, 0, -3});
    EXPECT_EQ(real_roots(pair)[1].nearest(), expected);
    EXPECT_TRUE(are_right(pair));
  }
}

TEST(AlgebraicRoot, RoundsBeyondTheRangeOfDouble) {
  EXPECT_EQ(found(linear(1, 0x1p-1074))[0].nearest, infinity);
  EXPECT_EQ(found(linear(-1, 0x1p-1074))[0].nearest, -infinity);
  EXPECT_EQ(found(linear(0x1p-1074, 3))[0].nearest, 0);
  EXPECT_EQ(found(linear(0x1p-1073, 3))[0].nearest, 0x1p-1074);
  EXPECT_EQ(found({Dyadic(-0x1p-1074), Dyadic(0.0), Dyadic(1)})[1].nearest, 0x1p-537);
  EXPECT_TRUE(are_right(of_doubles({1, 0, -0x1p-1000})));
  EXPECT_TRUE(are_right(of_doubles({0x1p-1074, 0x1p1000, -1, 0, 0x1p-1074})));
  EXPECT_EQ(real_roots(linear(3, 0x1p-1074))[0].compare(infinity), -1);
  EXPECT_EQ(real_roots(linear(3, 0x1p-1074))[0].compare(std::numeric_limits<double>::max()), 1);
}

TEST(AlgebraicRoot, TellsRootsApartAcrossPolynomials) {
  const auto root2 = real_roots(of_doubles({1, 0, -2}))[1];
  const auto same = real_roots(of_doubles({1, 0, -2}) * of_doubles({1, 1, 1}))[1];
  const auto next = real_roots({Dyadic(-2) + Dyadic::power_of_two(-400), Dyadic(0.0), Dyadic(1)})[1];
  EXPECT_EQ(AlgebraicRoot::compare(root2, same), 0);
  EXPECT_EQ(AlgebraicRoot::compare(root2, next), 1);
  EXPECT_EQ(AlgebraicRoot::compare(next, same), -1);
  EXPECT_EQ(root2.compare(1.4142135623730951), -1);
  EXPECT_EQ(root2.sign_of({Dyadic(-2) + Dyadic::power_of_two(-400), Dyadic(0.0), Dyadic(1)}), 1);
  EXPECT_EQ(root2.sign_of(of_doubles({1, 1, -2, -2})), 0);
  const auto third = real_roots(linear(1, 3))[0], sixths = real_roots(linear(2, 6) * of_doubles({1, 0, 1}))[0];
  EXPECT_EQ(AlgebraicRoot::compare(third, sixths), 0);
  EXPECT_EQ(third.sign_of(linear(1, 3)), 0);
  EXPECT_EQ(third.compare(1.0 / 3), 1);
}

// ---- Generated

/// Roots that fall together or lie one step apart, at one scale.
rc::Gen<double> chosen_roots(int scale) {
  return rc::gen::map(rc::gen::pair(rc::gen::inRange(-3, 4), rc::gen::inRange(-2, 3)),
                      [scale](std::pair<int, int> r) { return std::ldexp(r.first + r.second * 0x1p-50, scale); });
}

RC_GTEST_PROP(AlgebraicRoot, FindsChosenRoots, ()) {
  const int scale = *rc::gen::element(0, 0, -300, 250);
  const int count = *rc::gen::inRange(1, 5);
  ExactPolynomial p = {Dyadic(*rc::gen::element(1.0, -3.0, 0x1p-200))};
  for (int i = 0; i < count; ++i) p = p * linear(*chosen_roots(scale), *rc::gen::element(1.0, 3.0, -7.0));
  RC_ASSERT(are_right(p));
}

RC_GTEST_PROP(AlgebraicRoot, FindsNearRoots, ()) {
  const ExactPolynomial quadratic = linear(*chosen_roots(0)) * linear(*chosen_roots(0));
  ExactPolynomial p = quadratic * linear(*chosen_roots(0)) * linear(*chosen_roots(0));
  const auto place = static_cast<std::size_t>(*rc::gen::inRange(0, 5));
  p[place] = p[place] + Dyadic(*rc::gen::element(-1, 1), -*rc::gen::inRange(0, 300));
  RC_ASSERT(are_right(p));
}

RC_GTEST_PROP(AlgebraicRoot, SolvesAnyCoefficients, ()) {
  const int size = *rc::gen::inRange(1, 6);
  const int spread = *rc::gen::element(1, 40, 500);
  ExactPolynomial p;
  for (int i = 0; i < size; ++i) {
    const int exponent = *rc::gen::inRange(-spread, spread);
    p.push_back(Dyadic(std::ldexp(double(*rc::gen::inRange(-1'000'000, 1'000'000)), exponent)));
  }
  RC_PRE(std::any_of(p.begin(), p.end(), [](const Dyadic& c) { return c.sign() != 0; }));
  RC_ASSERT(are_right(p));
}

/// RapidCheck's sizes begin small; here every case has the full ranges.
TEST(AlgebraicRoot, SolvesThousandsOfNearRoots) {
  std::mt19937 random(1);
  const auto pick = [&](int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(random); };
  const std::array<int, 4> scales = {0, 0, -260, 250};
  for (int round = 0; round < 3000; ++round) {
    const int scale = scales[static_cast<std::size_t>(pick(0, 3))];
    const int degree_wanted = pick(1, 4);
    ExactPolynomial p = {Dyadic(pick(0, 1) ? 1.0 : -0x1p-200)};
    for (int i = 0; i < degree_wanted; ++i) {
      const double root = std::ldexp(pick(-2, 2) + pick(-1, 1) * 0x1p-50, scale);
      p = p * linear(root, pick(0, 1) ? 1 : 3);
    }
    if (pick(0, 1)) {
      Dyadic& c = p[static_cast<std::size_t>(pick(0, degree_wanted))];
      c = c + (c.sign() != 0 ? c : Dyadic(1)).scaled(-pick(20, 300));
    }
    if (p.back().sign() != 0) {
      ASSERT_TRUE(are_right(p)) << "round " << round;
    }
  }
}

RC_GTEST_PROP(AlgebraicRoot, OrdersRootsOfTwoPolynomials, ()) {
  const double a = *chosen_roots(0), b = *chosen_roots(0), c = *chosen_roots(0);
  const ExactPolynomial p = linear(a, 3) * of_doubles({1, 0, -2}), q = linear(b, 3) * linear(c);
  for (const AlgebraicRoot& left : real_roots(p)) {
    for (const AlgebraicRoot& right : real_roots(q)) {
      const int order = AlgebraicRoot::compare(left, right);
      RC_ASSERT(order == -AlgebraicRoot::compare(right, left));
      RC_ASSERT((order == 0) == (left.sign_of(q) == 0 && right.sign_of(p) == 0 && left.nearest() == right.nearest()) ||
                left.nearest() == right.nearest());
      if (left.nearest() != right.nearest()) RC_ASSERT(order == (left.nearest() < right.nearest() ? -1 : 1));
    }
    if (left.nearest() == a / 3) RC_ASSERT(left.compare(a / 3) == Rational(Rational(a) / 3).compare(Rational(a / 3)));
  }
}

}  // namespace
}  // namespace sightline
