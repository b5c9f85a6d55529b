#include "sightline/shape/triangle.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <optional>

#include "sightline/accel/padded_ray.h"
#include "sightline/math/random.h"
#include "sightline/shape/mesh.h"

namespace sightline {
namespace {

using Rational = boost::multiprecision::cpp_rational;

struct ExactVector {
  Rational x, y, z;
};
ExactVector exact(const Vec3d& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
ExactVector operator-(const ExactVector& p, const ExactVector& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
Rational dot(const ExactVector& p, const ExactVector& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
ExactVector cross(const ExactVector& p, const ExactVector& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

struct ExactCrossing {
  Rational t;
  ExactVector point;
};

/// Plane first, then three inside tests against the normal: another road than the one under test.
std::optional<ExactCrossing> exact_crossing(const Ray<double>& ray, const Triangle& triangle) {
  const ExactVector a = exact(Vec3d(triangle.a)), b = exact(Vec3d(triangle.b)), c = exact(Vec3d(triangle.c));
  const ExactVector o = exact(ray.origin), d = exact(ray.direction);
  const ExactVector normal = cross(b - a, c - a);
  const Rational slope = dot(normal, d);
  if (slope == 0) return std::nullopt;
  const Rational t = dot(normal, a - o) / slope;
  const ExactVector p{o.x + t * d.x, o.y + t * d.y, o.z + t * d.z};
  if (dot(cross(b - a, p - a), normal) < 0 || dot(cross(c - b, p - b), normal) < 0 ||
      dot(cross(a - c, p - c), normal) < 0) {
    return std::nullopt;
  }
  return ExactCrossing{t, p};
}

double size_of(const ExactVector& v) {
  return std::max(
      {std::fabs(v.x.convert_to<double>()), std::fabs(v.y.convert_to<double>()), std::fabs(v.z.convert_to<double>())});
}

/// Decisions are those of real arithmetic (T1), and the point reported is within half the double margin of the true one
/// (T2), by t as by the weights, and on the true side of the origin (T3).
void expect_exact(const Ray<double>& ray, const Triangle& triangle, int& hits) {
  const TriangleRay prepared(ray, bounds_of(triangle));
  Crossing crossing{};
  const bool is_found = prepared.intersect(triangle, crossing);
  const auto expected = exact_crossing(ray, triangle);
  ASSERT_EQ(is_found, expected.has_value());
  if (!is_found) return;
  ++hits;
  const double error = std::fabs(Rational(Rational(crossing.t) - expected->t).convert_to<double>());
  const double allowed = margin<double> / 2 * reach_of(ray.origin, bounds_of(triangle));
  ASSERT_LE(error * max_norm(ray.direction), allowed);
  ASSERT_EQ((crossing.t > 0) - (crossing.t < 0), expected->t.sign());
  ASSERT_GE(crossing.u, -1e-9);
  ASSERT_GE(crossing.v, -1e-9);
  ASSERT_LE(crossing.u + crossing.v, 1 + 1e-9);
  const Rational u(crossing.u), v(crossing.v);
  const ExactVector a = exact(Vec3d(triangle.a)), to_b = exact(Vec3d(triangle.b)) - a,
                    to_c = exact(Vec3d(triangle.c)) - a, from_a = expected->point - a;
  const ExactVector by_weights{u * to_b.x + v * to_c.x, u * to_b.y + v * to_c.y, u * to_b.z + v * to_c.z};
  ASSERT_LE(size_of(by_weights - from_a), allowed);
}

Vec3f random_point(Random& random, float size) {
  const float x = random.uniform(-size, size), y = random.uniform(-size, size), z = random.uniform(-size, size);
  return {x, y, z};
}

TEST(Triangle, IsExactForRandomRays) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Triangle triangle{random_point(random, 1), random_point(random, 1), random_point(random, 1)};
    const Vec3d origin(random_point(random, 2));
    expect_exact({origin, Vec3d(random_point(random, 0.5f)) - origin}, triangle, hits);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(hits, 1000);
}

TEST(Triangle, IsExactAtEdgesCornersAndEdgeOn) {
  Random random(2);
  int hits = 0;
  for (int i = 0; i < 20'000; ++i) {
    const float scale = i % 3 == 0 ? 1e-6f : 1;
    const Vec3f offset = i % 2 == 0 ? random_point(random, 100) : Vec3f(0);
    const Triangle triangle{random_point(random, scale) + offset, random_point(random, scale) + offset,
                            random_point(random, scale) + offset};
    const double share = i % 4 == 0 ? 0 : random.uniform_double();
    const Vec3d on_edge = Vec3d(triangle.a) + share * (Vec3d(triangle.b) - Vec3d(triangle.a));
    Vec3d origin(random_point(random, 3));
    if (i % 5 == 0)
      origin = on_edge + 2.0 * (Vec3d(triangle.c) - on_edge);  // in the triangle's plane, but for rounding
    Ray<double> ray{origin, on_edge - origin};
    if (i % 7 == 0) ray = to_double(Ray<float>{Vec3f(ray.origin), Vec3f(ray.direction)});
    if (!is_valid(ray)) continue;
    expect_exact(ray, triangle, hits);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(hits, 2000);
}

TEST(Triangle, IsExactForSliversOfEveryAspect) {
  Random random(3);
  int hits = 0;
  for (int power = 1; power <= 30; ++power) {
    for (int i = 0; i < 400; ++i) {
      const Vec3f a = random_point(random, 1), b = random_point(random, 1);
      const Vec3f c = 0.5f * (a + b) + std::ldexp(1.f, -power) * random_point(random, 1);
      const Triangle triangle{a, b, c};
      const Vec3d target = (Vec3d(a) + Vec3d(b) + Vec3d(c)) / 3.0;
      const Vec3d origin(random_point(random, 4));
      expect_exact({origin, target - origin}, triangle, hits);
      if (HasFatalFailure()) FAIL() << "aspect 2^" << power << " case " << i;
    }
  }
  EXPECT_GT(hits, 2000);
}

TEST(Triangle, IsExactOnTheLattice) {
  Random random(4);
  int hits = 0;
  const auto point = [&] {
    const auto x = random.below(5), y = random.below(5), z = random.below(5);
    return Vec3f(float(x), float(y), float(z));
  };
  for (int i = 0; i < 20'000; ++i) {
    const Triangle triangle{point(), point(), point()};
    const Ray<double> ray{Vec3d(point()), Vec3d(point()) - Vec3d(2)};
    if (!is_valid(ray)) continue;
    expect_exact(ray, triangle, hits);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(hits, 500);
}

/// Rays that start in a triangle, or as close to it as doubles do.
TEST(Triangle, IsNotHitFromWhereARayStarts) {
  Random random(9);
  int hits = 0, on_plane = 0;
  for (int i = 0; i < 4'000; ++i) {
    const float scale = std::ldexp(1.0f, static_cast<int>(random.below(40)) - 20);
    const auto lattice = [&] {
      const auto whole = [&] { return scale * 4 * (static_cast<float>(random.below(41)) - 20); };
      const float x = whole(), y = whole();
      return Vec3f(x, y, i % 5 == 0 ? 3 * scale : whole());  // some across an axis
    };
    const Triangle triangle{lattice(), lattice(), lattice()};
    const auto part = [&] { return random.uniform_double() - 0.5; };
    const double x = part(), y = part();
    // Quarters of lattice points: exact.
    Ray<double> ray{0.5 * Vec3d(triangle.a) + 0.25 * (Vec3d(triangle.b) + Vec3d(triangle.c)), {x, y, part()}};
    if (i % 2 == 0) {
      double& moved = ray.origin[static_cast<int>(random.below(3))];
      const double away = random.below(2) == 0 ? 1 : -1;
      moved += away * scale * std::ldexp(1.0, -static_cast<int>(random.below(60)));
    }
    const auto t = exact_crossing(ray, triangle);
    on_plane += t && t->t == 0;
    expect_exact(ray, triangle, hits);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(hits, 3'000);
  EXPECT_GT(on_plane, 1'000);
}

TEST(Triangle, IsHitHoweverSmall) {
  for (const float size : {1e-4f, 1e-12f, 1e-30f}) {
    const Triangle triangle{{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    int hits = 0;
    expect_exact({{size / 4, size / 4, -1}, {0, 0, 1}}, triangle, hits);
    EXPECT_EQ(hits, 1) << size;
  }
}

TEST(Triangle, WithoutAreaIsMissed) {
  const Triangle line{{-1113.45459f, -79.049614f, -56.2431908f},
                      {-1113.45459f, -87.0922699f, -56.2431908f},
                      {-1113.45459f, -79.2090149f, -56.2431908f}};
  const Ray<double> ray{{-1081.47925, 99.9999542, 87.7701111}, {-32.1072998, -183.355865, -144.607635}};
  int hits = 0;
  expect_exact(ray, line, hits);
  // Through points, lines and planes on which triangles lie.
  for (int x = 0; x <= 4; ++x) {
    const Ray<double> across{{x / 2.0, -3, 5}, {0, 3, -5}}, along{{-1, x / 2.0, 0}, {2, 0, 0}};
    expect_exact(across, {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, hits);
    expect_exact(across, {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}, hits);
    expect_exact(along, {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, hits);
    expect_exact(along, {{0, 1, 0}, {2, 1, 0}, {1, 1, 0}}, hits);
  }
  EXPECT_EQ(hits, 0);
}

/// Corners are whole numbers, and the origin is (2a + b + c) / 4: the ray begins on the triangle, or a step beside it.
TEST(Triangle, IsNotMetAgainByARayThatBeginsOnIt) {
  Random random(7);
  const auto point = [&] {
    const auto x = random.below(1 << 18), y = random.below(1 << 18), z = random.below(1 << 18);
    return 4.0f * Vec3f(float(x), float(y), float(z));
  };
  for (int i = 0; i < 5000; ++i) {
    const Triangle triangle{point(), point(), point()};
    Vec3d origin = (2.0 * Vec3d(triangle.a) + Vec3d(triangle.b) + Vec3d(triangle.c)) / 4.0;
    if (i % 2) origin.x = std::nextafter(origin.x, i % 4 == 1 ? 0 : INFINITY);
    const Ray<double> ray{origin, Vec3d(random_point(random, 1))};
    const auto expected = exact_crossing(ray, triangle);
    Crossing crossing{};
    const bool is_found = TriangleRay(ray, bounds_of(triangle)).intersect(triangle, crossing);
    ASSERT_EQ(is_found, expected.has_value()) << i;
    if (!is_found) continue;
    ASSERT_EQ(crossing.t > 0, expected->t > 0) << i;
    ASSERT_EQ(crossing.t < 0, expected->t < 0) << i;
  }
}

/// A closed octahedron, looked at from inside, is never seen through, and never without both neighbours at an edge.
TEST(Triangle, LeavesNoGapBetweenNeighbours) {
  const Vec3f tips[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<TriangleMesh::Corners> faces;
  for (const std::uint32_t x : {0u, 1u}) {
    for (const std::uint32_t y : {2u, 3u}) {
      for (const std::uint32_t z : {4u, 5u}) faces.push_back({x, y, z});
    }
  }
  const TriangleMesh mesh({tips, tips + 6}, faces);
  const auto count = [&](const Ray<double>& ray) {
    const TriangleRay prepared = mesh.prepare(ray);
    int crossings = 0;
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
      prepared.for_each_crossing(mesh[id], [&](const Crossing& crossing) { crossings += crossing.t > 0; });
    }
    return crossings;
  };
  EXPECT_EQ(count({{0, 0, 0}, {1, 0, 0}}), 4);
  EXPECT_EQ(count({{0, 0, 0}, {1, 1, 0}}), 2);
  Random random(5);
  for (int i = 0; i < 20'000; ++i) {
    const double share = random.uniform_double();
    const Vec3d edge(share, 1 - share, 0);
    const Vec3d origin = 0.1 * Vec3d(random_point(random, 1));
    ASSERT_GE(count(to_double(Ray<float>{Vec3f(origin), Vec3f(edge) - Vec3f(origin)})), 1) << i;
  }
}

TEST(Triangle, ClipsToBoxes) {
  const Triangle triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_EQ(clip(triangle, {{1, 1, -1}, {9, 9, 1}}), (Aabb{{1, 1, 0}, {3, 3, 0}}));
  EXPECT_EQ(clip(triangle, {{2, 2, 0}, {9, 9, 1}}), (Aabb{{2, 2, 0}, {2, 2, 0}}));
  EXPECT_TRUE(clip(triangle, {{2.5f, 2, -1}, {9, 9, 1}}).is_empty());
  EXPECT_TRUE(clip(triangle, {{0, 0, 1}, {9, 9, 2}}).is_empty());
  EXPECT_EQ(clip(triangle, {{-1, -1, 0}, {9, 9, 0}}), bounds_of(triangle));
}

/// Every point of the triangle that lies in the box lies in the clipped bounds.
TEST(Triangle, ClipsKeepWhatIsInside) {
  Random random(6);
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3f offset = i % 2 == 0 ? Vec3f(1e6f) : Vec3f(0);
    const Triangle triangle{random_point(random, 4) + offset, random_point(random, 4) + offset,
                            random_point(random, 4) + offset};
    Aabb box;
    box.extend(random_point(random, 4) + offset);
    box.extend(random_point(random, 4) + offset);
    const Aabb clipped = clip(triangle, box);
    for (int k = 0; k < 20; ++k) {
      const double u = random.uniform_double(), v = random.uniform_double() * (1 - u);
      const Vec3d p =
          Vec3d(triangle.a) + u * (Vec3d(triangle.b) - Vec3d(triangle.a)) + v * (Vec3d(triangle.c) - Vec3d(triangle.a));
      const auto holds = [&](const Aabb& b) {
        return glm::all(glm::lessThanEqual(Vec3d(b.lo), p)) && glm::all(glm::lessThanEqual(p, Vec3d(b.hi)));
      };
      if (!holds(box)) continue;
      ++inside;
      EXPECT_TRUE(holds(clipped)) << i;
    }
    EXPECT_TRUE(clipped.is_empty() || box.contains(clipped));
  }
  EXPECT_GT(inside, 1000);
}

TEST(Triangle, OffersItsPlaneAndEdgePlanes) {
  const Triangle triangle{{1, 0, 2}, {3, 1, 2}, {0, 5, 4}};
  const CandidatePlanes planes = planes_of(triangle);
  ASSERT_EQ(planes.size(), 4);
  for (const Vec3f& p : {triangle.a, triangle.b, triangle.c}) EXPECT_NEAR(planes[0].side(Vec3d(p)), 0, 1e-14);
  const Vec3f corners[3] = {triangle.a, triangle.b, triangle.c};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(planes[i + 1].side(Vec3d(corners[i])), 0, 1e-14);
    EXPECT_NEAR(planes[i + 1].side(Vec3d(corners[(i + 1) % 3])), 0, 1e-14);
    EXPECT_NEAR(glm::dot(planes[i + 1].normal, planes[0].normal), 0, 1e-14);
  }
  EXPECT_EQ(planes_of({{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).size(), 6);
}

}  // namespace
}  // namespace sightline
