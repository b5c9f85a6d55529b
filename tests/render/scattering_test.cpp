#include "sightline/render/scattering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sightline/math/random.h"

namespace sightline {
namespace {

using std::numbers::pi;

Vec3d direction(double cosine, double turn) {
  const double sine = std::sqrt(1 - cosine * cosine);
  return {sine * std::cos(turn), sine * std::sin(turn), cosine};
}

TEST(Fresnel, StraightOnItIsTheSquareOfTheIndicesRatio) {
  for (const double eta : {1.0, 1.33, 1.5, 2.4, 1 / 1.5}) {
    const double ratio = (eta - 1) / (eta + 1);
    EXPECT_NEAR(fresnel(1, eta), ratio * ratio, 1e-15);
  }
  EXPECT_EQ(fresnel(0.7, 1), 0);
}

TEST(Fresnel, IsTheSameFromBothSides) {
  for (const double eta : {1.33, 1.5, 2.4}) {
    for (double cos_in = 0.05; cos_in < 1; cos_in += 0.05) {
      const double cos_out = std::sqrt(1 - (1 - cos_in * cos_in) / (eta * eta));
      EXPECT_NEAR(fresnel(cos_in, eta), fresnel(cos_out, 1 / eta), 1e-14);
    }
  }
}

TEST(Fresnel, AllIsReflectedBeyondTheCriticalAngle) {
  const double critical = std::sqrt(1 - 1 / (1.5 * 1.5));
  EXPECT_EQ(fresnel(critical - 1e-9, 1 / 1.5), 1);
  EXPECT_LT(fresnel(critical + 1e-3, 1 / 1.5), 1);
  EXPECT_NEAR(fresnel(1e-12, 1.5), 1, 1e-10);
}

/// At Brewster's angle light polarized along the plane is not reflected: half of the other's share is left.
TEST(Fresnel, BrewstersAngle) {
  const double eta = 1.5, cos_in = 1 / std::sqrt(1 + eta * eta);
  const double across = (1 - eta * eta) / (1 + eta * eta);
  EXPECT_NEAR(fresnel(cos_in, eta), across * across / 2, 1e-15);
}

TEST(Refraction, ObeysSnellsLaw) {
  const Vec3d normal(0, 0, 1);
  for (const double eta : {1.33, 1.5, 1 / 1.2}) {
    for (const double cos_in : {0.6, 0.8, 0.95, 1.0}) {
      const Vec3d view = direction(cos_in, 0.3), way = refracted(view, normal, eta);
      EXPECT_NEAR(glm::length(way), 1, 1e-14);
      EXPECT_LT(way.z, 0);
      EXPECT_NEAR(std::hypot(way.x, way.y) * eta, std::hypot(view.x, view.y), 1e-14);
      EXPECT_NEAR(way.x * view.y, way.y * view.x, 1e-14);
    }
  }
}

/// Facets' areas as seen from above add up to that of the plane: their density times the cosine is 1 in all.
TEST(Microfacets, DensityIsNormalized) {
  for (const double roughness : {0.2, 0.5, 0.8, 1.0}) {
    const Microfacets facets(roughness);
    // In tan^2, as t / (1 - t), so that narrow peaks are resolved.
    constexpr int steps = 200000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
      const double c2 = (i + 0.5) / steps;  // of the cosine's square, whose half's differential is cos d cos
      sum += pi * facets.density(std::sqrt(c2)) / steps;
    }
    EXPECT_NEAR(sum, 1, 2e-3) << roughness;
  }
}

/// Facets that a direction sees add up to their area as it sees it: the density of visible facets is 1 in all. Means
/// of any function over samples are its integral over that density.
TEST(Microfacets, VisibleFacetsAreAsLikelyAsTheyAreSeen) {
  Random random(7);
  for (const double roughness : {0.5, 0.8, 1.0}) {
    const Microfacets facets(roughness);
    for (const double cos_view : {0.2, 0.7, 1.0}) {
      const Vec3d view = direction(cos_view, 1.1);
      constexpr int count = 1 << 16;
      double sampled = 0, squares = 0, integral = 0;
      const auto weigh = [](const Vec3d& m) { return m.z * m.z + 0.3 * m.x; };
      for (int i = 0; i < count; ++i) {
        const Vec3d facet = facets.visible_facet(view, {random.uniform_double(), random.uniform_double()});
        EXPECT_GE(facet.z, 0);
        EXPECT_GE(glm::dot(facet, view), -1e-12);
        sampled += weigh(facet) / count;
        squares += weigh(facet) * weigh(facet) / count;
        // Uniform over the hemisphere.
        const Vec3d m = direction((i + 0.5) / count, 2 * pi * random.uniform_double());
        const double seen = std::max(0.0, glm::dot(m, view)) * facets.density(m.z) * facets.seen(cos_view) / cos_view;
        integral += 2 * pi * weigh(m) * seen / count;
      }
      const double deviation = std::sqrt((squares - sampled * sampled) / count);
      EXPECT_NEAR(sampled, integral, 6 * deviation + 0.02) << roughness << " " << cos_view;
    }
  }
}

TEST(CosineDirection, MeansAreThoseOfTheCosine) {
  constexpr int side = 256;
  double z = 0, z2 = 0;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const Vec3d way = cosine_direction({(i + 0.5) / side, (j + 0.5) / side});
      EXPECT_NEAR(glm::length(way), 1, 1e-14);
      z += way.z / (side * side);
      z2 += way.z * way.z / (side * side);
    }
  }
  EXPECT_NEAR(z, 2.0 / 3, 3e-4);  // of the density cos / pi
  EXPECT_NEAR(z2, 1.0 / 2, 3e-4);
}

}  // namespace
}  // namespace sightline
