/// Noise where cells meet: whatever side one comes from, values and gradients are the same, and with the quintic ease
/// the curvature as well.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sightline/math/random.h"
#include "sightline/noise/noise.h"

namespace sightline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The last number before a face belongs to the other cell. Between both noise goes on by its slope and curvature,
/// which are below 4 and 64, and rounds.
template <class T>
void expect_continuous(const NoiseOptions& options) {
  const Noise noise(options);
  Random random(5);
  for (int i = 0; i < 3000; ++i) {
    glm::vec<3, T> p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<T>(128 * random.uniform_double() - 64);
    const int axis = i % 3;
    p[axis] = std::round(p[axis]);
    glm::vec<3, T> before = p;
    before[axis] = std::nextafter(p[axis], static_cast<T>(-infinity));
    const T step = p[axis] - before[axis];
    const auto here = noise.sample(p), there = noise.sample(before);
    constexpr T rounding = 32 * std::numeric_limits<T>::epsilon();
    EXPECT_NEAR(here.value, there.value, 4 * step + rounding);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(here.gradient[k], there.gradient[k], 64 * step + rounding);
    const auto plane_here = noise.sample(glm::vec<2, T>(p)), plane_there = noise.sample(glm::vec<2, T>(before));
    EXPECT_NEAR(plane_here.value, plane_there.value, 4 * step + rounding);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(plane_here.gradient[k], plane_there.gradient[k], 64 * step + rounding);
  }
}

TEST(Continuity, OfValuesAndGradients) {
  for (const NoiseKind kind : {NoiseKind::perlin, NoiseKind::improved, NoiseKind::value}) {
    for (const Ease ease : {Ease::cubic, Ease::quintic}) {
      expect_continuous<float>({.kind = kind, .seed = 2, .ease = ease});
      expect_continuous<double>({.kind = kind, .seed = 2, .ease = ease});
    }
  }
}

/// Second derivatives along x before and after a lattice point, as differences of gradients. Third derivatives are
/// below 400, so a difference over `step` is right to 200 steps.
struct Curvature {
  double before, after;
};
constexpr double step = 0x1p-20;
constexpr double off = 400 * step;

Curvature curvature_at(const Noise& noise, const glm::dvec3& p) {
  const glm::dvec3 along(step, 0, 0);
  const double here = noise.sample(p).gradient.x;
  return {(here - noise.sample(p - along).gradient.x) / step, (noise.sample(p + along).gradient.x - here) / step};
}

/// Along a line through lattice points P of values v, with S'' = 6 after and -6 before them:
///   f'' = 6 (v[P+1] - v[P]) after P, and 6 (v[P-1] - v[P]) before it.
TEST(Continuity, CurvatureOfCubicValuesJumps) {
  const Noise noise({.kind = NoiseKind::value});
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 p(i, 3, 5), next(1, 0, 0);
    const Curvature found = curvature_at(noise, p);
    EXPECT_NEAR(found.after, 6 * (noise(p + next) - noise(p)), off);
    EXPECT_NEAR(found.before, 6 * (noise(p - next) - noise(p)), off);
  }
}

/// There, ways to both neighbours are -1 and 1, and the way from P itself is 0:
///   f'' = -6 g[P+1].x after P, and 6 g[P-1].x before it.
TEST(Continuity, CurvatureOfCubicPerlinJumps) {
  const Noise noise({.kind = NoiseKind::perlin});
  double largest_jump = 0;
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 p(i, 3, 5), next(1, 0, 0);
    const Curvature found = curvature_at(noise, p);
    EXPECT_NEAR(found.after, -6 * noise.sample(p + next).gradient.x, off);
    EXPECT_NEAR(found.before, 6 * noise.sample(p - next).gradient.x, off);
    largest_jump = std::fmax(largest_jump, std::fabs(found.after - found.before));
  }
  EXPECT_GT(largest_jump, 6);
}

TEST(Continuity, CurvatureOfQuinticDoesNotJump) {
  for (const NoiseKind kind : {NoiseKind::perlin, NoiseKind::improved, NoiseKind::value}) {
    const Noise noise({.kind = kind, .ease = Ease::quintic});
    Random random(1);
    for (int i = 0; i < 300; ++i) {
      const double y = 100 * random.uniform_double(), z = 100 * random.uniform_double();
      const Curvature found = curvature_at(noise, glm::dvec3(i, y, z));
      EXPECT_NEAR(found.after, found.before, off);
      const Curvature on_line = curvature_at(noise, glm::dvec3(i, 3, 5));
      EXPECT_NEAR(on_line.after, 0, off);
      EXPECT_NEAR(on_line.before, 0, off);
    }
  }
}

}  // namespace
}  // namespace sightline
