#include "sightline/accel/padded_ray.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "sightline/accel/slab_ray.h"
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

using Lanes = hn::CappedTag<float, 4>;

/// PaddedRay::clip with slabs. A template, for processors of one lane.
template <class D>
Interval<float> clip(const SlabRay<D>& slabs, const Aabb& box, float t_min, float far) {
  Interval<float> range{t_min, far};
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_negative = slabs.octant() >> axis & 1;
    const auto planes = [&](bool is_high) { return hn::Set(D(), (is_high ? box.hi : box.lo)[axis]); };
    range.lo = std::max(range.lo, hn::GetLane(slabs.enter(axis, planes(is_negative))));
    range.hi = std::min(range.hi, hn::GetLane(slabs.leave(axis, planes(!is_negative))));
  }
  return range;
}

struct Counts {
  int met = 0;
  int ordinary = 0;  ///< Of those.
};

template <class T>
void expect_no_skip(const Ray<T>& ray, const Aabb& scene, const Aabb& box, T far, Counts& counts) {
  const PaddedRay<T> padded(ray, scene);
  if (exactly_meets(ray, box, Rational(T(padded.pad / 2)), far)) {
    ++counts.met;
    EXPECT_FALSE(padded.clip(box, far).is_empty());
    if constexpr (std::is_same_v<T, float> && hn::MaxLanes(Lanes()) == 4) {
      const SlabRay<Lanes> slabs(ray, scene);
      if (!slabs.is_ordinary()) return;
      ++counts.ordinary;
      EXPECT_FALSE(clip(slabs, box, ray.t_min, far).is_empty());
    }
  }
}

/// Rays aimed at the corners and edges of boxes, at several scales and distances from the world's origin.
template <class T>
void check_silhouettes() {
  Random random(1);
  const auto coordinate = [&] { return random.uniform(-1, 1); };
  Counts counts;
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
        expect_no_skip(ray, scene, box, T(1e30), counts);
        expect_no_skip(ray, scene, box, T(1), counts);
      }
    }
  }
  EXPECT_GT(counts.met, 5000);
  if (std::is_same_v<T, float> && hn::MaxLanes(Lanes()) == 4) {
    EXPECT_GT(counts.ordinary, counts.met * 9 / 10);
  }
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

TEST(SlabRay, LeavesExtremesToPaddedRay) {
  if constexpr (hn::MaxLanes(Lanes()) == 4) {
    const Aabb scene{Vec3f(-1), Vec3f(1)};
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const auto is_ordinary = [&](const Ray<float>& ray) { return SlabRay<Lanes>(ray, scene).is_ordinary(); };
    EXPECT_TRUE(is_ordinary({{0, 0, -5}, {0, 0, 1}}));
    EXPECT_TRUE(is_ordinary({{1e9f, 0, 0}, {1e-20f, -0.f, 1e-9f}}));
    for (const Vec3f& odd : {Vec3f(nan, 0, 0), Vec3f(0, infinity, 0), Vec3f(0, 0, 1e38f)}) {
      EXPECT_FALSE(is_ordinary({odd, {0, 0, 1}}));
      EXPECT_FALSE(is_ordinary({{0, 0, 0}, odd}));
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (const float broken : {nan, infinity}) {
        Ray<float> origin{{1, 2, 3}, {3, 2, 1}}, direction = origin;
        origin.origin[axis] = broken;
        direction.direction[axis] = broken;
        EXPECT_FALSE(is_ordinary(origin));
        EXPECT_FALSE(is_ordinary(direction));
      }
    }
    EXPECT_FALSE(is_ordinary({{0, 0, 0}, {0, 0, 0}}));
    EXPECT_FALSE(is_ordinary({{0, 0, 0}, {0, 0, 1}, 2, 1}));
    EXPECT_FALSE(SlabRay<Lanes>({{0, 0, 0}, {0, 0, 1}}, Aabb{}).is_ordinary());
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
