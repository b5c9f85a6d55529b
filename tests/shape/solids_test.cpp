#include <gtest/gtest.h>

#include <vector>

#include "sightline/math/random.h"
#include "sightline/shape/box.h"
#include "sightline/shape/sphere.h"

namespace sightline {
namespace {

template <class S>
std::vector<double> crossings(const S& shapes, const Ray<double>& ray) {
  std::vector<double> found;
  shapes.prepare(ray).for_each_crossing(shapes[0], [&](const Crossing& crossing) { found.push_back(crossing.t); });
  return found;
}
std::vector<double> of_sphere(const Sphere& sphere, const Ray<double>& ray) {
  return crossings(SphereSet({sphere}), ray);
}
std::vector<double> of_box(const Aabb& box, const Ray<double>& ray) { return crossings(BoxSet({box}), ray); }

TEST(Sphere, IsEnteredAndLeft) {
  EXPECT_EQ(of_sphere({{0, 0, 0}, 1}, {{0, 0, -3}, {0, 0, 1}}), (std::vector<double>{2, 4}));
  EXPECT_EQ(of_sphere({{0, 0, 0}, 1}, {{0, 0, 0}, {0, 0, 2}}), (std::vector<double>{-0.5, 0.5}));
  EXPECT_EQ(of_sphere({{0, 0, 0}, 1}, {{0, 0, 3}, {0, 0, 1}}), (std::vector<double>{-4, -2}));
  EXPECT_TRUE(of_sphere({{0, 0, 0}, 1}, {{0, 1.25, -3}, {0, 0, 1}}).empty());
}

TEST(Sphere, IsTouchedTwiceAtOnce) {
  EXPECT_EQ(of_sphere({{0, 0, 0}, 1}, {{0, 1, -3}, {0, 0, 1}}), (std::vector<double>{3, 3}));
  EXPECT_EQ(of_sphere({{1, 2, 3}, 0}, {{1, 2, 0}, {0, 0, 1}}), (std::vector<double>{3, 3}));
}

TEST(Sphere, KeepsItsChordFarAway) {
  for (int k = 0; k <= 40; ++k) {
    const auto t = of_sphere({{0, 0, 0}, 1}, {{0, 0.5, -std::ldexp(1.0, k)}, {0, 0, 1}});
    ASSERT_EQ(t.size(), 2u) << k;
    EXPECT_NEAR(t[1] - t[0], std::sqrt(3.0), std::ldexp(1.0, k - 51)) << k;
  }
}

TEST(Sphere, ToleratesTinyAndHugeDirections) {
  for (const double scale : {0x1p-80, 0x1p+64}) {
    const auto t = of_sphere({{0, 0, 0}, 1}, {{0, 0.5, -4}, {0, 0, scale}});
    ASSERT_EQ(t.size(), 2u);
    EXPECT_NEAR(t[0] * scale, 4 - std::sqrt(0.75), 1e-14);
  }
}

TEST(Sphere, SeesAPlanetsHorizon) {
  const auto t = of_sphere({{0, 0, 0}, 0x1p20f}, {{0, 0x1p20 + 1, 0}, {1, -1.0 / 16, 0}});
  ASSERT_EQ(t.size(), 2u);
  EXPECT_NEAR(t[0], 16.001953602, 1e-9);
}

/// Reported points are off the sphere by roundings of the distance to the origin only, grazing rays included.
TEST(Sphere, ReportsPointsOnItself) {
  Random random(1);
  int grazed = 0;
  for (int i = 0; i < 50'000; ++i) {
    const double radius = i % 2 == 0 ? 1 : 0x1p-20;
    const double impact = radius * (1 - std::ldexp(1.0, -int(random.below(52))));
    const double angle = 6.28 * random.uniform_double(), distance = 16 * random.uniform_double();
    const Ray<double> ray{{impact * std::cos(angle), impact * std::sin(angle), -distance}, {0, 0, 0.7}};
    for (const double t : of_sphere({{0, 0, 0}, float(radius)}, ray)) {
      ++grazed;
      EXPECT_NEAR(glm::length(ray.at(t)), radius, 0x1p-49 * 17);
    }
  }
  EXPECT_GT(grazed, 90'000);
}

TEST(Sphere, IsClippedWhereItReaches) {
  const SphereSet one({Sphere{{0, 0, 0}, 1}});
  EXPECT_TRUE(one.clip(0, {{0.8f, 0.8f, 0}, {2, 2, 2}}).is_empty());
  EXPECT_EQ(one.clip(0, {{0.7f, 0.7f, 0}, {2, 2, 2}}), (Aabb{{0.7f, 0.7f, 0}, {1, 1, 1}}));
  EXPECT_EQ(one.clip(0, {{1, 0, 0}, {2, 2, 2}}).lo.x, 1);
}

/// Of numbers whose sums doubles hold.
TEST(Sphere, HasBoundsThatHoldIt) {
  Random random(2);
  int rounded = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Sphere sphere{{random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-8, 8)},
                        random.uniform(0x1p-8f, 1)};
    const Aabb box = SphereSet({sphere}).bounds(0);
    for (int axis = 0; axis < 3; ++axis) {
      const double lo = double(sphere.center[axis]) - sphere.radius, hi = double(sphere.center[axis]) + sphere.radius;
      rounded += double(float(hi)) < hi;
      ASSERT_LE(box.lo[axis], lo);
      ASSERT_GE(box.hi[axis], hi);
      ASSERT_GT(next_up(box.lo[axis]), lo);
      ASSERT_LT(next_down(box.hi[axis]), hi);
    }
  }
  EXPECT_GT(rounded, 1000);
}

TEST(Sphere, IsRefusedWithoutFiniteBounds) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(SphereSet({Sphere{{0, 0, 0}, -1}}), std::invalid_argument);
  EXPECT_THROW(SphereSet({Sphere{{0, 0, 0}, nan}}), std::invalid_argument);
  EXPECT_THROW(SphereSet({Sphere{{0, nan, 0}, 1}}), std::invalid_argument);
  EXPECT_THROW(SphereSet({Sphere{{3e38f, 0, 0}, 3e38f}}), std::invalid_argument);
}

TEST(Box, IsHitInsideItsFaces) {
  const Aabb box{{-1, -1, -1}, {1, 1, 1}};
  int rays = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1., 1.}) {
      for (const double zero : {0., -0.}) {
        for (const double way : {-1., 1.}) {
          for (const double across : {-1., 0.5}) {
            Ray<double> ray{Vec3d(across), Vec3d(zero)};
            ray.origin[axis] = side;
            ray.origin[(axis + 1) % 3] = -5 * way;
            ray.direction[(axis + 1) % 3] = way;
            EXPECT_EQ(of_box(box, ray), (std::vector<double>{4, 6}));
            ++rays;
          }
        }
      }
    }
  }
  EXPECT_EQ(rays, 48);
}

TEST(Box, ToleratesFlatAndTouchedOnes) {
  EXPECT_EQ(of_box({{-1, -1, 0}, {1, 1, 0}}, {{0, 0, -2}, {0, 0, 1}}), (std::vector<double>{2, 2}));
  EXPECT_EQ(of_box({{0, 0, 0}, {1, 1, 1}}, {{-1, 1, 0.5}, {1, 1, 0}}).size(), 0u);
  EXPECT_EQ(of_box({{0, 0, 0}, {1, 1, 1}}, {{-1, 0, 0.5}, {1, 1, 0}}), (std::vector<double>{1, 1}));
  EXPECT_EQ(of_box({{0, 0, 0}, {1, 1, 1}}, {{1, 0.5, 0.5}, {1, 0, 0}}), (std::vector<double>{-1, 0}));
  EXPECT_EQ(of_box({{0, 0, 0}, {1, 1, 1}}, {{1, 0.5, 0.5}, {-1, 0, 0}}), (std::vector<double>{0, 1}));
}

TEST(Box, IsMissedByARayThatNeverArrives) {
  EXPECT_TRUE(of_box({{-1, -1, -1}, {0.5f, 1, 1}}, {{1, 0, 0}, {0x1p-140, 0, 0}}).empty() ||
              of_box({{-1, -1, -1}, {0.5f, 1, 1}}, {{1, 0, 0}, {0x1p-140, 0, 0}})[1] < 0);
  const auto t = of_box({{-1, -1, -1}, {1, 1, 1}}, {{-2, -3, -5}, {1e-8, 2e-8, 4e-8}});
  ASSERT_EQ(t.size(), 2u);
  EXPECT_NEAR(t[0], 1e8, 1);
}

}  // namespace
}  // namespace sightline
