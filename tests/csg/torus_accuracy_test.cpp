/// Boundaries of tori are as accurate as their level says, however close to a tangent.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/csg/evaluate.h"

namespace sightline {
namespace {

TEST(TorusAccuracy, IsThatOfTheLevel) {
  const Solid ring(Torus{{0.1, 0.2, 0.3}, {0.3, -0.2, 1}, 2, 1});
  std::size_t crossings = 0;
  for (int k = 1; k <= 40; ++k) {
    for (const double tilt : {0.0, 0.25, -0.5}) {
      // Through the outer equator, at right angles to the axis but for the tilt: as good as tangent.
      const Vec3d across = glm::normalize(Vec3d(1, 0, -0.3)),
                  around = glm::cross(glm::normalize(Vec3d(0.3, -0.2, 1)), across);
      const Vec3d way = around + tilt * Vec3d(0.3, -0.2, 1);
      const Ray<double> ray{Vec3d(0.1, 0.2, 0.3) + (3 - std::ldexp(1.0, -k)) * across - 5.0 * way, way};
      const Spans exact = spans_of(ring, ray, Level::exact);
      ASSERT_EQ(exact.boundaries.size(), 2u) << k;
      for (const auto& [level, share] : {std::pair(Level::watertight, 0x1p-46), std::pair(Level::precise, 0x1p-52)}) {
        const Spans spans = spans_of(ring, ray, level);
        const auto first = first_of(ring, ray, 0, 100, level);
        ASSERT_EQ(spans.boundaries.size(), 2u) << k;
        ASSERT_TRUE(first);
        EXPECT_EQ(first->t, spans.boundaries[0].t);
        for (std::size_t i = 0; i < 2; ++i) {
          const Boundary& boundary = spans.boundaries[i];
          EXPECT_LE(boundary.radius, share * std::fabs(boundary.t)) << k << ' ' << info_of(level).name;
          EXPECT_LE(std::fabs(boundary.t - exact.boundaries[i].t), share * std::fabs(boundary.t)) << k;
          ++crossings;
        }
      }
    }
  }
  EXPECT_EQ(crossings, 480u);
}

}  // namespace
}  // namespace sightline
