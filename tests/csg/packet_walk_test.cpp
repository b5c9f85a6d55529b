// Rays of a packet through convex parts at once: what is found of a ray is what the ray finds alone, bit for bit.
#include "sightline/csg/packet_walk.h"

#include <gtest/gtest.h>

#include "sightline/csg/evaluator.h"
#include "tests/csg/random_convex.h"

namespace sightline {
namespace {

using Rays = std::vector<Ray<double>>;
using Limits = RayPacket<double>::Lanes;

/// Of one octant, from about the same place.
Rays neighbours(Convex& convex, Random& random) {
  Ray<double> first = convex.ray();
  for (int axis = 0; axis < 3; ++axis) {
    if (first.direction[axis] == 0) first.direction[axis] = random.below(2) == 0 ? 1 : -1;
  }
  Rays rays(RayPacket<double>::size, first);
  for (Ray<double>& ray : rays) {
    for (int axis = 0; axis < 3; ++axis) ray.direction[axis] *= 1 + random.below(5) / 8.0;
    if (random.below(3) == 0) ray.origin += 0.5 * convex.point(1);
    if (random.below(4) == 0) ray.t_min = 0.5 * convex.coordinate(1);
    if (random.below(4) == 0) ray.t_max = ray.t_min + 1;
  }
  return rays;
}

struct Counts {
  std::size_t found = 0, none = 0, unclear = 0, refined = 0, taken = 0;
};

template <Level level>
void compare(std::uint64_t seed, Counts& counts) {
  Convex convex(seed);
  Random random(seed ^ 0x5eed);
  const Solid solid(convex.solid());
  const ConvexParts* parts = solid.convex_parts();
  if (!parts || !parts->lanes || solid.bounds().is_empty()) return;
  for (int round = 0; round < 4; ++round) {
    const Rays rays = neighbours(convex, random);
    const RayPacket<double> packet(rays, solid.bounds());
    if (!packet.is_coherent()) continue;
    const SolidPacket<level> ready(packet);
    Limits limits = packet.farthest();
    for (double& limit : limits) limit += limit_slack<level>(limit);
    const auto asked = static_cast<std::uint32_t>(random.below(1 << 16));
    PacketWalk<level> rough(*parts->lanes, ready), walk(*parts->lanes, ready);
    rough.template run<false>(asked, limits);
    walk.template run<true>(asked, limits);
    ASSERT_EQ((walk.found | walk.unclear | walk.reached) & ~asked, 0u);
    ASSERT_EQ(walk.found & walk.unclear, 0u);
    ASSERT_EQ(walk.found, rough.found);
    const std::uint32_t sure = rough.surely_within(packet.farthest());
    for (std::uint32_t i = 0; i < rays.size(); ++i) {
      if (!(asked >> i & 1)) continue;
      const QuickRay<level> quick(rays[i]);
      NoSolidProbe probe;
      SolidEvaluator<level> alone(solid, rays[i], probe);
      const auto first = alone.first(rays[i].t_min, rays[i].t_max);
      counts.unclear += walk.unclear >> i & 1;
      if (walk.unclear >> i & 1) continue;
      if (!(walk.found >> i & 1)) {
        ASSERT_FALSE(first) << "seed " << seed << " ray " << i;
        ++counts.none;
        continue;
      }
      // As far as it is not beyond the limit, which has slack.
      if (sure >> i & 1) {
        ASSERT_TRUE(first) << "seed " << seed << " ray " << i;
      }
      if (!first) continue;
      const Boundary found = refined_boundary(solid, walk.boundary(i), quick);
      ASSERT_EQ(found.t, first->t) << "seed " << seed << " ray " << i;
      ASSERT_EQ(found.primitive, first->primitive);
      ASSERT_EQ(found.face, first->face);
      ASSERT_EQ(found.root, first->root);
      ASSERT_EQ(found.is_flipped, first->is_flipped);
      ++counts.found;
      counts.taken += found.is_flipped;
      counts.refined += walk.boundary(i).t != rough.boundary(i).t;
    }
  }
}

template <Level level>
void compare_many() {
  Counts counts;
  for (std::uint64_t seed = 1; seed < 24000 && !testing::Test::HasFatalFailure(); seed += 2) {
    compare<level>(seed, counts);
  }
  EXPECT_GT(counts.found, 8000u);
  EXPECT_GT(counts.taken, 400u);
  EXPECT_GT(counts.none, 20000u);
  EXPECT_LT(counts.unclear, counts.found + counts.none) << "most rays are answered together";
  if (level == Level::watertight) {
    EXPECT_GT(counts.refined, 10u);
  }
}

TEST(PacketWalk, FindsWhatRaysFindAlone) {
  if (has_lane_roots<Level::fast>) compare_many<Level::fast>();
  compare_many<Level::watertight>();
  compare_many<Level::precise>();
  compare_many<Level::exact>();
}

TEST(PacketWalk, LeavesWhatIsNotModerate) {
  const Solid ball(solid::Sphere{});
  Rays rays(RayPacket<double>::size, {Vec3d(-4.0, -4.1, -4.2), Vec3d(1)});
  rays[3].origin *= 0x1p+40;
  rays[5].direction *= 0x1p+40;
  const RayPacket<double> packet(rays, ball.bounds());
  ASSERT_TRUE(packet.is_coherent());
  const SolidPacket<Level::watertight> ready(packet);
  PacketWalk<Level::watertight> walk(*ball.convex_parts()->lanes, ready);
  walk.run<true>(0xffff, packet.farthest());
  EXPECT_EQ(walk.unclear, 1u << 3 | 1u << 5);
  EXPECT_EQ(walk.found, 0xffffu & ~walk.unclear);
}

}  // namespace
}  // namespace sightline
