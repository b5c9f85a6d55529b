/// Which directions and which rays to lights are chosen, and how likely.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sightline/math/random.h"
#include "sightline/render/shadow_choice.h"
#include "sightline/render/sky_distribution.h"

namespace sightline::test {
namespace {

/// Whatever a ray finds, the square that its choice adds is as C2 says.
TEST(ShadowChoice, AddsNoMoreThanIsAllowed) {
  LampsSeen lit;
  for (std::uint32_t i = 0; i < LampsSeen::trials; ++i) {
    LampsSeen sample;
    sample.add(3, true, false);
    lit.add(sample);
  }
  ASSERT_TRUE(lit.is_always_lit(3));
  for (const float f : {0x1p-10f, 0.1f, 1.0f, 50.0f}) {
    for (const double allowed : {1e-6, 1e-3, 0.5}) {
      const ShadowChoice unknown = choose_shadow_ray(Color(f), allowed, {}, 0);
      for (const double found : {0.0, 1.0}) {
        const double error = (found - unknown.guess) * f;
        EXPECT_LE((1 / unknown.probability - 1) * error * error, allowed * (1 + 1e-4)) << f;
      }
      const ShadowChoice known = choose_shadow_ray(Color(f), allowed, lit, 3);
      EXPECT_EQ(known.guess, 1);
      EXPECT_LE(known.probability, unknown.probability);
      EXPECT_GE(known.probability, 0.25);
      for (double dark = 0; dark <= 1; dark += 1.0 / 64) {
        const double agrees = std::pow(1 - dark, LampsSeen::trials);
        EXPECT_LE(agrees * dark * (1 / known.probability - 1) * f * f, allowed * (1 + 1e-4)) << f << " " << dark;
      }
    }
  }
  EXPECT_EQ(choose_shadow_ray(Color(1), 0, lit, 3).probability, 1);
}

TEST(ShadowChoice, LampsThatWereNotAlwaysSeenAreUnknown) {
  LampsSeen all;
  const auto add = [&](bool is_lit, bool is_dark, std::uint32_t lamp) {
    LampsSeen sample;
    sample.add(lamp, is_lit, is_dark);
    all.add(sample);
  };
  add(false, true, 0);
  EXPECT_TRUE(all.is_always_dark(0));
  EXPECT_FALSE(all.is_always_lit(0));
  EXPECT_FALSE(all.is_always_dark(1) || all.is_always_lit(1));
  add(false, true, 1);
  EXPECT_FALSE(all.is_always_dark(0)) << "a sample did not ask it";
  EXPECT_FALSE(all.is_always_dark(1)) << "nor the other one";
  EXPECT_FALSE(LampsSeen(~0u).is_always_lit(LampsSeen::most_lamps));
  LampsSeen penumbra;
  penumbra.add(2, true, true);
  EXPECT_FALSE(penumbra.is_always_lit(2) || penumbra.is_always_dark(2));
}

/// Dark but for two spots, one over the seam and one at the pole.
Image spots() {
  Image image{32, 16, 3, std::vector<float>(32 * 16 * 3, 0.001f)};
  for (const int pixel : {5 * 32, 7, 14 * 32 + 20}) {
    for (int k = 0; k < 3; ++k) image.pixels[static_cast<std::size_t>(3 * pixel + k)] = 40;
  }
  return image;
}

/// D1 by Monte Carlo with both: even directions over density, and 1 / density over its own.
TEST(SkyDistribution, DensityIsThatOfItsSamples) {
  const auto sky = SkyDistribution::of(spots(), 25);
  ASSERT_TRUE(sky);
  Random random(1);
  constexpr int count = 1 << 20;
  constexpr double sphere = 4 * std::numbers::pi;
  double even = 0, area = 0, moment = 0, even_moment = 0;
  for (int i = 0; i < count; ++i) {
    const double z = 2 * random.uniform_double() - 1, angle = 2 * std::numbers::pi * random.uniform_double();
    const double r = std::sqrt(1 - z * z);
    const Vec3d way(r * std::cos(angle), r * std::sin(angle), z);
    even += sky->density(way) * sphere / count;
    even_moment += sky->density(way) * way.x * sphere / count;
    const auto [chosen, density] = sky->sample({random.uniform_double(), random.uniform_double()});
    ASSERT_NEAR(glm::length(chosen), 1, 1e-12);
    area += density > 0 ? 1 / density / count : 0;
    moment += chosen.x / count;
    if (i < 4096) {
      EXPECT_NEAR(sky->density(chosen) / density, 1, 1e-6) << i;
    }
  }
  EXPECT_NEAR(even, 1, 0.03);
  EXPECT_NEAR(area, sphere, 0.03 * sphere);
  EXPECT_NEAR(moment, even_moment, 0.02);
}

TEST(SkyDistribution, OfAnEvenSkyIsNone) {
  EXPECT_FALSE(SkyDistribution::of(Image{8, 4, 1, std::vector<float>(32, 0.5f)}, 0));
  EXPECT_FALSE(SkyDistribution::of(Image{8, 4, 3, std::vector<float>(96, 0)}, 0));
}

TEST(SkyDistribution, LooksWhereItIsBright) {
  const auto sky = SkyDistribution::of(spots(), 0);
  ASSERT_TRUE(sky);
  SkyImage map;
  int bright = 0;
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec2 uv = map.uv_of(sky->sample({random.uniform_double(), random.uniform_double()}).direction);
    const double u = 32 * (uv.x - std::floor(uv.x)), v = 16 * (1 - uv.y);
    const auto is_near = [&](double x, double y) {
      return std::fabs(std::remainder(u - x - 0.5, 32)) < 1.51 && std::fabs(v - y - 0.5) < 1.51;
    };
    bright += is_near(0, 5) || is_near(7, 0) || is_near(20, 14);
  }
  EXPECT_GT(bright, 980);
}

}  // namespace
}  // namespace sightline::test
