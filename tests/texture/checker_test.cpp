#include "sightline/texture/checker.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sightline/math/random.h"

namespace sightline {
namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;

bool is_odd(const cpp_rational& q) {
  cpp_int whole = numerator(q) / denominator(q);
  if (q < cpp_rational(whole)) --whole;
  return whole % 2 != 0;
}

bool exact_is_odd(double size, const Vec3d& p) {
  bool odd = false;
  for (int axis = 0; axis < 3; ++axis) odd ^= is_odd(cpp_rational(p[axis]) / cpp_rational(size));
  return odd;
}

/// The point is never rounded.
bool exact_is_odd(double size, const AxisPlane& plane, const Ray<double>& ray) {
  const cpp_rational t =
      (cpp_rational(plane.at) - cpp_rational(ray.origin[plane.axis])) / cpp_rational(ray.direction[plane.axis]);
  bool odd = is_odd(cpp_rational(plane.at) / cpp_rational(size));
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == plane.axis) continue;
    const cpp_rational x = cpp_rational(ray.origin[axis]) + t * cpp_rational(ray.direction[axis]);
    odd ^= is_odd(cpp_rational(x / cpp_rational(size)));
  }
  return odd;
}

TEST(Checker, HasTheCellOfRealArithmetic) {
  Random random(1);
  for (const double size : {1.0, 0.1, 0.3, 7.7, 0x1p-20, 1 - 0x1p-53}) {
    const Checker checker({.size = size});
    for (int i = 0; i < 4000; ++i) {
      Vec3d p;
      for (int axis = 0; axis < 3; ++axis) {
        // Half of them as near a boundary as a double can be.
        p[axis] = std::ldexp(random.uniform_double() - 0.5, static_cast<int>(random.below(80)) - 10);
        if (random.below(2) == 0) p[axis] = std::round(p[axis] / size) * size;
        const std::uint32_t side = random.below(3);
        if (side < 2) p[axis] = std::nextafter(p[axis], side == 0 ? -1e300 : 1e300);
      }
      EXPECT_EQ(checker.is_odd(p), exact_is_odd(size, p)) << size << ": " << p.x << ' ' << p.y << ' ' << p.z;
      EXPECT_EQ(checker(p), checker.is_odd(p) ? checker.options().odd : checker.options().even);
      EXPECT_EQ(checker.is_odd(glm::dvec2(p.x, p.y)),
                is_odd(cpp_rational(p.x) / cpp_rational(size)) != is_odd(cpp_rational(p.y) / cpp_rational(size)));
    }
  }
}

TEST(Checker, IsRightBeyondWholeNumbers) {
  Random random(2);
  for (const double size : {1.0, 0.3, 3.0}) {
    const Checker checker({.size = size});
    int odd = 0;
    for (int i = 0; i < 1000; ++i) {
      const Vec3d p(std::ldexp(0.5 + random.uniform_double(), 53 + i % 900), 0, -0x1p53);
      EXPECT_EQ(checker.is_odd(p), exact_is_odd(size, p)) << p.x;
      odd += checker.is_odd(p);
    }
    EXPECT_EQ(odd > 200, size != 1) << "whole numbers beyond 2^54 are even";
  }
  EXPECT_NO_THROW(Checker().is_odd(Vec3d(std::numeric_limits<double>::infinity(), std::nan(""), 0)));
}

/// pln-checker-far: rays in float from high above meet the floor far away.
TEST(HardCases, CheckerFar) {
  Random random(3);
  int wrong_in_float = 0, wrong_by_point = 0, on_boundary = 0;
  constexpr int count = 20'000;
  for (int i = 0; i < count; ++i) {
    const double size = i % 3 == 0 ? 1.0 : 0.25 + random.uniform_double();
    const Checker checker({.size = size});
    Ray<float> ray{{random.uniform(-10, 10), random.uniform(0.5f, 4), random.uniform(-10, 10)}, {}};
    if (i % 2 == 0) {
      ray.direction = {random.uniform(-1, 1), -std::pow(10.0f, random.uniform(-5, -4)), random.uniform(-1, 1)};
    } else {  // meets whole numbers exactly
      ray.origin = glm::round(ray.origin) + Vec3f(0, 1, 0);
      ray.direction = {std::ldexp(static_cast<float>(random.below(64)), -6), -0x1p-16f,
                       std::ldexp(static_cast<float>(random.below(64)), -6)};
      on_boundary += size == 1;
    }
    const AxisPlane floor{1, 0};
    const Ray<double> exact = to_double(ray);
    const bool expected = exact_is_odd(size, floor, exact);
    ASSERT_EQ(checker.is_odd(floor, ray), expected) << i;
    ASSERT_EQ(checker.is_odd(floor, exact), expected) << i;

    const float t = -ray.origin.y / ray.direction.y;
    const Vec3f p = ray.origin + t * ray.direction;
    wrong_in_float += checker.is_odd(Vec3d(p.x, 0, p.z)) != expected;
    const double s = -exact.origin.y / exact.direction.y;
    wrong_by_point += checker.is_odd(Vec3d(exact.origin.x + s * exact.direction.x, 0,
                                           exact.origin.z + s * exact.direction.z)) != expected;
  }
  EXPECT_GT(on_boundary, count / 10);
  EXPECT_GT(wrong_in_float, count / 1000) << "the case is hard";
  EXPECT_LE(wrong_by_point, 2) << "a point in double is right but on a boundary";
}

TEST(Checker, SettlesRaysThroughBoundaries) {
  // Thirds are no doubles: only exact arithmetic knows that the line meets the boundary itself.
  Random random(4);
  int ties = 0;
  for (int i = 0; i < 5000; ++i) {
    const double k = random.below(1000), ahead = 3 + random.below(5), up = 1 + random.below(9);
    const double nudge = i % 3 == 0 ? 0 : (i % 3 == 1 ? 0x1p-52 : -0x1p-52);
    const Ray<double> ray{{k - ahead, up * (1 + nudge), 0.5}, {ahead / 8, -up / 8, 0}};
    ties += i % 3 == 0;
    const AxisPlane floor{1, 0};
    ASSERT_EQ(Checker().is_odd(floor, ray), exact_is_odd(1, floor, ray)) << i;
    const AxisPlane wall{0, k / 3};
    ASSERT_EQ(Checker({.size = 0.7}).is_odd(wall, ray), exact_is_odd(0.7, wall, ray)) << i;
  }
  EXPECT_GT(ties, 1000);
}

/// pln-checker-y0: the floor is one layer of the checker in space, whatever the sign of its zero.
TEST(HardCases, CheckerOnYIsZero) {
  const Checker checker;
  Random random(5);
  int flipped = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double x = 100 * random.uniform_double() - 50, z = 100 * random.uniform_double() - 50;
    const bool layer = checker.is_odd(glm::dvec2(x, z));
    ASSERT_EQ(checker.is_odd(Vec3d(x, 0.0, z)), layer);
    ASSERT_EQ(checker.is_odd(Vec3d(x, -0.0, z)), layer);
    ASSERT_EQ(checker(Vec3d(x, -0.0, z)), checker(Vec3d(x, 0.0, z)));
    // Of a plane's footprint, which has no height, the mean is that of the layer.
    const Footprint flat(Vec3d(0.75, 0, 0.25), Vec3d(0, 0, 0.5));
    ASSERT_EQ(checker.value(Vec3d(x, -0.0, z), flat), checker.value(glm::dvec2(x, z), glm::dvec2(0.75, 0.75)));

    const Ray<float> ray{{static_cast<float>(x), 3.3f, static_cast<float>(z)},
                         {random.uniform(-1, 1), -random.uniform(0.1f, 1), random.uniform(-1, 1)}};
    ASSERT_EQ(checker.is_odd({1, 0.0}, ray), checker.is_odd({1, -0.0}, ray));
    ASSERT_EQ(checker.is_odd({1, 0.0}, ray), exact_is_odd(1, {1, 0.0}, to_double(ray)));
    flipped += ray.at(-ray.origin.y / ray.direction.y).y < 0;
  }
  EXPECT_GT(flipped, 200) << "a rounded point would be below";
}

TEST(Checker, HasItsMeanInAFootprint) {
  const Checker checker({.size = 0.5});
  Random random(6);
  for (int i = 0; i < 40; ++i) {
    const Vec3d p(random.uniform_double(), random.uniform_double(), random.uniform_double());
    Footprint footprint;
    footprint.extent = 2.0 * Vec3d(random.uniform_double(), random.uniform_double(), random.uniform_double());
    double sum = 0;
    constexpr int side = 40;
    for (int k = 0; k < side * side * side; ++k) {
      const Vec3d at(k % side, k / side % side, k / (side * side));
      sum += checker.is_odd(p + ((at + 0.5) / double(side) - 0.5) * footprint.extent);
    }
    EXPECT_NEAR(checker.value(p, footprint), sum / (side * side * side), 0.02);
  }
  EXPECT_NEAR(checker.value({0.1, 0.2, 0.3}, Footprint(1e6)), 0.5, 1e-9);
}

TEST(Checker, RefusesBadSizes) {
  for (const double size : {0.0, -1.0, std::nan(""), 1e300}) {
    EXPECT_THROW(Checker({.size = size}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace sightline
