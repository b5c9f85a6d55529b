#include "sightline/texture/wood.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sightline/math/random.h"
#include "sightline/noise/noise.h"

namespace sightline {
namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;

/// The course's formula over the rationals, but for noise, which is what it is.
double exact_value(const WoodOptions& o, const Vec3d& p) {
  const double noise = Noise(o.noise)(o.noise_frequency * p);
  const cpp_rational x = cpp_rational(o.texture_frequency) * cpp_rational(p.x);
  const cpp_rational z = cpp_rational(o.texture_frequency) * cpp_rational(p.z);
  const cpp_rational ring = x * x + z * z + cpp_rational(o.noise_amplitude) * cpp_rational(noise);
  cpp_int whole = numerator(ring) / denominator(ring);
  if (ring < cpp_rational(whole)) --whole;
  return static_cast<double>(cpp_rational(ring - cpp_rational(whole)));
}

/// How far apart two numbers mod 1 are.
double apart(double a, double b) {
  const double difference = std::fabs(a - b);
  return std::min(difference, 1 - difference);
}

Vec3d random_point(Random& random, double reach) {
  const auto coordinate = [&] { return reach * (2 * random.uniform_double() - 1); };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

TEST(Wood, IsTheFormulaHoweverFarAway) {
  Random random(1);
  for (const double frequency : {1.0, 3.0, 0.3}) {
    const WoodOptions options{.texture_frequency = frequency, .noise_frequency = 1.7, .noise_amplitude = 2.5};
    const Wood wood(options);
    for (int i = 0; i < 3000; ++i) {
      const double reach = std::pow(10, -3 + 15 * random.uniform_double());
      const Vec3d p = random_point(random, reach);
      EXPECT_LE(apart(wood.value(p), exact_value(options, p)), 0x1p-49) << frequency << ' ' << reach;
    }
  }
}

TEST(Wood, HasTheColorsBetweenEarlyAndLate) {
  const WoodOptions options{.early = Color(0.5f, 0.25f, 0.125f), .late = Color(0.25f, 0.125f, 0)};
  const Wood wood(options);
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = random_point(random, 10);
    const auto f = static_cast<float>(wood.value(p));
    EXPECT_EQ(wood(p), options.early + f * (options.late - options.early));
  }
}

TEST(Wood, KeepsModOneBelowOne) {
  // On the y axis only noise counts, negative for half of all points, and as small as wished.
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    const Wood wood({.noise_amplitude = std::ldexp(1, -static_cast<int>(random.below(20)))});
    const double f = wood.value({0, std::ldexp(random.uniform_double(), -static_cast<int>(random.below(60))), 0});
    EXPECT_GE(f, 0);
    EXPECT_LT(f, 1);
  }
  EXPECT_EQ(Wood({.noise_amplitude = 0}).value({1e100, 0, 0}), 0);
  EXPECT_TRUE(std::isnan(Wood().value({1e200, 0, 0})));
  EXPECT_TRUE(std::isnan(Wood().value({0, std::numeric_limits<double>::infinity(), 0})));
}

TEST(Wood, TextureFrequencyCountsRings) {
  for (const double frequency : {1.0, 2.0, 3.0}) {
    const Wood wood({.texture_frequency = frequency, .noise_amplitude = 0});
    int rings = 0;
    const double reach = 2.9375;
    double before = 0;
    for (int i = 1; i <= 1 << 16; ++i) {
      const double f = wood.value({0, 5, reach * i / (1 << 16)});
      rings += f < before;
      before = f;
    }
    EXPECT_EQ(rings, std::floor(frequency * reach * frequency * reach));
  }
}

TEST(Wood, NoiseFrequencyScalesNoiseOnly) {
  Random random(4);
  const Wood slow({.texture_frequency = 0, .noise_frequency = 1}), fast({.texture_frequency = 0, .noise_frequency = 3});
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = random_point(random, 10);
    EXPECT_EQ(fast.value(p), slow.value(3.0 * p));
  }
}

TEST(Wood, NoiseAmplitudeIsHowManyRingsBumpsGo) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = random_point(random, 4);
    const double plain = Wood({.noise_amplitude = 0}).value(p), noise = Noise()(p);
    for (const double amplitude : {1.0, 2.0, 3.0}) {
      const double f = Wood({.noise_amplitude = amplitude}).value(p);
      const double moved = plain + amplitude * noise;
      EXPECT_LE(apart(f, moved - std::floor(moved)), 0x1p-48);
    }
  }
}

TEST(Wood, HasItsGradient) {
  const Wood wood({.texture_frequency = 1.5, .noise_frequency = 2, .noise_amplitude = 1.25});
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = random_point(random, 3);
    const NoiseSample<double, 3> s = wood.sample(p);
    EXPECT_EQ(s.value, wood.value(p));
    for (int axis = 0; axis < 3; ++axis) {
      const double step = 0x1p-20;
      Vec3d ahead = p, back = p;
      ahead[axis] += step, back[axis] -= step;
      const double difference = wood.value(ahead) - wood.value(back);
      EXPECT_NEAR(s.gradient[axis], (difference - std::round(difference)) / (2 * step), 1e-4);
    }
  }
}

/// By many points along the way across the rings, which is where f changes.
double mean_across(const Wood& wood, const Vec3d& p, double width) {
  double sum = 0;
  constexpr int count = 20'000;
  for (int i = 0; i < count; ++i) {
    const double s = width * ((i + 0.5) / count - 0.5);
    const double size = std::hypot(p.x, p.z);
    const Vec3d outward = size > 0 ? Vec3d(p.x / size, 0, p.z / size) : Vec3d(1, 0, 0);
    sum += wood.value(p + s * outward);
  }
  return sum / count;
}

TEST(Wood, FadesAsItsRingsDo) {
  const Wood wood({.noise_amplitude = 0});
  Random random(7);
  for (int i = 0; i < 60; ++i) {
    const Vec3d p = random_point(random, 30);
    const double width = 0.002 * (1 + i);
    // Rings are not evenly spread: over a footprint of width w their number bends by w^2 / 4.
    EXPECT_NEAR(wood.value(p, Footprint(width)), mean_across(wood, p, width), 2 * width * width + 1e-3) << i;
  }
}

TEST(Wood, BecomesItsMeanFarAway) {
  const Wood wood({.noise_amplitude = 2});
  Random random(8);
  double largest_near = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = random_point(random, 5);
    EXPECT_EQ(wood.value(p, Footprint(0)), wood.value(p));
    EXPECT_NEAR(wood.value(p, Footprint(1e-12)), wood.value(p), 1e-9);
    EXPECT_NEAR(wood.value(p, Footprint(100)), 0.5, 1e-3) << "on the axis as well";
    EXPECT_EQ(wood.value(p, Footprint(std::numeric_limits<double>::infinity())), 0.5);
    largest_near = std::max(largest_near, std::fabs(wood.value(p, Footprint(0.01)) - 0.5));
  }
  EXPECT_GT(largest_near, 0.45) << "and is not the mean before";
  EXPECT_NEAR(wood.value({0, 0, 0}, Footprint(100)), 0.5, 1e-3);
}

TEST(Wood, RefusesWhatIsOutOfRange) {
  for (const WoodOptions& bad : {WoodOptions{.texture_frequency = -1}, WoodOptions{.noise_frequency = 0},
                                 WoodOptions{.noise_amplitude = std::nan("")}, WoodOptions{.early = Color(2, 0, 0)}}) {
    EXPECT_THROW(Wood{bad}, std::invalid_argument);
  }
  try {
    Wood({.texture_frequency = -1});
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "wood: texture_frequency = -1 is not allowed; expected a number from 0 to 1048576");
  }
}

}  // namespace
}  // namespace sightline
