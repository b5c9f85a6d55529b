/// The catalogue of hard cases, row by row.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "sightline/math/random.h"
#include "sightline/noise/noise_field.h"

namespace sightline {
namespace {

constexpr std::array lattice_kinds{NoiseKind::perlin, NoiseKind::improved, NoiseKind::value};
constexpr std::array gradient_kinds{NoiseKind::perlin, NoiseKind::improved};

/// noise-lattice: 0 at integer points.
TEST(HardCases, NoiseLattice) {
  for (const NoiseKind kind : gradient_kinds) {
    const NoiseField field({.noise = {.kind = kind, .seed = 1}, .fractal = FractalKind::fbm, .octaves = 4});
    for (int i = -300; i < 300; ++i) {
      const glm::dvec3 p(i, 7 * i + 3, -11 * i);
      EXPECT_EQ(Noise({.kind = kind})(p), 0);
      EXPECT_EQ(Noise({.kind = kind})(glm::vec2(p)), 0);
      EXPECT_EQ(field(p), 0);  // twice as fine a lattice has these points as well
    }
  }
}

/// noise-negative: -0.5 is in the middle of a cell, not beyond its end as where it is truncated to 0.
TEST(HardCases, NoiseNegative) {
  for (const NoiseKind kind : lattice_kinds) {
    const Noise noise({.kind = kind, .period = 256});
    EXPECT_EQ(noise(glm::dvec3(-0.5, -0.5, -0.5)), noise(glm::dvec3(255.5, 255.5, 255.5)));
    EXPECT_EQ(noise(glm::vec2(-0.5f, -3.25f)), noise(glm::vec2(255.5f, 252.75f)));
  }
  EXPECT_NEAR(Noise({.kind = NoiseKind::improved})(glm::dvec3(-.5, .25, -.75)), -0.41210269927978516, 0x1p-50);
}

/// noise-neg-tiny: of -1e-9f the fraction rounds to 1. Noise goes on through 0 by its slope nevertheless.
TEST(HardCases, NoiseNegTiny) {
  for (const NoiseKind kind : gradient_kinds) {
    const Noise noise({.kind = kind});
    for (const glm::vec3 p : {glm::vec3(0, 2, 5), glm::vec3(0, 0, 0), glm::vec3(0, -3, 8)}) {
      const float slope = noise.sample(p).gradient.x;
      for (const float tiny : {-1e-9f, -1e-30f, 1e-9f, 1e-30f}) {
        EXPECT_NEAR(noise(glm::vec3(tiny, p.y, p.z)), tiny * slope, 0x1p-20f * std::fabs(tiny));
      }
    }
  }
}

/// noise-2^24: from there on every float is an integer, and at frequency 1 a lattice point: that gradient noise is 0 is
/// right. At finer lattices than floats it is not, and what a float is asked for is what a double is there.
TEST(HardCases, NoiseTwoTo24) {
  constexpr float base = 0x1p24f;
  const Noise plain;
  EXPECT_EQ(plain(glm::vec3(base + 2, base + 6, -base)), 0);
  EXPECT_EQ(plain(glm::dvec3(base + 2, base + 6, -base)), 0);
  for (const NoiseKind kind : lattice_kinds) {
    const NoiseField field({.noise = {.kind = kind, .seed = 3}, .frequency = 0.25});
    int zeros = 0;
    double worst = 0;
    for (int i = 1; i < 1000; ++i) {
      const glm::vec3 p(base + static_cast<float>(2 * i), -base + static_cast<float>(i), static_cast<float>(i) + 0.5f);
      const double exact = field(glm::dvec3(p));
      worst = std::fmax(worst, std::fabs(field(p) - exact));
      zeros += exact == 0;
    }
    EXPECT_LT(worst, 8 * 0x1p-23) << static_cast<int>(kind);  // a dozen roundings of numbers below 1
    EXPECT_LT(zeros, 500) << static_cast<int>(kind);
  }
  // One cell of a million: the error of floats is that of their operations, not that of a coordinate.
  const Noise value({.kind = NoiseKind::perlin});
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 p(1e6f + static_cast<float>(i) / 16, 1e6f + 0.4375f, 0.25f);
    EXPECT_NEAR(value(p), value(glm::dvec3(p)), 8 * 0x1p-23);
  }
}

/// noise-2^31: beyond all integers of 32 bits noise goes on, and improved noise repeats after 256 as everywhere.
TEST(HardCases, NoiseTwoTo31) {
  const Noise improved({.kind = NoiseKind::improved}), perlin;
  for (const double far : {0x1p31, 3e9, -3e9, 0x1p40, -0x1p45}) {
    const double cell = std::fmod(far, 256);
    EXPECT_EQ(improved(glm::dvec3(far + 0.5, 0.5, 0.25)), improved(glm::dvec3(cell + 0.5, 0.5, 0.25)));
    EXPECT_NE(perlin(glm::dvec3(far + 0.5, 0.5, 0.25)), 0);
    EXPECT_NE(perlin(glm::dvec3(far + 0.5, 0.5, 0.25)), perlin(glm::dvec3(cell + 0.5, 0.5, 0.25)));
  }
  EXPECT_EQ(improved(glm::vec3(3e9f, 0.5f, 0.25f)), improved(glm::vec3(std::fmod(3e9f, 256.0f), 0.5f, 0.25f)));
}

/// noise-period: dyadic x and x + 256 have the same fraction, bit for bit.
TEST(HardCases, NoisePeriod) {
  Random random(8);
  for (const NoiseKind kind : lattice_kinds) {
    const Noise noise({.kind = kind, .period = kind == NoiseKind::improved ? 0u : 256u});
    for (int i = 0; i < 2000; ++i) {
      const auto coordinate = [&] { return std::ldexp(static_cast<double>(random.below(1u << 16)), -8); };
      const glm::dvec3 p(coordinate(), coordinate(), coordinate());
      for (const double shift : {256.0, -256.0, 512.0, 0x1p34}) {
        EXPECT_EQ(noise(p), noise(p + shift));
        EXPECT_EQ(noise.sample(p).gradient, noise.sample(p + shift).gradient);
      }
      EXPECT_EQ(noise(glm::vec3(p)), noise(glm::vec3(p) + 256.0f));
    }
  }
}

/// noise-c2: at a lattice point the curvature of the cubic ease goes from -6 to 6, that of the quintic is 0.
TEST(HardCases, NoiseC2) {
  constexpr double step = 0x1p-20, off = 400 * step;  // third derivatives are below 400
  const auto curvature = [&](const Noise& noise, double side) {
    const glm::dvec3 p(4, 9, 2), q(4 + side * step, 9, 2);
    return side * (noise.sample(q).gradient.x - noise.sample(p).gradient.x) / step;
  };
  const Noise cubic({.kind = NoiseKind::value}), quintic({.kind = NoiseKind::value, .ease = Ease::quintic});
  const double before = cubic(glm::dvec3(3, 9, 2)), here = cubic(glm::dvec3(4, 9, 2)),
               after = cubic(glm::dvec3(5, 9, 2));
  EXPECT_NEAR(curvature(cubic, -1), -6 * (here - before), off);
  EXPECT_NEAR(curvature(cubic, 1), 6 * (after - here), off);
  EXPECT_GT(std::fabs(curvature(cubic, 1) - curvature(cubic, -1)), 0.25);
  EXPECT_NEAR(curvature(quintic, -1), 0, off);
  EXPECT_NEAR(curvature(quintic, 1), 0, off);
}

}  // namespace
}  // namespace sightline
