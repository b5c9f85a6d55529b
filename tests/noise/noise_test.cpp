#include "sightline/noise/noise.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

#include "sightline/math/random.h"

namespace sightline {
namespace {

constexpr std::array lattice_kinds{NoiseKind::perlin, NoiseKind::improved, NoiseKind::value};
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Known {
  glm::dvec3 point;
  double value;
};

/// Of Perlin's own implementation.
constexpr std::array<Known, 8> reference{{
    {{.5, .5, .5}, -0.25},
    {{3.14, 42, 7}, 0.13691995878400012},
    {{1.5, 2.25, 3.75}, -0.23534488677978516},
    {{-.5, .25, -.75}, -0.41210269927978516},
    {{-1.1, -2.2, -3.3}, -0.26787526436751358},
    {{.1, .2, .3}, 0.35122924878110717},
    {{256.5, .5, .5}, -0.25},
    {{17.3, 4.7, 0}, -0.23245943951999976},
}};

TEST(Noise, IsThatOf2002) {
  const Noise noise({.kind = NoiseKind::improved});
  for (const Known& known : reference) EXPECT_NEAR(noise(known.point), known.value, 1e-14);
  EXPECT_EQ(noise(glm::dvec2(17.3, 4.7)), noise(glm::dvec3(17.3, 4.7, 0)));
}

TEST(Noise, IsZeroAtLatticePoints) {
  for (const NoiseKind kind : {NoiseKind::perlin, NoiseKind::improved}) {
    const Noise noise({.kind = kind, .seed = 3});
    Random random(1);
    for (int i = 0; i < 10'000; ++i) {
      const double scale = std::ldexp(1.0, static_cast<int>(random.below(60)));
      const auto coordinate = [&] { return std::round((random.uniform_double() - 0.5) * scale); };
      const glm::dvec3 p(coordinate(), coordinate(), coordinate());
      EXPECT_EQ(noise(p), 0);
      EXPECT_EQ(noise(glm::vec3(glm::round(glm::vec3(p)))), 0);
      EXPECT_EQ(noise(glm::dvec2(p)), 0);
    }
  }
}

/// 256 units of the lattice farther on, dyadic points have the very same fractions.
TEST(Noise, RepeatsOnlyWhereAsked) {
  Random random(2);
  for (const NoiseKind kind : lattice_kinds) {
    const Noise endless({.kind = kind}), periodic({.kind = kind, .period = 256});
    int repeated = 0;
    for (int i = 0; i < 1000; ++i) {
      const auto coordinate = [&] { return std::ldexp(static_cast<double>(random.below(1u << 20)), -10) - 512; };
      const glm::dvec3 p(coordinate(), coordinate(), coordinate());
      const double far = std::ldexp(3.0, 40);
      EXPECT_EQ(periodic(p), periodic(p + glm::dvec3(256, -512, far)));
      EXPECT_EQ(periodic(glm::dvec2(p)), periodic(glm::dvec2(p) + 256.0));
      repeated += endless(p) == endless(p + 256.0);
    }
    EXPECT_EQ(repeated > 100, kind == NoiseKind::improved);
  }
}

TEST(Noise, GoesOnBeyondAllIntegers) {
  for (const NoiseKind kind : lattice_kinds) {
    const Noise noise({.kind = kind});
    for (const double far : {3e9, -3e9, 5e14, -5e14, 1e100, -1e300}) {
      EXPECT_TRUE(std::isfinite(noise(glm::dvec3(far, 0.5, 0.25)))) << far;
      EXPECT_TRUE(std::isfinite(noise(glm::vec3(static_cast<float>(std::fmod(far, 1e30)), 0.5f, 0.25f)))) << far;
    }
    const double there = noise(glm::dvec3(3e9 + 0.5, 0.5, 0.25));
    EXPECT_EQ(there == noise(glm::dvec3(3e9 + 0.5 - 0x1p32, 0.5, 0.25)), kind == NoiseKind::improved);
    for (const double none : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
      EXPECT_TRUE(std::isnan(noise(glm::dvec3(0.5, none, 0.5))));
      EXPECT_TRUE(std::isnan(noise(glm::vec2(static_cast<float>(none), 0.5f))));
      EXPECT_TRUE(std::isnan(noise.sample(glm::dvec3(none, 0, 0)).gradient.y));
    }
  }
}

/// Just below a lattice point the fraction rounds to 1, yet the way from the point above is known exactly.
TEST(Noise, IsContinuousBelowZero) {
  for (const NoiseKind kind : {NoiseKind::perlin, NoiseKind::improved}) {
    const Noise noise({.kind = kind});
    const auto at_zero = noise.sample(glm::vec3(0.0f, 2.0f, 5.0f));
    const float below = noise(glm::vec3(-1e-9f, 2.0f, 5.0f));
    EXPECT_FLOAT_EQ(below, -1e-9f * at_zero.gradient.x);
    EXPECT_FLOAT_EQ(noise(glm::vec3(-0.5f, 0.25f, 0.5f)), static_cast<float>(noise(glm::dvec3(-0.5, 0.25, 0.5))));
  }
}

/// Points near and far, both signs, and a few that are no numbers.
template <class T>
std::vector<glm::vec<3, T>> points(int count) {
  std::vector<glm::vec<3, T>> points(static_cast<std::size_t>(count));
  Random random(4);
  for (auto& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      const double size = std::pow(10, -9 + 21 * random.uniform_double());
      p[axis] = static_cast<T>(random.below(2) == 0 ? size : -size);
    }
    if (random.below(2) == 0) p = glm::mod(p, T(1000)) - T(500);
    if (random.below(10'000) == 0) p.y = static_cast<T>(infinity);
  }
  return points;
}

template <class T>
bool are_same(T a, T b) {
  return a == b ? std::signbit(a) == std::signbit(b) : std::isnan(a) && std::isnan(b);
}

template <class T>
void expect_batch_like_single(const NoiseOptions& options, int count) {
  const Noise noise(options);
  const auto at = points<T>(count);
  std::vector<T> values(at.size());
  std::vector<NoiseSample<T, 3>> samples(at.size());
  noise.values<3, T>(at, values);
  noise.samples<3, T>(at, samples);
  int wrong = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const NoiseSample<T, 3> single = noise.sample(at[i]);
    bool is_same = are_same(noise(at[i]), values[i]) && are_same(values[i], samples[i].value);
    for (int axis = 0; axis < 3; ++axis) is_same &= are_same(single.gradient[axis], samples[i].gradient[axis]);
    wrong += !is_same;
  }
  EXPECT_EQ(wrong, 0);
}

TEST(Noise, IsTheSameInBatches) {
  for (const NoiseInfo& info : noise_infos) {
    for (const Ease ease : {Ease::cubic, Ease::quintic}) {
      expect_batch_like_single<float>({.kind = info.kind, .seed = 5, .ease = ease}, 20'011);
      expect_batch_like_single<double>({.kind = info.kind, .seed = 5, .ease = ease, .period = 1024}, 20'011);
    }
  }
}

TEST(Noise, IsTheSameInBatchesOfMillions) {
  expect_batch_like_single<float>({}, 5'000'000);
  expect_batch_like_single<double>({}, 5'000'000);
}

TEST(Noise, WantsAPeriodThatIsAPowerOfTwo) {
  EXPECT_THROW(Noise({.period = 255}), std::invalid_argument);
  EXPECT_THROW(Noise({.period = 1u << 31}), std::invalid_argument);
  std::vector<float> few(3);
  EXPECT_THROW((Noise().values<3, float>(points<float>(4), few)), std::invalid_argument);
}

}  // namespace
}  // namespace sightline
