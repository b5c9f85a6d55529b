#include "bench/verify.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "bench/checks.h"
#include "sightline/math/rounding.h"

namespace sightline::bench {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

Vec3f random_point(std::mt19937& random, float size) {
  std::uniform_real_distribution<float> coordinate(-size, size);
  const float x = coordinate(random), y = coordinate(random), z = coordinate(random);
  return {x, y, z};
}

/// Moeller and Trumbore 1997 in float, as a peer would: only t.
float t_from_stored_edges(const Triangle& triangle, const Ray<float>& ray) {
  const Vec3f normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
  return glm::dot(normal, triangle.a - ray.origin) / glm::dot(normal, ray.direction);
}

/// The same from corners moved to the origin first.
float t_from_moved_corners(const Triangle& triangle, const Ray<float>& ray) {
  const Vec3f a = triangle.a - ray.origin, b = triangle.b - ray.origin, c = triangle.c - ray.origin;
  const Vec3f normal = glm::cross(b - a, c - a);
  return glm::dot(normal, a) / glm::dot(normal, ray.direction);
}

/// Small triangles, seen from up to a thousand times their size.
TEST(ErrorBound, HoldsForFloatArithmeticAndIsTight) {
  std::mt19937 random(7);
  int informative = 0;
  for (int i = 0; i < 200'000; ++i) {
    const float size = std::ldexp(1.0f, -static_cast<int>(random() % 10));
    const Vec3f center = random_point(random, 1);
    const Triangle triangle{center + random_point(random, size), center + random_point(random, size),
                            center + random_point(random, size)};
    Ray<float> ray;
    ray.origin = random_point(random, 4);
    ray.direction = (triangle.a + triangle.b + triangle.c) / 3.0f - ray.origin;
    const double bound = t_error_bound(triangle, ray);
    const Vec3d normal = glm::cross(Vec3d(triangle.b) - Vec3d(triangle.a), Vec3d(triangle.c) - Vec3d(triangle.a));
    const double t = glm::dot(normal, Vec3d(triangle.a) - Vec3d(ray.origin)) / glm::dot(normal, Vec3d(ray.direction));
    if (std::isinf(bound)) continue;
    ASSERT_LE(std::fabs(t_from_stored_edges(triangle, ray) - t), bound) << i;
    ASSERT_LE(std::fabs(t_from_moved_corners(triangle, ray) - t), bound) << i;
    informative += bound < 1e-4;
  }
  EXPECT_GT(informative, 150'000) << "a bound that excludes nothing verifies nothing";
}

TEST(ErrorBound, SaysNothingEdgeOn) {
  const Triangle flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  Ray<float> along;
  along.origin = {-1, 0.25f, 0};
  along.direction = {1, 0, 0};
  EXPECT_TRUE(std::isinf(t_error_bound(flat, along)));
}

TEST(Agreement, AllowsRoundingAndNothingElse) {
  const TriangleMesh mesh({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}}, {{0, 1, 2}, {3, 4, 5}});
  Ray<float> ray;
  ray.origin = {0.25f, 0.25f, 0};
  const Hit<float> near{1, 0, 0.25f, 0.25f}, far{2, 1, 0.25f, 0.25f}, miss;
  EXPECT_TRUE(agrees(mesh, ray, near, near));
  EXPECT_TRUE(agrees(mesh, ray, miss, miss));
  EXPECT_TRUE(agrees(mesh, ray, near, {next_up(1.0f), 0, 0.25f, 0.25f}));
  EXPECT_FALSE(agrees(mesh, ray, near, {1.001f, 0, 0.25f, 0.25f}));
  EXPECT_FALSE(agrees(mesh, ray, near, far));
  EXPECT_FALSE(agrees(mesh, ray, near, miss));
  EXPECT_FALSE(agrees(mesh, ray, miss, near));
  EXPECT_FALSE(agrees(mesh, ray, near, {1, 77, 0, 0})) << "a triangle that does not exist";
}

TEST(Sameness, IsOfBits) {
  const Hit<float> hit{1, 0, 0.25f, 0.25f};
  EXPECT_TRUE(is_same(hit, hit));
  EXPECT_TRUE(is_same(Hit<float>{}, Hit<float>{}));
  EXPECT_FALSE(is_same(hit, {next_up(1.0f), 0, 0.25f, 0.25f}));
  EXPECT_FALSE(is_same(hit, {1, 1, 0.25f, 0.25f}));
  EXPECT_FALSE(is_same({1, 0, 0.0f, 0.25f}, {1, 0, -0.0f, 0.25f}));
}

/// Answers what it is told to.
class Scripted final : public Built {
 public:
  explicit Scripted(std::vector<float> t) : t_(std::move(t)) {}
  void closest_hits(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const override {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = answer(rays[i]);
  }
  void any_hits(std::span<const Ray<float>> rays, std::span<std::uint8_t> is_hit) const override {
    for (std::size_t i = 0; i < rays.size(); ++i) is_hit[i] = answer(rays[i]).is_hit();
  }
  Bytes bytes() const override { return {}; }

 private:
  /// Rays of the tests carry their number as the x of their origin.
  Hit<float> answer(const Ray<float>& ray) const {
    const float t = t_[static_cast<std::size_t>(ray.origin.x)];
    return t == infinity ? Hit<float>{} : Hit<float>{t, 0, 0, 0};
  }
  std::vector<float> t_;
};

class Refusal : public testing::Test {
 protected:
  Refusal() {
    for (std::size_t i = 0; i < rays_.size(); ++i) rays_[i].origin.x = static_cast<float>(i);
  }
  std::vector<Hit<float>> hits_of(const Built& built) const {
    std::vector<Hit<float>> hits(rays_.size());
    built.closest_hits(rays_, hits);
    return hits;
  }

  TriangleMesh mesh_{{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {{0, 1, 2}}};
  std::vector<Ray<float>> rays_{4};
  Scripted truth_{{1, 2, infinity, 4}};
};

TEST_F(Refusal, OfAWrongHitInTheSampleOrOutsideIt) {
  const Checks<Hit<float>> checks("scene primary", mesh_, rays_, truth_, truth_, {0, 2});
  EXPECT_EQ(checks.hit_share(), 0.75);
  EXPECT_NO_THROW(checks.require_right("right", hits_of(truth_)));
  for (const Scripted& wrong : {Scripted({next_up(1.0f), 2, infinity, 4}), Scripted({1, infinity, infinity, 4}),
                                Scripted({1, 2, 3, 4}), Scripted({1, 2, infinity, next_down(4.0f)})}) {
    EXPECT_THROW(checks.require_right("wrong", hits_of(wrong)), WrongHits);
  }
}

TEST_F(Refusal, NamesTheOneThatIsWrong) {
  const Scripted wrong({1, 2, infinity, 5});
  const auto message_of = [&](const Built& reference, const Built& asked) {
    const Checks<Hit<float>> checks("scene primary", mesh_, rays_, reference, truth_, {0});
    try {
      checks.require_right("tree", hits_of(asked));
    } catch (const WrongHits& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message_of(truth_, wrong),
            "tree is wrong, so no times are shown: scene primary ray 3: expected t 4 on triangle 0 (u 0, v 0), "
            "found t 5 on triangle 0 (u 0, v 0)");
  EXPECT_NE(message_of(wrong, truth_).find("the structure that all are compared with is wrong"), std::string::npos);
}

TEST_F(Refusal, OfAnyHitsAndOfSelectedRays) {
  const Checks<std::uint8_t> checks("scene shadow", mesh_, rays_, truth_, truth_, {1});
  EXPECT_NO_THROW(checks.require_right("right", std::vector<std::uint8_t>{1, 1, 0, 1}));
  EXPECT_THROW(checks.require_right("wrong", std::vector<std::uint8_t>{1, 1, 1, 1}), WrongHits);
  const std::vector<std::size_t> some{2, 3};
  EXPECT_NO_THROW(checks.require_right("right", std::vector<std::uint8_t>{0, 1}, some));
  EXPECT_THROW(checks.require_right("wrong", std::vector<std::uint8_t>{1, 1}, some), WrongHits);
  EXPECT_THROW(checks.require_right("short", std::vector<std::uint8_t>{1}), std::invalid_argument);
}

TEST_F(Refusal, PeersAreCountedInstead) {
  const Checks<std::uint8_t> checks("scene shadow", mesh_, rays_, truth_, truth_, {});
  EXPECT_EQ(checks.disagreeing(std::vector<std::uint8_t>{1, 0, 1, 1}), 2u);
  const std::vector<std::size_t> some{2, 3};
  EXPECT_EQ(checks.disagreeing(std::vector<std::uint8_t>{0, 0}, some), 1u);
}

}  // namespace
}  // namespace sightline::bench
