#include <gtest/gtest.h>

#include <cmath>

#include "sightline/math/random.h"
#include "viz/color_ramp.h"
#include "viz/noise/lattice_cell.h"
#include "viz/noise/spectrum.h"

namespace sightline::viz {
namespace {

/// What the picture explains is what the library computes.
TEST(LatticeCell, AddsUpToTheNoise) {
  Random random(1);
  for (const NoiseKind kind : {NoiseKind::perlin, NoiseKind::improved, NoiseKind::value}) {
    for (const Ease ease : {Ease::cubic, Ease::quintic}) {
      const Noise noise({.kind = kind, .seed = 2, .ease = ease});
      for (int i = 0; i < 500; ++i) {
        const glm::dvec2 p(20 * random.uniform_double() - 10, 20 * random.uniform_double() - 10);
        const LatticeCell cell = lattice_cell(noise, p);
        EXPECT_NEAR(cell.value, noise(p), 1e-14);
        double weights = 0, sum = 0;
        for (const CellCorner& corner : cell.corners) {
          weights += corner.weight;
          sum += corner.weight * corner.contribution;
        }
        EXPECT_NEAR(weights, 1, 1e-14);
        EXPECT_NEAR(sum, cell.value, 1e-14);
      }
    }
  }
}

TEST(LatticeCell, NamesItsCorners) {
  const LatticeCell cell = lattice_cell(Noise(), {-0.75, 2.5});
  EXPECT_EQ(cell.corners[0].name, "LL");
  EXPECT_EQ(cell.corners[0].position, glm::dvec2(-1, 2));
  EXPECT_EQ(cell.corners[1].name, "LR");
  EXPECT_EQ(cell.corners[1].position, glm::dvec2(0, 2));
  EXPECT_EQ(cell.corners[2].name, "UL");
  EXPECT_EQ(cell.corners[2].position, glm::dvec2(-1, 3));
  EXPECT_EQ(cell.corners[3].way, glm::dvec2(-0.75, -0.5));
  for (const CellCorner& corner : cell.corners) {
    EXPECT_NEAR(std::hypot(corner.gradient.x, corner.gradient.y), 1, 1e-15);
  }
}

/// The curve drawn is that which noise goes by: its slopes are differences of it.
TEST(LatticeCell, DrawsTheEaseWithItsSlopes) {
  for (const Ease ease : {Ease::cubic, Ease::quintic}) {
    EXPECT_EQ(eased(ease, 0), 0);
    EXPECT_EQ(eased(ease, 1), 1);
    constexpr double h = 1.0 / 4096;
    for (double t = 0.125; t < 1; t += 0.125) {
      EXPECT_NEAR(slope_of_eased(ease, t), (eased(ease, t + h) - eased(ease, t - h)) / (2 * h), 1e-5);
      EXPECT_NEAR(curvature_of_eased(ease, t), (slope_of_eased(ease, t + h) - slope_of_eased(ease, t - h)) / (2 * h),
                  1e-4);
    }
  }
}

TEST(Spectrum, OfNoiseLiesAroundItsLattice) {
  const Spectrum noise = spectrum_of(NoiseField());
  double sum = 0;
  for (const double density : noise.densities) sum += density / 32;
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_LT(noise.above_two, 5e-4);
  EXPECT_LT(noise.below_quarter, 0.15);
  EXPECT_NEAR(noise.axis_over_diagonal, 1, 0.1);
  const Spectrum white = spectrum_of(NoiseField({.noise = {.kind = NoiseKind::white}}));
  EXPECT_NEAR(white.above_two, 0.75, 0.02);  // of the disc up to 4, what is outside of that up to 2
  // Half as wide cells, the same spectrum per cell.
  EXPECT_NEAR(spectrum_of(NoiseField({.frequency = 2})).below_quarter, noise.below_quarter, 1e-9);
}

TEST(ColorRamp, DivergesEvenlyFromNearWhite) {
  const auto lightness = [](const Rgb& c) {
    return 0.2126 * linear_from_srgb(c[0]) + 0.7152 * linear_from_srgb(c[1]) + 0.0722 * linear_from_srgb(c[2]);
  };
  for (double x = 0.125; x <= 1; x += 0.125) {
    EXPECT_NEAR(lightness(diverging(x)), lightness(diverging(-x)), 0.06) << x;
    EXPECT_LT(lightness(diverging(x)), lightness(diverging(x - 0.125)));
    EXPECT_GT(diverging(x)[0], diverging(x)[2]);
    EXPECT_LT(diverging(-x)[0], diverging(-x)[2]);
  }
  EXPECT_EQ(diverging(7), diverging(1));
  EXPECT_EQ(diverging(std::nan("")), (Rgb{0.5, 0.5, 0.5}));
}

}  // namespace
}  // namespace sightline::viz
