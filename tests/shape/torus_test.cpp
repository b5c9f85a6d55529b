#include "sightline/shape/torus.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/math/sturm.h"

namespace sightline {
namespace {

using oracle::Rational;
using Polynomial = std::vector<Rational>;

Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  }
  return product;
}
Polynomial plus(Polynomial a, const Polynomial& b, const Rational& factor = 1) {
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += factor * b[i];
  return a;
}

/// (a.a) (q.q + R^2 - r^2)^2 - 4 R^2 ((a.a) q.q - (q.a)^2) for q = o + t d - c.
Polynomial rational_polynomial(const Torus& torus, const Ray<double>& ray) {
  Polynomial qq(3), qa(2);
  Rational aa = 0;
  for (int i = 0; i < 3; ++i) {
    const Rational a(torus.axis[i]);
    const Polynomial q = {Rational(ray.origin[i]) - Rational(torus.center[i]), Rational(ray.direction[i])};
    qq = plus(qq, times(q, q));
    qa = plus(qa, q, a);
    aa += a * a;
  }
  const Rational R(torus.major), r(torus.minor);
  const Polynomial g = plus(qq, {R * R - r * r});
  Polynomial f = times({aa}, times(g, g));
  f = plus(f, qq, -4 * R * R * aa);
  return plus(f, times(qa, qa), 4 * R * R);
}

std::vector<oracle::FoundRoot> found(const RootList& list) {
  std::vector<oracle::FoundRoot> roots;
  for (int i = 0; i < list.count; ++i) {
    const Root& root = list.roots[static_cast<std::size_t>(i)];
    roots.push_back({root.t, root.multiplicity});
  }
  return roots;
}

/// Exact lists are all of it; precise ones agree where they are certain, and say so most of the time.
void expect_exact(const Torus& torus, const Ray<double>& ray, bool* is_precise = nullptr) {
  const Polynomial f = rational_polynomial(torus, ray);
  const RootList exact = torus_roots(torus, ray, Level::exact), precise = torus_roots(torus, ray, Level::precise);
  ASSERT_TRUE(exact.is_certain);
  ASSERT_TRUE(oracle::are_all_roots(f, found(exact)));
  ASSERT_FALSE(exact.begins_negative);
  ASSERT_FALSE(precise.begins_negative);
  if (is_precise) *is_precise = precise.is_certain;
  if (precise.is_certain) {
    ASSERT_EQ(precise.count, exact.count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(exact.count); ++i) {
      ASSERT_EQ(exact.roots[i].multiplicity, precise.roots[i].multiplicity);
      ASSERT_LE(std::fabs(exact.roots[i].t - precise.roots[i].t), precise.roots[i].radius + exact.roots[i].radius);
    }
  }
}

struct Row {
  const char* name;
  Torus torus;
  Ray<double> ray;
  std::vector<oracle::FoundRoot> roots;
};

const Vec3d z{0, 0, 1};

TEST(Torus, SolvesTheCatalogue) {
  const double chord = 2.8284271247461903;
  const std::vector<Row> rows = {
      {"tor-quadruple", {Vec3d(0), z, 2, 1}, {{-10, 2, 1}, {1, 0, 0}}, {{10, 4}}},
      {"tor-crest", {Vec3d(0), z, 2, 1}, {{-10, 0, 1}, {1, 0, 0}}, {{8, 2}, {12, 2}}},
      {"tor-equator", {Vec3d(0), z, 2, 1}, {{3, -10, 0}, {0, 1, 0}}, {{10, 2}}},
      {"tor-inner", {Vec3d(0), z, 2, 1}, {{1, -10, 0}, {0, 1, 0}}, {{10 - chord, 1}, {10, 2}, {10 + chord, 1}}},
      {"tor-villarceau", {Vec3d(0), z, 5, 3}, {{-16, 0, -12}, {4, 0, 3}}, {{3.2, 2}, {4.8, 2}}},
      {"tor-far", {Vec3d(0), z, 2, 1}, {{-0x1p14, 0.5, 0.25}, {1, 0, 0}}, {{}, {}, {}, {}}},
      {"tor-very-far", {Vec3d(0), z, 2, 1}, {{-0x1p30, 0.5, 0.25}, {1, 0, 0}}, {{}, {}, {}, {}}},
      {"tor-thin", {Vec3d(0), z, 1, 0x1p-20}, {{-3, 0, 0}, {1, 0, 0}}, {{}, {}, {}, {}}},
      {"tor-thin-tilted", {Vec3d(0), z, 1, 0x1p-20}, {{1, 0, -3}, {0, 0, 1}}, {{}, {}}},
      {"tor-horn", {Vec3d(0), z, 1, 1}, {{-3, 0, 0}, {1, 0, 0}}, {{1, 1}, {3, 2}, {5, 1}}},
      {"tor-horn-axis", {Vec3d(0), z, 1, 1}, {{0, 0, -3}, {0, 0, 1}}, {{3, 4}}},
      {"tor-spindle", {Vec3d(0), z, 1, 2}, {{-4, 0, 0}, {1, 0, 0}}, {{1, 1}, {3, 1}, {5, 1}, {7, 1}}},
      {"tor-spindle-axis", {Vec3d(0), z, 3, 5}, {{0, 0, -6}, {0, 0, 1}}, {{2, 2}, {10, 2}}},
      {"tor-ring-axis", {Vec3d(0), z, 5, 3}, {{0, 0, -6}, {0, 0, 1}}, {}},
      {"tor-sphere-twice", {Vec3d(0), z, 0, 1}, {{-3, 0, 0}, {1, 0, 0}}, {{2, 2}, {4, 2}}},
      {"tor-circle", {Vec3d(0), z, 1, 0}, {{-3, 0, 0}, {1, 0, 0}}, {{2, 2}, {4, 2}}},
      {"tor-circle-missed", {Vec3d(0), z, 1, 0}, {{-3, 0, 1}, {1, 0, 0}}, {}},
      {"tor-point", {Vec3d(0), z, 0, 0}, {{-3, 0, 0}, {1, 0, 0}}, {{3, 4}}},
      {"tor-root-elim", {Vec3d(0), z, 2, 1}, {{3 - 0x1p-40, 0, 0}, {1, 0, 0}}, {{}, {}, {}, {0x1p-40, 1}}},
  };
  for (const auto& [name, torus, ray, roots] : rows) {
    SCOPED_TRACE(name);
    expect_exact(torus, ray);
    // The same, moved, stretched and with another axis length: roots are where they were, divided by the stretch.
    expect_exact({Vec3d(7, -3, 0.125), Vec3d(0, 0, -0x1p-9), torus.major, torus.minor},
                 {ray.origin + Vec3d(7, -3, 0.125), 0x1p5 * ray.direction});
    for (const int scale : {-400, -90, 70, 300}) {
      const double by = std::ldexp(1.0, scale);
      expect_exact({Vec3d(0), z, torus.major * by, torus.minor * by}, {ray.origin * by, ray.direction});
    }
    const RootList list = torus_roots(torus, ray, Level::exact), precise = torus_roots(torus, ray, Level::precise);
    ASSERT_EQ(list.count, static_cast<int>(roots.size()));
    ASSERT_EQ(precise.count, list.count);
    for (std::size_t i = 0; i < roots.size(); ++i) {
      if (roots[i].multiplicity == 0) continue;
      EXPECT_NEAR(list.roots[i].t, roots[i].nearest, 0x1p-50 * roots[i].nearest);
      EXPECT_EQ(list.roots[i].multiplicity, roots[i].multiplicity);
      EXPECT_EQ(precise.roots[i].multiplicity, roots[i].multiplicity);
      EXPECT_LE(std::fabs(precise.roots[i].t - list.roots[i].t), precise.roots[i].radius);
    }
  }
}

TEST(Torus, IsNotShakenByDistance) {
  const Torus torus{Vec3d(0), z, 2, 1};
  for (const int k : {14, 30}) {
    const Ray<double> ray{{-std::ldexp(1.0, k), 0.5, 0.25}, {1, 0, 0}};
    const RootList exact = torus_roots(torus, ray, Level::exact);
    for (const Level level : {Level::watertight, Level::precise}) {
      const RootList list = torus_roots(torus, ray, level);
      ASSERT_EQ(list.count, 4);
      for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(list.roots[i].t, exact.roots[i].t, std::ldexp(4, k - 53) + 0x1p-48);
    }
  }
  const RootList far = torus_roots(torus, {{-0x1p14, 0, 0}, {1, 0, 0.00006103515625}}, Level::watertight);
  EXPECT_EQ(far.count, 2 * (far.count / 2));
}

class Generated {
 public:
  int pick(int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(random_); }
  double real() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  Vec3d vector() { return {real(), real(), real()}; }

 private:
  std::mt19937 random_{3};
};

TEST(Torus, CountsAnyRaysRoots) {
  Generated random;
  int precise = 0;
  constexpr int rounds = 3000;
  for (int round = 0; round < rounds; ++round) {
    const double size = std::ldexp(1.0, random.pick(-8, 8));
    const Torus torus{random.vector(), random.vector(), size, size * std::ldexp(1.0, -random.pick(-1, 12))};
    const Vec3d target = torus.center + 2.0 * size * random.vector();
    const Vec3d origin = torus.center + std::ldexp(size, random.pick(0, 20)) * random.vector();
    bool is_precise = false;
    expect_exact(torus, {origin, (target - origin) * std::ldexp(1.0, random.pick(-20, 20))}, &is_precise);
    if (HasFatalFailure()) FAIL() << "round " << round;
    precise += is_precise;
  }
  EXPECT_EQ(precise, rounds);
}

/// Lines that touch from the integer lattice, where the polynomial is exact, moved by 2^-k.
TEST(Torus, CountsNearTangentRoots) {
  Generated random;
  const std::array<Row, 5> rows{{
      {"crest", {Vec3d(0), z, 2, 1}, {{-10, 0, 1}, {1, 0, 0}}, {}},
      {"quadruple", {Vec3d(0), z, 2, 1}, {{-10, 2, 1}, {1, 0, 0}}, {}},
      {"equator", {Vec3d(0), z, 2, 1}, {{3, -10, 0}, {0, 1, 0}}, {}},
      {"inner", {Vec3d(0), z, 2, 1}, {{1, -10, 0}, {0, 1, 0}}, {}},
      {"villarceau", {Vec3d(0), z, 5, 3}, {{-16, 0, -12}, {4, 0, 3}}, {}},
  }};
  int precise = 0, uncertain = 0;
  for (int round = 0; round < 4000; ++round) {
    const Row& row = rows[static_cast<std::size_t>(random.pick(0, 4))];
    Torus torus = row.torus;
    Ray<double> ray = row.ray;
    const double gap = random.pick(-1, 1) * std::ldexp(1.0, -random.pick(4, 60));
    switch (random.pick(0, 3)) {
      case 0:
        ray.origin[random.pick(0, 2)] += gap;
        break;
      case 1:
        ray.direction[random.pick(0, 2)] += gap;
        break;
      case 2:
        torus.minor += gap;
        break;
      default:
        torus.axis[random.pick(0, 1)] += gap;
        break;
    }
    ray.origin += std::ldexp(1.0, random.pick(0, 10)) * ray.direction;
    bool is_precise = false;
    expect_exact(torus, ray, &is_precise);
    if (HasFatalFailure()) FAIL() << row.name << " round " << round << " gap " << gap;
    ++(is_precise ? precise : uncertain);
  }
  EXPECT_GT(precise, 1500);
  EXPECT_GT(uncertain, 500);
}

TEST(Torus, KnowsAllScales) {
  Generated random;
  for (int round = 0; round < 300; ++round) {
    const Torus torus{random.vector(), random.vector(), 1, 0.4};
    const Ray<double> ray{torus.center + 3.0 * random.vector(), random.vector()};
    const double by = std::ldexp(1.0, random.pick(-900, 900)), speed = std::ldexp(1.0, random.pick(-90, 90));
    const Torus scaled{by * torus.center, std::ldexp(1.0, random.pick(-900, 900)) * torus.axis, by * 1, by * 0.4};
    const Ray<double> scaled_ray{by * ray.origin, by * speed * ray.direction};
    for (const Level level : {Level::fast, Level::watertight, Level::precise, Level::exact}) {
      const RootList one = torus_roots(torus, ray, level), other = torus_roots(scaled, scaled_ray, level);
      ASSERT_EQ(one.count, other.count) << round << " at level " << info_of(level).name << ", scale " << by;
      for (std::size_t i = 0; i < static_cast<std::size_t>(one.count); ++i) {
        const double unit = level == Level::fast ? 0x1p-10 : 0x1p-40;
        ASSERT_NEAR(one.roots[i].t, other.roots[i].t * speed, unit * (1 + std::fabs(one.roots[i].t)));
      }
    }
  }
}

TEST(Torus, IsNotMetByRaysThatAreNone) {
  const Torus torus{Vec3d(0), z, 2, 1};
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const Level level : {Level::fast, Level::watertight, Level::precise, Level::exact}) {
    EXPECT_EQ(torus_roots(torus, {{2, 0, 0}, {0, 0, 0}}, level).count, 0);
    EXPECT_EQ(torus_roots(torus, {{nan, 0, 0}, {0, 0, 1}}, level).count, 0);
    EXPECT_EQ(torus_roots(torus, {{2, 0, 0}, {0, infinity, 1}}, level).count, 0);
    EXPECT_EQ(torus_roots(torus, {{-0x1p200, 2, 0}, {1, 0, 0}}, level).count, 2);  // rounded to the same double
  }
}

TEST(Torus, BoundsAreTightAndOutward) {
  Generated random;
  for (int round = 0; round < 300; ++round) {
    const Torus torus{random.vector(), random.vector(), 1 + random.real(), 1 + random.real()};
    const Aabb box = bounds_of(torus);
    for (int axis = 0; axis < 3; ++axis) {
      const auto n = [&](int i) { return Rational(torus.axis[(axis + i) % 3]) * Rational(torus.axis[(axis + i) % 3]); };
      const Rational across = Rational(torus.major) * Rational(torus.major) * (n(1) + n(2)) / (n(0) + n(1) + n(2));
      // (face - center - minor)^2 against the square of the circle's extent
      for (const int side : {-1, 1}) {
        const Rational face = side < 0 ? Rational(box.lo[axis]) : Rational(box.hi[axis]);
        const Rational reach = side * (face - Rational(torus.center[axis])) - Rational(torus.minor);
        const Rational inner = reach - Rational(0x1p-21);
        EXPECT_TRUE(reach >= 0 && reach * reach >= across);
        EXPECT_TRUE(inner < 0 || inner * inner < across);
      }
    }
  }
}

TEST(Torus, HasNormalsEverywhere) {
  const Torus torus{{1, 2, 3}, {0, 0, 4}, 2, 1};
  EXPECT_EQ(normal_at(torus, {4, 2, 3}), Vec3d(1, 0, 0));
  EXPECT_EQ(normal_at(torus, {2, 2, 3}), Vec3d(-1, 0, 0));
  EXPECT_EQ(normal_at(torus, {1, 4, 2}), Vec3d(0, 0, -1));
  const Torus spindle{Vec3d(0), z, 3, 5};
  EXPECT_EQ(normal_at(spindle, {2, 0, 0}), Vec3d(-1, 0, 0));  // of the lemon, which is hollow
  EXPECT_NEAR(glm::distance(normal_at(spindle, {1, 0, 3}), Vec3d(-0.8, 0, -0.6)), 0, 0x1p-50);
  EXPECT_EQ(normal_at(spindle, {0, 0, 4}), z);
  EXPECT_EQ(normal_at(spindle, {0, 0, -4}), -z);
  Generated random;
  for (int round = 0; round < 2000; ++round) {
    const Torus any{random.vector(), random.vector(), 1, std::ldexp(1.0, -random.pick(0, 60))};
    const Ray<double> ray{any.center + 3.0 * random.vector(), random.vector()};
    const RootList list = torus_roots(any, ray, Level::watertight);
    for (int i = 0; i < list.count; ++i) {
      const Vec3d normal = normal_at(any, ray.at(list.roots[static_cast<std::size_t>(i)].t));
      ASSERT_NEAR(glm::length(normal), 1, 0x1p-40);
      if (any.minor > 0x1p-10) {
        // From outside in, from inside out.
        ASSERT_EQ(glm::dot(normal, ray.direction) < 0, i % 2 == 0) << round;
      }
    }
  }
}

TEST(Torus, FastRootsAreNear) {
  Generated random;
  int same = 0;
  for (int round = 0; round < 1000; ++round) {
    const Torus torus{random.vector(), random.vector(), 1, 0.4};
    const Ray<double> ray{torus.center + 3.0 * random.vector(), 0x1p-100 * random.vector()};
    const RootList fast = torus_roots(torus, ray, Level::fast), exact = torus_roots(torus, ray, Level::exact);
    if (fast.count != exact.count) continue;
    ++same;
    for (std::size_t i = 0; i < static_cast<std::size_t>(exact.count); ++i) {
      EXPECT_NEAR(fast.roots[i].t, exact.roots[i].t, 0x1p-6 * std::fabs(exact.roots[i].t) + 0x1p+90);
    }
  }
  EXPECT_GT(same, 990);
}

}  // namespace
}  // namespace sightline
