/// Octaves, warps and footprints.

#include "sightline/noise/noise_field.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "sightline/math/random.h"

namespace sightline {
namespace {

constexpr std::array lattice_kinds{NoiseKind::perlin, NoiseKind::improved, NoiseKind::value};

template <int dims>
std::vector<glm::vec<dims, double>> some_points(int count) {
  std::vector<glm::vec<dims, double>> points(static_cast<std::size_t>(count));
  Random random(6);
  for (auto& p : points) {
    for (int axis = 0; axis < dims; ++axis) p[axis] = 20 * random.uniform_double() - 10;
  }
  return points;
}

/// Richardson's extrapolation of a central difference: what is left is of sixth order.
template <int dims>
double difference(const NoiseField& field, const glm::vec<dims, double>& p, int axis, double step) {
  const auto central = [&](double h) {
    glm::vec<dims, double> before = p, after = p;
    before[axis] -= h, after[axis] += h;
    return (field(after) - field(before)) / (2 * h);
  };
  const double whole = central(step), half = central(step / 2), quarter = central(step / 4);
  const double fine = (4 * quarter - half) / 3, coarse = (4 * half - whole) / 3;
  return (16 * fine - coarse) / 15;
}

/// Where a crease or the face of a cell is within a step, differences do not settle as the step shrinks, and say
/// nothing. Elsewhere, and that is nearly everywhere, they have to be the gradient.
template <int dims>
void expect_gradient(const FieldOptions& options) {
  const NoiseField field(options);
  int settled = 0, all = 0;
  for (const auto& p : some_points<dims>(150)) {
    const auto sample = field.sample(p);
    const auto in_float = field.sample(glm::vec<dims, float>(p));
    const auto at_float = field.sample(glm::vec<dims, double>(glm::vec<dims, float>(p)));
    for (int axis = 0; axis < dims; ++axis) {
      constexpr double step = 0x1p-8, tolerance = 0x1p-20;
      const double estimate = difference(field, p, axis, step), finer = difference(field, p, axis, step / 8);
      ++all;
      // Roundings of coordinates that grow from octave to octave, times slopes that do as well.
      EXPECT_NEAR(in_float.gradient[axis], at_float.gradient[axis], 0x1p-9);
      if (std::fabs(estimate - finer) > tolerance / 2) continue;
      ++settled;
      EXPECT_NEAR(sample.gradient[axis], finer, tolerance);
    }
  }
  EXPECT_GT(settled, all / 2);
}

TEST(Field, GradientIsThatOfDifferences) {
  for (const NoiseKind kind : lattice_kinds) {
    for (const FractalInfo& fractal : fractal_infos) {
      for (const double warp : {0.0, 0.25}) {
        SCOPED_TRACE(std::string(fractal.name) + " of kind " + std::to_string(static_cast<int>(kind)) + ", warp " +
                     std::to_string(warp));
        const FieldOptions options{.noise = {.kind = kind, .seed = 1, .ease = Ease::quintic},
                                   .fractal = fractal.kind,
                                   .octaves = 3,
                                   .lacunarity = 1.9,
                                   .gain = 0.6,
                                   .frequency = 0.7,
                                   .warp = warp};
        expect_gradient<2>(options);
        expect_gradient<3>(options);
      }
    }
  }
}

/// One octave more adds what f makes of noise there, gain^i times.
TEST(Field, IsTheSumOfItsOctaves) {
  const double lacunarity = 2.5, gain = 0.7, frequency = 0.3;
  for (const FractalInfo& fractal : fractal_infos) {
    if (fractal.kind == FractalKind::none) continue;
    const auto field_of = [&](int octaves) {
      return NoiseField({.noise = {.kind = NoiseKind::perlin, .seed = 3},
                         .fractal = fractal.kind,
                         .octaves = octaves,
                         .lacunarity = lacunarity,
                         .gain = gain,
                         .frequency = frequency});
    };
    const Noise noise({.seed = 3});
    const NoiseField one = field_of(1), two = field_of(2), three = field_of(3);
    double amplitude = 1, most_of_second = 0, off_own_lattice = 0;
    for (const auto& p : some_points<3>(1000)) {
      const double n = noise(frequency * p);
      const double f = fractal.kind == FractalKind::fbm          ? n
                       : fractal.kind == FractalKind::turbulence ? std::fabs(n)
                                                                 : (1 - std::fabs(n)) * (1 - std::fabs(n));
      EXPECT_NEAR(one(p), f, 0x1p-50) << fractal.name;
      off_own_lattice = std::fmax(off_own_lattice, std::fabs(two(p) - one(p) - gain * (one(lacunarity * p))));
      most_of_second = std::fmax(most_of_second, std::fabs(two(p) - one(p)));
      EXPECT_LE(std::fabs(three(p) - two(p)), gain * gain + 0x1p-50);
    }
    EXPECT_GT(off_own_lattice, 0.1) << "both octaves are the same noise";
    EXPECT_LE(most_of_second, gain + 0x1p-50);
    EXPECT_GE(most_of_second, 0.5 * gain * std::sqrt(0.75));
    amplitude += gain + gain * gain;
    EXPECT_NEAR(three.amplitude(), amplitude, 0x1p-50);
    // The second octave at P is the first one of its seed at lacunarity P: it is 0 at points of its own finer lattice.
    if (fractal.kind == FractalKind::fbm) {
      const double cell = 1 / (lacunarity * frequency);
      for (int i = 1; i < 20; ++i) {
        const glm::dvec3 p(i * cell, 3 * i * cell, 2 * cell);
        EXPECT_NEAR(two(p), one(p), 0x1p-45);
      }
    }
  }
}

TEST(Field, NoFractalIsNoiseItself) {
  const NoiseField field({.noise = {.kind = NoiseKind::improved}, .frequency = 2});
  const Noise noise({.kind = NoiseKind::improved});
  for (const auto& p : some_points<3>(100)) EXPECT_EQ(field(p), noise(2.0 * p));
}

TEST(Field, WarpMovesPointsByAsManyCells) {
  const FieldOptions plain{.noise = {.seed = 2}, .frequency = 0.5};
  FieldOptions warped = plain;
  warped.warp = 0x1p-20;
  const NoiseField straight(plain), bent(warped);
  warped.warp = 2;
  const NoiseField far(warped);
  int changed = 0;
  for (const auto& p : some_points<3>(500)) {
    EXPECT_NEAR(straight(p), bent(p), 8 * 0x1p-20);  // a slope of a few, times how far points move
    changed += std::fabs(straight(p) - far(p)) > 0.01;
  }
  EXPECT_GT(changed, 400);
}

// ---- Footprints

constexpr int octave_count = 6;

NoiseField fading(FractalKind kind) {
  return NoiseField({.noise = {.seed = 7}, .fractal = kind, .octaves = octave_count, .frequency = 1});
}

TEST(Footprint, LeavesTheOctavesThatItCanShow) {
  const NoiseField field = fading(FractalKind::fbm);
  EXPECT_EQ(field.octaves_within(0), octave_count);
  EXPECT_EQ(field.octaves_within(-0.0), octave_count);
  int before = octave_count;
  for (double footprint = 0x1p-10; footprint < 4; footprint *= 1.1) {
    const int count = field.octaves_within(footprint);
    EXPECT_LE(count, before);
    before = count;
    // Octave i has cells of 2^-i, and goes once they are narrower than two footprints.
    int expected = 0;
    for (int i = 0; i < octave_count; ++i) expected += std::ldexp(1, -i) > 2 * footprint;
    EXPECT_EQ(count, expected) << footprint;
  }
  EXPECT_EQ(before, 0);
}

TEST(Footprint, ChangesNothingWhereAllCanBeShown) {
  for (const FractalInfo& info : fractal_infos) {
    const NoiseField field = fading(info.kind);
    for (const auto& p : some_points<3>(100)) EXPECT_EQ(field(p, std::ldexp(0.25, -octave_count + 1)), field(p));
  }
}

/// The mean that a wide footprint gives is that of many points, to what chance leaves of as many.
TEST(Footprint, EndsInTheMean) {
  for (const FractalInfo& info : fractal_infos) {
    if (info.kind == FractalKind::none) continue;
    const NoiseField field = fading(info.kind);
    const auto points = [] {
      std::vector<glm::dvec3> some(100'000);
      Random random(12);
      for (auto& p : some) {
        for (int axis = 0; axis < 3; ++axis) p[axis] = 1000 * random.uniform_double();
      }
      return some;
    }();
    std::vector<double> values(points.size());
    field.values<3, double>(points, values);
    double sum = 0;
    for (const double value : values) sum += value;
    const double mean = sum / static_cast<double>(values.size());
    EXPECT_NEAR(field(glm::dvec3(1, 2, 3), 100.0), mean, 0.01 * field.amplitude()) << info.name;
    EXPECT_EQ(field(glm::dvec3(1, 2, 3), 100.0), field(glm::dvec3(-7, 1, 0.3), 1e30));
    EXPECT_EQ(field.sample(glm::dvec3(1, 2, 3), 100.0).gradient, glm::dvec3(0));
  }
}

/// Of an octave alone, the way from its value to its mean goes one way, and in small steps.
TEST(Footprint, FadesContinuouslyAndMonotonically) {
  for (const FractalKind kind : {FractalKind::fbm, FractalKind::turbulence, FractalKind::ridged}) {
    const NoiseField field({.noise = {.seed = 7}, .fractal = kind, .octaves = 1});
    for (const auto& p : some_points<3>(50)) {
      const double mean = field(p, 1.0), start = field(p);
      double before = start;
      for (int i = 1; i <= 1000; ++i) {
        const double here = field(p, 0.0006 * i);
        EXPECT_LE(std::fabs(here - mean), std::fabs(before - mean) + 0x1p-50);
        EXPECT_LE(std::fabs(here - before), 0.01);
        before = here;
      }
      EXPECT_NEAR(before, mean, 0x1p-50);
    }
  }
}

// ---- Options

TEST(Field, NamesTheOptionThatIsOutOfRange) {
  struct Case {
    FieldOptions options;
    std::string name;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  std::vector<Case> cases;
  const auto add = [&](const std::string& name, auto member, auto... values) {
    for (const double value : {static_cast<double>(values)...}) {
      FieldOptions options;
      options.fractal = FractalKind::fbm;
      options.*member = static_cast<std::remove_reference_t<decltype(options.*member)>>(value);
      cases.push_back({options, name});
    }
  };
  add("octaves", &FieldOptions::octaves, 0, -1, 33);
  add("lacunarity", &FieldOptions::lacunarity, 1, 0, -2, 17, nan, infinity);
  add("gain", &FieldOptions::gain, 0, -0.5, 1.5, nan, infinity);
  add("frequency", &FieldOptions::frequency, 0, -1, nan, infinity);
  add("warp", &FieldOptions::warp, -1, 2000, nan, infinity);
  cases.push_back({{.noise = {.period = 3}}, "period"});
  for (const Case& c : cases) {
    try {
      const NoiseField field(c.options);
      ADD_FAILURE() << "expected a refusal of " << c.name;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(c.name), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("found"), std::string::npos) << error.what();
    }
  }
  std::vector<float> few(1);
  EXPECT_THROW((NoiseField().values<3, float>(std::vector<glm::vec3>(2), few)), std::invalid_argument);
}

TEST(NoiseField, TakesAFootprintForEachPoint) {
  for (const FractalKind kind : {FractalKind::none, FractalKind::fbm, FractalKind::ridged}) {
    for (const double warp : {0.0, 0.5}) {
      FieldOptions options;
      options.fractal = kind, options.warp = warp;
      const NoiseField field(options);
      Random random(3);
      std::vector<glm::dvec3> points(300);
      std::vector<double> footprints(points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) points[i][axis] = 40 * random.uniform_double();
        footprints[i] = i % 4 == 0 ? 0 : std::ldexp(1.0, static_cast<int>(i % 12) - 9);
      }
      std::vector<NoiseSample<double, 3>> samples(points.size());
      field.samples<3, double>(points, footprints, samples);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const NoiseSample<double, 3> alone = field.sample<3, double>(points[i], footprints[i]);
        ASSERT_EQ(samples[i].value, alone.value) << i;
        ASSERT_EQ(samples[i].gradient, alone.gradient) << i;
      }
      std::vector<double> few(2);
      EXPECT_THROW((field.samples<3, double>(points, few, samples)), std::invalid_argument);
    }
  }
}

}  // namespace
}  // namespace sightline
