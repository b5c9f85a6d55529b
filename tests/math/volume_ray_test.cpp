/// Rays, directions and volumes of small whole numbers, whose truth is a matter of rational numbers. They touch, graze,
/// start on surfaces and run along them far more often than random ones.

#include "sightline/math/volume_ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sightline/math/enclosure.h"
#include "sightline/math/random.h"
#include "sightline/math/volume_overlap.h"
#include "tests/math/exact.h"

namespace sightline {
namespace {

using exact::cross;
using exact::dot;
using exact::Point;
using exact::Rational;

constexpr float infinity = std::numeric_limits<float>::infinity();

/// The least a t^2 - 2 b t + c over an interval; a is not negative.
Rational least(const Rational& a, const Rational& b, const Rational& c, const Rational& from, const Rational& to) {
  Rational t = a > 0 ? Rational(b / a) : from;
  if (t < from) t = from;
  if (t > to) t = to;
  return (a * t - 2 * b) * t + c;
}

struct Range {
  Rational from, to;
  bool is_empty() const { return from > to; }
  /// What of it has lo <= p + t d <= hi.
  void cut(const Rational& p, const Rational& d, const Rational& lo, const Rational& hi) {
    if (d == 0) {
      if (p < lo || p > hi) to = from - 1;
      return;
    }
    const Rational a = (lo - p) / d, b = (hi - p) / d;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
};

Range range_of(const Ray<double>& ray) {
  return {Rational(ray.t_min), std::isinf(ray.t_max) ? Rational(1'000'000) : Rational(ray.t_max)};
}

bool meets(const Aabb& box, const Ray<double>& ray) {
  Range range = range_of(ray);
  for (int i = 0; i < 3 && !range.is_empty(); ++i) {
    range.cut(ray.origin[i], ray.direction[i], box.lo[i], box.hi[i]);
  }
  return !range.is_empty();
}

bool meets(const Sphere& sphere, const Ray<double>& ray) {
  const Range range = range_of(ray);
  const Point q = exact::minus(exact::point(sphere.center), exact::point(ray.origin)), d = exact::point(ray.direction);
  const Rational r(sphere.radius);
  return least(dot(d, d), dot(q, d), dot(q, q), range.from, range.to) <= r * r;
}

/// The axis' length is a whole number.
bool meets(const Cylinder& cylinder, const Ray<double>& ray) {
  const Point a = exact::point(cylinder.axis), d = exact::point(ray.direction);
  const Point q = exact::minus(exact::point(ray.origin), exact::point(cylinder.center));
  const Rational length(std::sqrt(glm::dot(cylinder.axis, cylinder.axis)));
  EXPECT_EQ(length * length, dot(a, a));
  const Rational r = Rational(cylinder.radius) * length, h = Rational(cylinder.half_length) * length;
  Range range = range_of(ray);
  range.cut(dot(q, a), dot(d, a), -h, h);
  if (range.is_empty()) return false;
  const Point across = cross(d, a), away = cross(q, a);
  return least(dot(across, across), -dot(away, across), dot(away, away), range.from, range.to) <= r * r;
}

struct Dice {
  Random random;

  float whole(int most) {
    return static_cast<float>(static_cast<int>(random.below(static_cast<std::uint32_t>(2 * most + 1))) - most);
  }
  Vec3f vector(int most) { return {whole(most), whole(most), whole(most)}; }

  Ray<double> ray() {
    Ray<double> ray;
    ray.origin = Vec3d(vector(6));
    while (ray.direction = Vec3d(vector(3)), ray.direction == Vec3d(0)) {
    }
    if (random.below(3) == 0) ray.t_min = random.below(4) * 0.5;
    if (random.below(3) == 0) ray.t_max = ray.t_min + random.below(4);
    return ray;
  }

  void make(Aabb& box) {
    const Vec3f a = vector(4), b = vector(4);
    box = {glm::min(a, b), glm::max(a, b)};
  }
  void make(Sphere& sphere) { sphere = {vector(4), std::fabs(whole(4))}; }
  void make(Cylinder& cylinder) {
    static constexpr int axes[][3] = {{1, 0, 0}, {0, 1, 0}, {3, 4, 0}, {1, 2, 2}, {-2, 3, 6}, {4, -4, 7}, {0, 0, -2}};
    const auto& axis = axes[random.below(7)];
    cylinder = {vector(4), Vec3f(axis[0], axis[1], axis[2]), std::fabs(whole(3)), std::fabs(whole(3))};
  }
};

Aabb grown(Aabb box) {
  box.lo -= 0x1p-18f;
  box.hi += 0x1p-18f;
  return box;
}
Sphere grown(Sphere sphere) {
  sphere.radius += 0x1p-18f;
  return sphere;
}
Cylinder grown(Cylinder cylinder) {
  cylinder.radius += 0x1p-18f;
  cylinder.half_length += 0x1p-18f;
  return cylinder;
}

template <class V>
class VolumeLaws : public testing::Test {};
using Volumes = testing::Types<Aabb, Sphere, Cylinder>;
TYPED_TEST_SUITE(VolumeLaws, Volumes);

TYPED_TEST(VolumeLaws, NoRayThatMeetsIsMissed) {
  Dice dice{Random(1)};
  int met = 0, grazed = 0, found = 0;
  for (int round = 0; round < 20000; ++round) {
    TypeParam volume;
    dice.make(volume);
    Ray<double> ray = dice.ray();
    const bool truth = meets(volume, ray), nearly = meets(grown(volume), ray);
    met += truth;
    grazed += nearly && !truth;
    const int scale = round % 5 - 2;  // t is in units of the direction, whatever its length
    ray.direction *= std::ldexp(1.0, 200 * scale);
    ray.t_min = std::ldexp(ray.t_min, -200 * scale);
    ray.t_max = std::ldexp(ray.t_max, -200 * scale);
    const bool answer = VolumeRay(ray).may_meet(volume);
    found += answer;
    ASSERT_TRUE(answer || !truth) << "missed in round " << round;
    ASSERT_TRUE(nearly || !answer) << "far off in round " << round;
  }
  EXPECT_GT(met, 700);
  EXPECT_LE(found, met + grazed);
}

TYPED_TEST(VolumeLaws, NothingAndEverything) {
  Ray<double> ray;
  TypeParam nothing = Enclosure().get<TypeParam>();
  EXPECT_TRUE(is_nothing(nothing));
  EXPECT_FALSE(VolumeRay(ray).may_meet(nothing));
  EXPECT_TRUE(VolumeRay(ray).may_meet(everything<TypeParam>()));
  EXPECT_TRUE(may_overlap(everything<TypeParam>(), everything<TypeParam>()));
  EXPECT_FALSE(may_overlap(everything<TypeParam>(), nothing));
  EXPECT_TRUE(extent_along(nothing, Vec3d(1, 0, 0), Vec3d(0)).is_empty());
  const Interval<double> all = extent_along(everything<TypeParam>(), Vec3d(0.6, 0.8, 0), Vec3d(1));
  EXPECT_EQ(all.lo, -infinity);
  EXPECT_EQ(all.hi, infinity);
  ray.direction = Vec3d(0);  // not valid
  EXPECT_FALSE(VolumeRay(ray).may_meet(everything<TypeParam>()));
}

TYPED_TEST(VolumeLaws, RaysFromFarAwayAreNotMissed) {
  Dice dice{Random(2)};
  for (int round = 0; round < 5000; ++round) {
    TypeParam volume;
    dice.make(volume);
    Ray<double> ray = dice.ray();
    ray.t_min = 0;
    ray.t_max = std::numeric_limits<double>::infinity();
    ray.origin -= std::ldexp(1.0, static_cast<int>(dice.random.below(40))) * ray.direction;  // exact
    ASSERT_TRUE(VolumeRay(ray).may_meet(volume) || !meets(volume, ray)) << "round " << round;
  }
}

/// Points of a lattice, of which some are in both.
TYPED_TEST(VolumeLaws, NoOverlapIsMissed) {
  Dice dice{Random(3)};
  int overlapping = 0, parted = 0;
  for (int round = 0; round < 2000; ++round) {
    TypeParam a, b;
    dice.make(a);
    dice.make(b);
    const bool answer = may_overlap(a, b);
    ASSERT_EQ(answer, may_overlap(b, a));
    parted += !answer;
    for (int i = 0; i < 60; ++i) {
      const Point p = exact::point(0.5f * dice.vector(12));
      if (!exact::holds(a, p) || !exact::holds(b, p)) continue;
      ++overlapping;
      ASSERT_TRUE(answer) << "round " << round;
      break;
    }
  }
  EXPECT_GT(overlapping, 50);
  EXPECT_GT(parted, 250);
}

TYPED_TEST(VolumeLaws, ExtentsHoldEveryPoint) {
  Dice dice{Random(4)};
  int held = 0;
  for (int round = 0; round < 2000; ++round) {
    TypeParam volume;
    dice.make(volume);
    const Vec3d from(dice.vector(5)), normal = glm::normalize(Vec3d(dice.vector(4)) + Vec3d(0.1));
    const Interval<double> extent = extent_along(volume, normal, from);
    for (int i = 0; i < 30; ++i) {
      const Point p = exact::point(0.5f * dice.vector(12));
      if (!exact::holds(volume, p)) continue;
      ++held;
      const Rational along = dot(exact::minus(p, exact::point(from)), exact::point(normal));
      ASSERT_LE(Rational(extent.lo), along);
      ASSERT_GE(Rational(extent.hi), along);
      for (int axis = 0; axis < 3; ++axis) {
        const Interval<double> own = extent_along(volume, axis);
        ASSERT_LE(Rational(own.lo), p[static_cast<std::size_t>(axis)]);
        ASSERT_GE(Rational(own.hi), p[static_cast<std::size_t>(axis)]);
      }
    }
  }
  EXPECT_GT(held, 500);
}

/// The ends of extents are corners, where each rounding counts.
TEST(VolumeOverlap, ExtentsHoldTheCornersOfBoxes) {
  Dice dice{Random(5)};
  for (int round = 0; round < 1000; ++round) {
    const Vec3f a(dice.random.uniform(), dice.random.uniform(), dice.random.uniform());
    const Aabb box{-a, a * 3.0f};
    const Vec3d from(dice.vector(5)), normal = glm::normalize(Vec3d(dice.vector(4)) + Vec3d(0.1));
    const Interval<double> extent = extent_along(box, normal, from);
    for (int i = 0; i < 8; ++i) {
      const Vec3f corner(i & 1 ? box.lo.x : box.hi.x, i & 2 ? box.lo.y : box.hi.y, i & 4 ? box.lo.z : box.hi.z);
      const Rational along = dot(exact::minus(exact::point(corner), exact::point(from)), exact::point(normal));
      ASSERT_LE(Rational(extent.lo), along);
      ASSERT_GE(Rational(extent.hi), along);
    }
  }
}

/// Spheres are parted exactly where they are apart by more than rounding.
TEST(VolumeOverlap, SpheresThatTouchOverlap) {
  EXPECT_TRUE(may_overlap(Sphere{{0, 0, 0}, 2}, Sphere{{3, 4, 0}, 3}));
  EXPECT_FALSE(may_overlap(Sphere{{0, 0, 0}, 2}, Sphere{{3, 4, 0}, 2.9999f}));
}

/// Rods across each other, which boxes and balls around them would not part.
TEST(VolumeOverlap, PartsRodsThatPass) {
  const Cylinder rod{{0, 0, 0}, {3, 4, 0}, 0.5f, 10}, across{{0, 0, 1.001f}, {4, -3, 0}, 0.5f, 10};
  EXPECT_FALSE(may_overlap(rod, across));
  EXPECT_TRUE(may_overlap(rod, Cylinder{{0, 0, 0.999f}, {4, -3, 0}, 0.5f, 10}));
}

}  // namespace
}  // namespace sightline
