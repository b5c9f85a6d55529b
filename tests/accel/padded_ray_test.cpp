#include "sightline/accel/padded_ray.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "sightline/math/random.h"

namespace sightline {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// Whether the exact line, widened by half the margin, meets the box somewhere in [t_min, far]: what must not be
/// skipped (M2).
template <class T>
bool exactly_meets(const Ray<T>& ray, const Aabb& box, const Rational& pad, T far) {
  Rational enter(ray.t_min), leave(far);
  for (int axis = 0; axis < 3; ++axis) {
    const Rational o(ray.origin[axis]), d(ray.direction[axis]);
    const Rational lo = Rational(box.lo[axis]) - pad - o, hi = Rational(box.hi[axis]) + pad - o;
    if (d == 0) {
      if (lo > 0 || hi < 0) return false;
      continue;
    }
    const Rational first = d > 0 ? Rational(lo / d) : Rational(hi / d),
                   last = d > 0 ? Rational(hi / d) : Rational(lo / d);
    if (first > enter) enter = first;
    if (last < leave) leave = last;
  }
  return enter <= leave;
}

template <class T>
void expect_no_skip(const Ray<T>& ray, const Aabb& scene, const Aabb& box, T far, int& met) {
  const PaddedRay<T> padded(ray, scene);
  if (exactly_meets(ray, box, Rational(T(padded.pad / 2)), far)) {
    ++met;
    EXPECT_FALSE(padded.clip(box, far).is_empty());
  }
}

/// Rays aimed at the corners and edges of boxes, at several scales and distances from the world's origin.
template <class T>
void check_silhouettes() {
  Random random(1);
  const auto coordinate = [&] { return random.uniform(-1, 1); };
  int met = 0;
  for (const float scale : {1e-12f, 1.f, 1e12f}) {
    for (const float offset : {0.f, 1000.f}) {
      for (int i = 0; i < 3000; ++i) {
        Aabb box;
        for (int k = 0; k < 2; ++k) {
          const float x = coordinate(), y = coordinate(), z = i % 5 == 0 ? 0.5f : coordinate();
          box.extend(scale * (Vec3f(x, y, z) + Vec3f(offset)));
        }
        const Aabb scene{scale * Vec3f(offset - 1), scale * Vec3f(offset + 1)};
        Vec3<T> corner, origin;
        for (int axis = 0; axis < 3; ++axis) {
          corner[axis] =
              random.below(3) == 0 ? T(box.center()[axis]) : T(random.below(2) ? box.lo[axis] : box.hi[axis]);
          origin[axis] = random.below(4) == 0 ? corner[axis] : T(scale * (offset + 3 * coordinate()));
        }
        const Ray<T> ray{origin, corner - origin};
        if (!is_valid(ray)) continue;
        expect_no_skip(ray, scene, box, T(1e30), met);
        expect_no_skip(ray, scene, box, T(1), met);
      }
    }
  }
  EXPECT_GT(met, 5000);
}

TEST(PaddedRay, SkipsNoBoxThatTheExactRayMeetsFloat) { check_silhouettes<float>(); }
TEST(PaddedRay, SkipsNoBoxThatTheExactRayMeetsDouble) { check_silhouettes<double>(); }

TEST(PaddedRay, SkipsBoxesFurtherThanTheMargin) {
  const Aabb scene{Vec3f(-1), Vec3f(1)};
  const PaddedRay<float> padded({{0, 0.5f, -5}, {0, 0, 1}}, scene);
  EXPECT_FALSE(padded.clip({{-1, -1, -1}, {1, 0.5f, 1}}, 100).is_empty());
  EXPECT_TRUE(padded.clip({{-1, -1, -1}, {1, 0.4999f, 1}}, 100).is_empty());
  EXPECT_TRUE(padded.clip({{-1, -1, -1}, {1, 0.5f, 1}}, 3.9f).is_empty());
}

TEST(PaddedRay, KeepsABoxWhoseFaceItRunsIn) {
  const Aabb box{Vec3f(-1), Vec3f(1)};
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.f, 1.f}) {
      for (const float zero : {0.f, -0.f}) {
        for (const float way : {-1.f, 1.f}) {
          Ray<float> ray{Vec3f(0), Vec3f(zero)};
          ray.origin[axis] = side;
          ray.origin[(axis + 1) % 3] = -5 * way;
          ray.direction[(axis + 1) % 3] = way;
          EXPECT_FALSE(PaddedRay<float>(ray, box).clip(box, 100).is_empty());
        }
      }
    }
  }
}

TEST(PaddedRay, KeepsABoxThatItApproachesTooSlowlyToInvert) {
  const Aabb scene{Vec3f(-1), Vec3f(1)};
  const PaddedRay<float> padded({{-0x1p-2f, 0, -1}, {0x1p-129f, 0, 0x1p-127f}}, scene);
  EXPECT_FALSE(padded.clip({{0, -1, -0.5f}, {1, 1, 0.5f}}, 0x1.fp127f).is_empty());
}

TEST(PaddedRay, OfABrokenRayMeetsNothing) {
  const Aabb box{Vec3f(-1), Vec3f(1)};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(PaddedRay<float>({{nan, 0, 0}, {0, 0, 1}}, box).clip(box, 100).is_empty());
  EXPECT_TRUE(PaddedRay<float>({{0, 0, 0}, {0, 0, 0}}, box).clip(box, 100).is_empty());
  EXPECT_TRUE(PaddedRay<float>({{0, 0, 0}, {0, 0, 1}}, Aabb{}).clip(box, 100).is_empty());
}

}  // namespace
}  // namespace sightline
