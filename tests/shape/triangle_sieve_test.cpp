/// The sieve of eight triangles: what the exact test accepts it never drops, what is clearly missed it drops, and what
/// it reports of its own accord lies where the exact test finds it.

#include "sightline/shape/triangle_sieve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/math/rounding.h"

namespace sightline {
namespace {

constexpr std::uint32_t lanes = TriangleBlock::lanes;

struct Block {
  std::vector<Triangle> triangles;
  std::vector<float> floats;

  explicit Block(std::vector<Triangle> those)
      : triangles(std::move(those)), floats(triangles.size() * TriangleBlock::rows + lanes) {
    for (std::uint32_t lane = 0; lane < count(); ++lane) {
      TriangleBlock::store(triangles[lane], lane, floats.data(), count(), lane);
    }
  }
  std::uint32_t count() const { return static_cast<std::uint32_t>(triangles.size()); }
  TriangleBlock view() const { return {floats.data(), count()}; }
  Aabb bounds() const {
    Aabb box;
    for (const Triangle& triangle : triangles) box.extend(bounds_of(triangle));
    return box;
  }
};

Vec3f random_point(Random& random, float from, float to) {
  return {random.uniform(from, to), random.uniform(from, to), random.uniform(from, to)};
}

/// One to eight triangles about as large as `size` in the cube [-1, 1], moved and scaled.
Block random_block(Random& random, float size, float scale, const Vec3f& offset) {
  std::vector<Triangle> triangles(1 + random.next() % lanes);
  for (Triangle& triangle : triangles) {
    const Vec3f at = random_point(random, -1, 1);
    triangle = {at + size * random_point(random, -1, 1), at + size * random_point(random, -1, 1),
                at + size * random_point(random, -1, 1)};
    for (Vec3f* corner : {&triangle.a, &triangle.b, &triangle.c}) *corner = scale * *corner + offset;
  }
  return Block(std::move(triangles));
}

/// At the inside, an edge or a corner of a triangle, as nearly as float can aim.
Ray<float> ray_at(Random& random, const Triangle& target, float distance) {
  float weights[3] = {random.uniform(0.f, 1.f), random.uniform(0.f, 1.f), random.uniform(0.f, 1.f)};
  for (std::uint64_t out = random.next() % 3; out > 0; --out) weights[out] = 0;
  const float sum = std::max(weights[0] + weights[1] + weights[2], 1e-6f);
  const Vec3f point = (weights[0] * target.a + weights[1] * target.b + weights[2] * target.c) / sum;
  const Vec3f origin = point + distance * random_point(random, -1, 1);
  return {origin, point - origin};
}

struct Setting {
  float size, scale, distance;
  Vec3f offset;
};
const std::vector<Setting> settings{
    {0.5f, 1, 4, {0, 0, 0}},     {0.01f, 1, 4, {0, 0, 0}},        {1e-5f, 1, 4, {0, 0, 0}},
    {0.1f, 1e-30f, 1e-29f, {}},  {0.1f, 1e18f, 1e19f, {}},        {0.1f, 1e30f, 1e31f, {}},
    {0.1f, 1, 3, {1e4f, -3, 5}}, {0.01f, 100, 1e6f, {0, 7e4, 0}}, {0.1f, 1e-12f, 1, {0, 0, 0}},
};

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Calls see(block, ray aimed at one of its triangles) often in every setting.
template <class See>
void for_each_case(std::uint64_t seed, See&& see) {
  Random random(seed);
  for (const Setting& at : settings) {
    SCOPED_TRACE(testing::Message() << "size " << at.size << " scale " << at.scale);
    for (int round = 0; round < 3000; ++round) {
      const Block block = random_block(random, at.size, at.scale, at.offset);
      see(block, ray_at(random, block.triangles[round % block.count()], at.distance));
    }
  }
}

/// How many of the block's triangles the exact test accepts, all of which the sieve has to keep.
template <class T>
int accepted_and_kept(const Block& block, const Ray<T>& ray) {
  const TriangleRay exact(to_double(ray), block.bounds());
  const TriangleSieve sieve(ray, block.bounds());
  const std::uint32_t kept = sieve.may_cross(block.view());
  EXPECT_LT(kept, 1u << block.count());
  int accepted = 0;
  for (std::uint32_t lane = 0; lane < block.count(); ++lane) {
    Crossing crossing;
    const bool is_hit = exact.intersect(block.triangles[lane], crossing);
    accepted += is_hit;
    if (!is_hit) continue;
    EXPECT_TRUE(kept >> lane & 1);
  }
  return accepted;
}

TEST(TriangleSieve, KeepsWhatTheExactTestAccepts) {
  int accepted = 0;
  for_each_case(51, [&](const Block& block, const Ray<float>& ray) {
    accepted += accepted_and_kept(block, ray);
    Ray<double> wide = to_double(ray);
    accepted_and_kept(block, wide);
    wide.origin += 1e-9 * wide.direction;  // no float any more
    accepted_and_kept(block, wide);
  });
  EXPECT_GT(accepted, 10'000);
}

TEST(TriangleSieve, DropsWhatIsMissed) {
  Random random(52);
  int kept = 0, accepted = 0;
  for (int round = 0; round < 5000; ++round) {
    const Block block = random_block(random, 0.4f, 1, Vec3f(0));
    const Ray<double> ray = to_double(Ray<float>{random_point(random, -1, 1), random_point(random, -1, 1)});
    const TriangleRay exact(ray, block.bounds());
    kept += std::popcount(TriangleSieve(ray, block.bounds()).may_cross(block.view()));
    for (const Triangle& triangle : block.triangles) {
      Crossing crossing;
      accepted += exact.intersect(triangle, crossing);
    }
  }
  EXPECT_GT(accepted, 20);
  EXPECT_LE(kept, accepted + 2);
}

TEST(TriangleSieve, CrossesWhereTheExactTestDoes) {
  int hits = 0;
  for_each_case(53, [&](const Block& block, const Ray<float>& ray) {
    const Ray<double> wide = to_double(ray);
    TriangleSieve::Crossings found;
    TriangleSieve(ray, block.bounds()).cross(block.view(), 0, 1e30f, found);
    EXPECT_EQ(found.hits & found.unsure, 0u);
    for (std::uint32_t lane = 0; lane < block.count(); ++lane) {
      if (!(found.hits >> lane & 1)) continue;
      ++hits;
      EXPECT_TRUE(found.u[lane] >= 0 && found.v[lane] >= 0 && found.u[lane] + found.v[lane] <= 1.000001f);
      // E4: the point on the ray is the point with those weights.
      const Triangle& triangle = block.triangles[lane];
      const double u = found.u[lane], v = found.v[lane];
      const Vec3d point = (1 - u - v) * Vec3d(triangle.a) + u * Vec3d(triangle.b) + v * Vec3d(triangle.c);
      EXPECT_LE(max_norm(wide.at(found.t[lane]) - point), 32 * 0x1p-24 * reach_of(wide.origin, block.bounds()));
    }
  });
  EXPECT_GT(hits, 5000);
}

TEST(TriangleSieve, HitsOnlyWithinTheRange) {
  const Block block({{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}});
  const Ray<double> ray{{0.25, 0.25, 0}, {0, 0, 1}};
  const TriangleSieve sieve(ray, block.bounds());
  TriangleSieve::Crossings found;
  sieve.cross(block.view(), 0, 3, found);
  EXPECT_EQ(found.hits, 3u);
  EXPECT_EQ(found.t[0], 1);
  EXPECT_EQ(found.t[1], 2);
  sieve.cross(block.view(), 1, 2, found);
  EXPECT_EQ(found.hits, 2u);
  sieve.cross(block.view(), 0, 1.5f, found);
  EXPECT_EQ(found.hits, 1u);
}

}  // namespace
}  // namespace sightline
