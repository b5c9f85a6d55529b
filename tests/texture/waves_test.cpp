#include "sightline/texture/waves.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "sightline/math/random.h"

namespace sightline {
namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// x - floor(x) without rounding.
cpp_rational exact_fraction(double x) {
  const cpp_rational q(x);
  cpp_int whole = numerator(q) / denominator(q);
  if (q < cpp_rational(whole)) --whole;
  return q - cpp_rational(whole);
}

TEST(Fraction, IsExactFromZeroOn) {
  Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    const double x = std::ldexp(random.uniform_double(), static_cast<int>(random.below(140)) - 70);
    EXPECT_EQ(cpp_rational(fraction(x)), exact_fraction(x)) << x;
  }
}

TEST(Fraction, IsTheNearestBelowZeroAndNeverOne) {
  Random random(2);
  for (int i = 0; i < 20'000; ++i) {
    const double x = -std::ldexp(random.uniform_double(), static_cast<int>(random.below(140)) - 70);
    const double f = fraction(x);
    ASSERT_GE(f, 0);
    ASSERT_LT(f, 1);
    const cpp_rational error = cpp_rational(f) - exact_fraction(x);
    EXPECT_LE(abs(error), cpp_rational(0x1p-53)) << x;
  }
  for (const double x : {-1e-20, -5e-324, -0x1p-54, -0x1p-53}) EXPECT_EQ(fraction(x), 1 - 0x1p-53) << x;
  for (const double x : {0.0, -0.0, 1.0, -1.0, 1e300, -1e300, 0x1p52 + 1, -0x1p60}) EXPECT_EQ(fraction(x), 0) << x;
  EXPECT_EQ(fraction(-0.25), 0.75);
  EXPECT_EQ(fraction(0x1p51 + 0.5), 0.5);
  EXPECT_TRUE(std::isnan(fraction(infinity)));
  EXPECT_TRUE(std::isnan(fraction(std::nan(""))));
}

using WaveFunction = std::function<double(double)>;

/// By many midpoints, on both sides of every whole and half number, where waves bend.
double quadrature(const WaveFunction& wave, double from, double to) {
  double sum = 0;
  for (double start = from; start < to;) {
    const double end = std::min(to, (std::floor(2 * start) + 1) / 2);
    constexpr int count = 400;
    double part = 0;
    for (int i = 0; i < count; ++i) part += wave(start + (end - start) * (i + 0.5) / count);
    sum += part * (end - start) / count;
    start = end;
  }
  return sum / (to - from);
}

void expect_means(const WaveFunction& wave, const std::function<WaveMean(double, double)>& mean, double mean_of_all) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const double f = random.uniform_double(), width = std::ldexp(1 + random.uniform_double(), -8 + i % 12);
    EXPECT_NEAR(mean(f, width).value, quadrature(wave, f - width / 2, f + width / 2), 2e-5) << f << ' ' << width;
    // The mean's derivative is the difference of the ends.
    const double step = 0x1p-20, slope = (mean(f + step < 1 ? f + step : f, width).value -
                                          mean(f >= step ? f - step : f, width).value) /
                                         ((f + step < 1 ? step : 0) + (f >= step ? step : 0));
    EXPECT_NEAR(mean(f, width).slope, slope, 1e-3 * std::max(1.0, 4 / (width * width))) << f << ' ' << width;
  }
  for (int i = 0; i < 100; ++i) {
    const double f = random.uniform_double();
    EXPECT_EQ(mean(f, 0).value, wave(f));
    EXPECT_NEAR(mean(f, 0x1p-40).value, wave(f), 1e-9) << "a narrow interval is a point, " << f;
    EXPECT_NEAR(mean(f, 1e9).value, mean_of_all, 1e-8);
    EXPECT_EQ(mean(f, infinity).value, mean_of_all);
    EXPECT_EQ(mean(f, infinity).slope, 0);
  }
}

TEST(Waves, SawtoothHasItsMean) {
  expect_means([](double x) { return x - std::floor(x); }, sawtooth_mean, 0.5);
  EXPECT_EQ(sawtooth_mean(0.999, 0.5).value, 0.999 - (0.999 + 0.25 - 1) / 0.5);
}

TEST(Waves, SineHasItsMean) {
  expect_means([](double x) { return 0.5 - 0.5 * std::cos(2 * std::numbers::pi * x); }, sine_mean, 0.5);
}

TEST(Waves, CreaseHasItsMean) {
  for (const double sharpness : {1.0, 2.5, 6.0}) {
    expect_means([&](double x) { return std::pow(std::fabs(2 * (x - std::floor(x)) - 1), sharpness); },
                 [&](double f, double width) { return crease_mean(f, width, sharpness); }, 1 / (sharpness + 1));
  }
}

TEST(Waves, SquareHasItsMean) {
  const WaveFunction square = [](double x) { return std::floor(x) == 2 * std::floor(x / 2) ? 1.0 : -1.0; };
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const double place = random.uniform_double(), width = std::ldexp(1 + random.uniform_double(), -30 + i % 34);
    for (const bool is_odd : {false, true}) {
      const double x = place + (is_odd ? 1 : 0);
      EXPECT_NEAR(square_mean(is_odd, place, width), quadrature(square, x - width / 2, x + width / 2), 1e-6)
          << x << ' ' << width;
    }
  }
  EXPECT_EQ(square_mean(true, 0.5, 0), -1);
  EXPECT_EQ(square_mean(false, 0.5, 1e-300), 1);
  EXPECT_EQ(square_mean(false, 0.25, infinity), 0);
}

}  // namespace
}  // namespace sightline
