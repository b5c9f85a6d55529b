#include "sightline/accel/ray_packet.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "sightline/math/random.h"

namespace sightline {
namespace {

template <class T>
class RayPacketTest : public ::testing::Test {};
using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RayPacketTest, Numbers);

template <class T>
using Rays = std::array<Ray<T>, RayPacket<T>::size>;

/// Of any octant, but all of the same; origins on a lattice, so that planes and ends of ranges are met exactly.
template <class T>
Rays<T> coherent_rays(Random& random) {
  const auto number = [&] { return static_cast<T>(random.below(17)) / 4 - 2; };
  Vec3<T> direction, origin;
  for (int axis = 0; axis < 3; ++axis) {
    direction[axis] = static_cast<T>(std::ldexp(1, -static_cast<int>(random.below(12))));
    if (random.below(2) == 0) direction[axis] = -direction[axis];
    origin[axis] = number();
  }
  const T spread = random.below(3) == 0 ? 0 : T(0.25);
  Rays<T> rays;
  for (Ray<T>& ray : rays) {
    for (int axis = 0; axis < 3; ++axis) {
      ray.origin[axis] = origin[axis] + (random.below(2) == 0 ? spread * number() : 0);
      ray.direction[axis] = direction[axis] * (1 + spread * static_cast<T>(random.below(8)));
    }
    ray.t_min = random.below(4) == 0 ? number() : 0;
    ray.t_max = random.below(2) == 0 ? std::numeric_limits<T>::infinity() : ray.t_min + 2 + number();
  }
  return rays;
}

Aabb lattice_box(Random& random) {
  Aabb box;
  for (int i = 0; i < 2; ++i) {
    Vec3f corner;
    for (int axis = 0; axis < 3; ++axis) corner[axis] = static_cast<float>(random.below(9)) / 2 - 2;
    box.extend(corner);
  }
  return box;
}

TYPED_TEST(RayPacketTest, SkipsForAllRaysWhatEachOfThemSkips) {
  using T = TypeParam;
  const Aabb scene{Vec3f(-2), Vec3f(2)};
  Random random(1);
  int met = 0, skipped = 0, parted = 0;
  for (int round = 0; round < 20'000; ++round) {
    const Rays<T> rays = coherent_rays<T>(random);
    const std::size_t count = 1 + random.below(RayPacket<T>::size);
    const RayPacket<T> packet(std::span<const Ray<T>>(rays).first(count), scene);
    ASSERT_TRUE(packet.is_coherent());
    const Aabb box = lattice_box(random);
    typename RayPacket<T>::Lanes limits;
    std::uint32_t expected = 0;
    T far = -std::numeric_limits<T>::infinity();
    for (std::size_t i = 0; i < RayPacket<T>::size; ++i) {
      const Ray<T>& ray = rays[std::min(i, count - 1)];
      const PaddedRay<T> padded(ray, scene);
      limits[i] = random.below(3) == 0 ? ray.t_min + T(0.5) : ray.t_max;
      far = std::max(far, limits[i]);
      expected |= std::uint32_t{!padded.clip(box, limits[i]).is_empty()} << i;
      for (int axis = 0; axis < 3; ++axis) {
        for (const float plane : {box.lo[axis], box.hi[axis]}) {
          ASSERT_LE(packet.along(axis).enter(plane), padded.enter(axis, plane));
          ASSERT_GE(packet.along(axis).leave(plane), padded.leave(axis, plane));
        }
        ASSERT_EQ(packet.is_negative[axis], padded.is_negative[axis]);
      }
      ASSERT_LE(packet.t_min, ray.t_min);
      ASSERT_GE(packet.t_max, ray.t_max);
    }
    ASSERT_EQ(packet.meeting(box, limits), expected);
    const bool is_skipped = packet.clip(box, far).is_empty();
    ASSERT_FALSE(is_skipped && expected != 0);
    ASSERT_EQ(RayPacket<T>::greatest(limits), far);
    met += expected != 0;
    skipped += is_skipped;
    parted += expected != 0 && std::popcount(expected) < 16;
  }
  EXPECT_GT(met, 2000);
  EXPECT_GT(skipped, 4000);
  EXPECT_GT(parted, 1000);
}

TYPED_TEST(RayPacketTest, LeavesOthersThanCoherentOrdinaryRaysAlone) {
  using T = TypeParam;
  const Aabb scene{Vec3f(-2), Vec3f(2)};
  const T infinity = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
  const T huge = std::numeric_limits<T>::max(), tiny = std::numeric_limits<T>::min();
  for (std::size_t place = 0; place < RayPacket<T>::size; ++place) {
    const auto is_coherent = [&](auto&& change) {
      Rays<T> rays;
      rays.fill({Vec3<T>(-3, -2, -1), Vec3<T>(1, 2, 3), 0, 10});
      change(rays[place]);
      return RayPacket<T>(rays, scene).is_coherent();
    };
    EXPECT_TRUE(is_coherent([](Ray<T>&) {}));
    EXPECT_TRUE(is_coherent([&](Ray<T>& ray) { ray.t_max = infinity; }));
    EXPECT_TRUE(is_coherent([&](Ray<T>& ray) { ray.t_min = -infinity; }));
    EXPECT_FALSE(is_coherent([](Ray<T>& ray) { ray.t_min = 11; }));
    EXPECT_FALSE(is_coherent([&](Ray<T>& ray) { ray.t_max = nan; }));
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_FALSE(is_coherent([&](Ray<T>& ray) { ray.direction[axis] = -1; })) << "another octant";
      for (const T bad : {T(0), T(-0.0), nan, infinity, huge, tiny}) {
        EXPECT_FALSE(is_coherent([&](Ray<T>& ray) { ray.direction[axis] = bad; })) << bad;
      }
      for (const T bad : {nan, infinity, -infinity, huge}) {
        EXPECT_FALSE(is_coherent([&](Ray<T>& ray) { ray.origin[axis] = bad; })) << bad;
      }
    }
  }
  Rays<T> rays;
  rays.fill({Vec3<T>(0), Vec3<T>(1, 2, 3)});
  EXPECT_FALSE(RayPacket<T>(rays, Aabb{Vec3f(0), Vec3f(0)}).is_coherent()) << "no reach";
  EXPECT_FALSE(RayPacket<T>(rays, Aabb()).is_coherent()) << "no bounds";
}

}  // namespace
}  // namespace sightline
