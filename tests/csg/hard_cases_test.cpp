/// Rows of the catalogue of hard cases that concern solids, by their names there.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/csg/exact_solid.h"
#include "tests/csg/random_solid.h"

namespace sightline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

SolidTree sphere(const Vec3d& center, double radius) { return solid::Sphere{center, radius}; }
SolidTree box(const Vec3d& lo, const Vec3d& hi) { return solid::Box{lo, hi}; }
SolidTree half(const Vec3d& normal, double offset) { return solid::HalfSpace{normal, offset}; }
SolidTree framed(SolidTree tree, const Frame& frame) {
  tree.frame = frame;
  return tree;
}
/// Between two planes across x.
SolidTree slab(double lo, double hi) { return box({lo, -1, -1}, {hi, 1, 1}); }
const Ray<double> along_x{{-1, 0.25, 0.125}, {1, 0, 0}};

/// Right at every level that promises it, and no more than sane at `fast`.
void expect_truth(const SolidTree& tree, const Ray<double>& ray) {
  const Solid solid(tree);
  const oracle::ExactSpans truth = oracle::exact_spans(tree, ray);
  for (const Level level : sure_levels) {
    EXPECT_EQ(oracle::fault_of(spans_of(solid, ray, level), truth, level), "")
        << info_of(level).name << ' ' << text_of(tree) << ' ' << text_of(ray);
  }
  const Spans rough = spans_of(solid, ray, Level::fast);
  for (std::size_t i = 1; i < rough.boundaries.size(); ++i) {
    EXPECT_LT(rough.boundaries[i - 1].t, rough.boundaries[i].t);
  }
}

// ---- One solid, one ray

struct HardCase {
  const char* name;
  SolidTree tree;
  Ray<double> ray;
  std::vector<double> ends;  ///< As rounded to nearest.
  bool begins_inside = false;
};

[[maybe_unused]] void PrintTo(const HardCase& hard, std::ostream* out) { *out << hard.name; }

std::vector<HardCase> hard_cases() {
  const double root3 = std::sqrt(3.0), rim = std::sqrt(0.75);
  const auto near = static_cast<double>(4 - std::sqrt(0.75L)), far = static_cast<double>(4 + std::sqrt(0.75L));
  const SolidTree unit = sphere({0, 0, 0}, 1), cylinder = solid::Cylinder{},
                  tall = solid::Cone{{0, 0, 0}, {0, 0, -2}, 2};
  const SolidTree holed = box(Vec3d(-1.1), Vec3d(1.1)) - box({-0.5, -0.5, -1.1}, {0.5, 0.5, 1.1});
  solid::Quadric threshold{{1e-11, 0, 0, 0, 0, 0, 1, 0, 0, -1}}, crease{{1, -1, 0, 0, 0, 0, 0, 0, 0, 0}};
  SolidTree deep = slab(0, 0.1);
  for (int i = 1; i < 40; ++i) deep = std::move(deep) | slab(0.1 * i, 0.1 * (i + 1));
  return {
      {"sph_tangent", unit, {{0, 1, -3}, {0, 0, 1}}, {}},
      {"sph_tangent_complement", ~unit, {{0, 1, -3}, {0, 0, 1}}, {}, true},
      {"sph_near_root", unit, {{0, 0, 1 + 0x1p-22}, {0, 0, 1}}, {-2 - 0x1p-22, -0x1p-22}},
      {"sph_dir_underflow", unit, {{0, 0.5, -4}, {0, 0, 0x1p-80}}, {near * 0x1p80, far * 0x1p80}},
      {"sph_abs_eps", sphere({0, 0, 0}, 9e-6), {{0, 0, -1}, {0, 0, 1}}, {1 - 9e-6, 1 + 9e-6}},
      {"sph_zero_radius", sphere({1, 2, 3}, 0), {{1, 2, 0}, {0, 0, 1}}, {}},
      {"sph_far", unit, {{0, 0.5, 0}, {0, 0, 0x1p-40}}, {-rim * 0x1p40, rim * 0x1p40}},
      {"pln_in_plane", half({0, 0, 1}, 2), {{0, 0, 2}, {1, 1, 0}}, {}, true},
      {"pln_in_plane_slanted", half({1, 1, 0}, 2), {{1, 1, 0}, {1, -1, 3}}, {}, true},
      {"pln_graze_abs_eps", half({0, 1, 0}, -1), {{0, 0, 0}, {1, -1e-11, 0}}, {1 / 1e-11}},
      {"box_denormal_dir", box(Vec3d(-0.5), Vec3d(0.5)), {{1, 0, 0}, {0x1p-140, 0, 0}}, {-0x1.8p140, -0x1p139}},
      {"box_denormal_dir_aside", box(Vec3d(-0.5), Vec3d(0.5)), {{1, 0, 0}, {0x1p-140, 1, 0}}, {}},
      {"box_flat", box({0, 0, 1}, {1, 1, 1}), {{0.5, 0.5, -1}, {0, 0, 1}}, {}},
      {"box_corner_touch", box(Vec3d(0), Vec3d(1)), {{1, 2, 0}, {-1, -1, 1}}, {}},
      {"box_edge_touch", box(Vec3d(0), Vec3d(1)), {{2, 0, 0.5}, {-1, 1, 0}}, {}},
      {"box_origin_on_face_out", box(Vec3d(-1), Vec3d(1)), {{1, 0, 0}, {1, 0, 0}}, {-2, 0}},
      {"box_origin_on_face_in", box(Vec3d(-1), Vec3d(1)), {{1, 0, 0}, {-1, 0, 0}}, {0, 2}},
      {"box_far_sentinel", box({1e30, -1, -1}, {2e30, 1, 1}), {{0, 0, 0}, {1, 0, 0}}, {1e30, 2e30}},
      {"cyl_parallel", cylinder, {{0.25, 0.25, -5}, {0, 0, 1}}, {4, 6}},
      {"cyl_parallel_outside", cylinder, {{0.75, 0.75, -5}, {0, 0, 1}}, {}},
      {"cyl_parallel_in_side", cylinder, {{0, 1, -5}, {0, 0, 1}}, {4, 6}},
      {"cyl_cap_plane", cylinder, {{-3, 0, 1}, {1, 0, 0}}, {2, 4}},
      {"cone_generator", tall, {{3, 0, 0}, {1, 0, 1}}, {-2, -1.5}},
      {"cone_on_generator", tall, {{0, 0, 0}, {1, 0, -1}}, {0, 2}},
      {"cone_nappe", tall, {{-3, 0, 1}, {1, 0, 0}}, {}},
      {"cone_apex_across", tall, {{-3, 0, 0}, {1, 0, 0}}, {}},
      {"cone_apex_within", tall, {{0.5, 0, 1}, {-0.5, 0, -1}}, {1, 3}},
      {"quadric_threshold", threshold, {{0, 0, 0}, {1, 0, 0}}, {-100000000001 + 1e-11, 1 - 1e-11}},
      {"quadric_crease", crease, {{0, -2, 0}, {0, 1, 0}}, {}, true},
      {"quadric_crease_outside", crease, {{-2, 0, 0}, {1, 0, 0}}, {}},
      {"csg_self", slab(0, 1) - slab(0, 1), along_x, {}},
      {"csg_self_xor", unit ^ unit, along_x, {}},
      {"csg_pov_hole", holed, {{0.1, 0.2, -7}, {0.01, 0.02, 1}}, {}},
      {"csg_pov_wall", holed, {{0.75, 0.2, -2.1}, {0, 0, 1}}, {2.1 - 1.1, 2.1 + 1.1}},
      {"csg_ulp_seam",
       half({1, 0, 0}, 0.3) | half({-1, 0, 0}, -(0.1 + 0.2)),
       {{0, 0, 0}, {1, 0, 0}},
       {0.3, 0.1 + 0.2},
       true},
      {"csg_zero_length", slab(0, 2) - slab(1, 1), along_x, {1, 3}},
      {"csg_zero_length_in_face", slab(0, 2) - slab(1, 1), {{1, -3, 0}, {0, 1, 0}}, {}},
      {"csg_inscribed", box(Vec3d(-1), Vec3d(1)) - unit, {{-3, 0, 0}, {1, 0, 0}}, {}},
      {"csg_tangent", unit - sphere({2, 0, 0}, 1), {{-3, 0, 0}, {1, 0, 0}}, {2, 4}},
      {"csg_tangent_union", unit | sphere({2, 0, 0}, 1), {{-3, 0, 0}, {1, 0, 0}}, {2, 6}},
      {"csg_tangent_aside", unit | sphere({0, 2, 0}, 1), {{-3, 1, 0}, {1, 0, 0}}, {}},
      {"csg_infinite", half({1, 2, 3}, 0.1) | ~half({1, 2, 3}, 0.1), along_x, {}, true},
      {"csg_infinite_empty", half({1, 2, 3}, 0.1) & ~half({1, 2, 3}, 0.1), along_x, {}},
      {"csg_edge_share", slab(0, 1) | box({1, -1, -1}, {2, 1, 1}), along_x, {1, 3}},
      {"csg_edge_share_none", slab(0, 1) & slab(1, 2), along_x, {}},
      {"csg_edge_only", box(Vec3d(-1), Vec3d(0)) | box(Vec3d(0), Vec3d(1)), {{-2, -2, -2}, {1, 1, 1}}, {1, 3}},
      {"csg_deep", deep, along_x, {1, 5}},
      {"csg_pythagoras", sphere({0, 0, 0}, 5) & half({0, 1, 0}, -4), {{3, -10, 0}, {0, 1, 0}}, {}},
      {"csg_pythagoras_less", sphere({0, 0, 0}, 5) - half({0, 1, 0}, -4), {{3, -10, 0}, {0, 1, 0}}, {6, 14}},
      {"sph_chord", unit, {{0, 0.5, 0}, {0, 0, 0.5}}, {-root3, root3}},
  };
}

class HardCases : public testing::TestWithParam<HardCase> {};

TEST_P(HardCases, IsRight) {
  const HardCase& hard = GetParam();
  expect_truth(hard.tree, hard.ray);
  const Spans spans = spans_of(Solid(hard.tree), hard.ray, Level::exact);
  std::vector<double> ends;
  for (const Boundary& boundary : spans.boundaries) ends.push_back(boundary.t);
  EXPECT_EQ(spans.begins_inside, hard.begins_inside);
  EXPECT_EQ(ends, hard.ends);
}
INSTANTIATE_TEST_SUITE_P(Catalogue, HardCases, testing::ValuesIn(hard_cases()),
                         [](const auto& hard) { return std::string(hard.param.name); });

// ---- Families

TEST(HardSpheres, KeepTheirChordFarAway) {  // sph-far
  for (int k = 0; k <= 100; ++k) {
    expect_truth(solid::Sphere{}, {{0, 0.5, -std::ldexp(1.0, k)}, {0, 0, 1}});
    expect_truth(solid::Sphere{}, {{0, 0.5, -std::ldexp(1.0, k)}, {0, 0, std::ldexp(1.0, -k)}});
  }
}

TEST(HardSpheres, AreGrazedOrMissed) {  // sph-graze, sph-interval-reject
  for (int k = 1; k <= 52; ++k) {
    for (const int side : {-1, 0, 1}) {
      const double impact = 1 + side * std::ldexp(1.0, -k);
      const Ray<double> ray{{impact, 0, -16}, {0, 0, 1}};
      expect_truth(solid::Sphere{}, ray);
      for (const Level level : sure_levels) {
        EXPECT_EQ(spans_of(Solid(solid::Sphere{}), ray, level).boundaries.size(), side < 0 ? 2u : 0u) << k;
      }
    }
  }
}

TEST(HardSpheres, ShowTheHorizonOfAPlanet) {  // sph-planet
  const SolidTree planet = sphere({0, 0, 0}, 0x1p20);
  const Ray<double> ray{{0, 0x1p20 + 1, 0}, {1, -1.0 / 16, 0}};
  expect_truth(planet, ray);
  for (const Level level : sure_levels) {
    const auto first = first_of(Solid(planet), ray, 0, infinity, level);
    ASSERT_TRUE(first);
    EXPECT_NEAR(first->t, 16.001953602, 0.5e-9);
  }
}

TEST(HardSpheres, AreNotHitAgainFromWhereTheyAre) {  // sph-on-surface, csg-camera-inside
  const Solid ball(solid::Sphere{}), cut(solid::Sphere{} & half({1, 0, 0}, 0.25));
  for (const Level level : sure_levels) {
    EXPECT_EQ(first_of(ball, {{0, 0, 1}, {0, 0, -1}}, 0, infinity, level)->t, 2);
    EXPECT_FALSE(first_of(ball, {{0, 0, 1}, {0, 0, 1}}, 0, infinity, level));
    EXPECT_EQ(first_of(cut, {{0, 0, 0}, {1, 0, 0}}, 0, infinity, level)->t, 0.25);
    EXPECT_FALSE(first_of(cut, {{0.25, 0, 0}, {1, 0, 0}}, 0, infinity, level));
    EXPECT_EQ(first_of(cut, {{0.25, 0, 0}, {-1, 0, 0}}, 0, infinity, level)->t, 1.25);
  }
}

/// Where an origin as rounded is so close to the surface that some hundred bits say little of t.
TEST(HardSpheres, AreAsAccurateNextToTheirSurface) {
  const SolidTree turned = framed(solid::Sphere{}, {{{{0.6, 0.8, 0, 0}, {-0.8, 0.6, 0, 0}, {0, 0, 1, 0}}}});
  for (int i = 0; i < 200; ++i) {
    expect_truth(turned, {{std::cos(0.03 * i), std::sin(0.03 * i), 0}, {1, 0.25, 0}});
  }
}

TEST(HardSpheres, ScaleWithTheScene) {  // sph-scale
  for (const int exponent : {64, -80, 200, -200}) {
    const double s = std::ldexp(1.0, exponent);
    const SolidTree tree = sphere(Vec3d(s, 0, 0), 3 * s) - box(Vec3d(-s), Vec3d(s));
    const SolidTree same = sphere({1, 0, 0}, 3) - box(Vec3d(-1), Vec3d(1));
    const Ray<double> ray{{-9 * s, s / 4, s / 8}, {s, 0, 0}}, same_ray{{-9, 0.25, 0.125}, {1, 0, 0}};
    expect_truth(tree, ray);
    const Spans scaled = spans_of(Solid(tree), ray, Level::exact),
                plain = spans_of(Solid(same), same_ray, Level::exact);
    ASSERT_EQ(scaled.boundaries.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(scaled.boundaries[i].t, plain.boundaries[i].t);
  }
}

TEST(HardBoxes, HaveTheirFacesAndEdges) {  // box-face-plane, box-fma-residual
  const SolidTree tree = box({-1, -1, -1}, {1, 1, 1});
  for (int axis = 0; axis < 3; ++axis) {
    for (const double a : {-1.0, 0.0, -0.0, 1.0}) {
      for (const double b : {-1.0, 0.5, 1.0}) {
        for (const double d : {1.0, -1.0, 1e-30, -1e30}) {
          for (const double zero : {0.0, -0.0}) {
            Ray<double> ray{Vec3d(0), Vec3d(zero)};
            ray.direction[axis] = d;
            ray.origin[axis] = -3 * d, ray.origin[(axis + 1) % 3] = a, ray.origin[(axis + 2) % 3] = b;
            expect_truth(tree, ray);
            for (const Level level : sure_levels)
              EXPECT_EQ(spans_of(Solid(tree), ray, level).boundaries.size(), 2u) << text_of(ray);
          }
        }
      }
    }
  }
}

TEST(HardBoxes, TakeShortDirections) {  // box-safe-rcp
  const SolidTree tree = box({0.75, 1.75, 3.5}, {1.125, 2.25, 5});
  const Ray<double> ray{{0, 0, 0}, {1e-8, 2e-8, 4e-8}};
  expect_truth(tree, ray);
  const Spans spans = spans_of(Solid(tree), ray, Level::exact);
  ASSERT_EQ(spans.boundaries.size(), 2u);
  EXPECT_NEAR(spans.boundaries[0].t, 8.75e7, 0x1p-20);
  EXPECT_NEAR(spans.boundaries[1].t, 1.125e8, 0x1p-20);
}

TEST(HardBoxes, HaveASharpSilhouette) {  // box-silhouette
  Random random(5);
  const SolidTree tree = box({0.1, 0.2, 0.3}, {0.7, 0.9, 1.1});
  for (int i = 0; i < 1000; ++i) {
    const Vec3d eye(4 * random.uniform_double() + 2, 4 * random.uniform_double() + 2, 4 * random.uniform_double() - 2);
    const Vec3d on_edge(0.7, 0.2, 0.3 + 0.8 * random.uniform_double());
    Ray<double> ray{eye, on_edge - eye};
    for (const double to : {ray.direction.x, -infinity, infinity}) {
      ray.direction.x = std::nextafter(ray.direction.x, to);
      expect_truth(tree, ray);
    }
  }
}

TEST(HardCylinders, AreClosedAtTheirRims) {  // cyl-rim
  Random random(6);
  const SolidTree tree = solid::Cylinder{{0.1, 0.2, 0.3}, {0.6, 0.7, 1.8}, 0.7};
  for (int i = 0; i < 300; ++i) {
    const double angle = 6.28 * random.uniform_double();
    const Vec3d across(3, 0, -1), other(-0.5, 5, -1.5);  // both perpendicular to the axis, and to each other
    const Vec3d rim = Vec3d(0.6, 0.7, 1.8) +
                      0.7 * (std::cos(angle) * glm::normalize(across) + std::sin(angle) * glm::normalize(other));
    const Vec3d eye(random.uniform_double() - 3, random.uniform_double(), 4 * random.uniform_double());
    expect_truth(tree, {eye, rim - eye});
  }
}

TEST(HardCylinders, HaveFiniteBounds) {  // cyl-aabb
  const double above_one = std::nextafter(1.0, 2.0);
  const Solid solid(solid::Cylinder{{0, 0, 0}, {above_one, 0, 0}, 2});
  ASSERT_TRUE(solid.is_bounded());
  EXPECT_LE(solid.bounds().lo.y, -2);
  EXPECT_GE(solid.bounds().lo.x, -0x1p-20);
  EXPECT_LE(solid.bounds().hi.x, 1 + 0x1p-20);
}

TEST(HardCones, AreMetAtTheirApex) {  // cone-apex
  Random random(7);
  const Dice dice = dice_of(random);
  const auto whole = [&] { return Vec3d(dice(33) - 16, dice(33) - 16, dice(33) - 16); };
  for (int i = 0; i < 500; ++i) {
    const Vec3d apex = 0.125 * whole(), direction = whole();
    Vec3d axis = whole();
    if (axis == Vec3d(0)) axis.x = 1;
    if (direction == Vec3d(0)) continue;
    const SolidTree cone = solid::Cone{apex, apex + axis, 0.5 * (1 + dice(20))};
    expect_truth(cone, {apex - 0.5 * (dice(9) - 4) * direction, direction});
  }
}

/// A slab less the same one as half-spaces of other lengths.
TEST(HardSolids, AreTheSameInTwoWays) {  // csg-two-ways
  Random random(8);
  for (int i = 0; i < 500; ++i) {
    const double lo = std::ldexp(random.below(64), -6), hi = lo + std::ldexp(1 + random.below(64), -6);
    const double k = 1 + random.below(1000), inexact = 0.1 * k;
    const Ray<double> ray{{-1, 0.1 * random.below(9), 0.3}, {1, 0.1 * random.below(3), 0.7 * random.below(2)}};
    const auto walls = [&](double scale) {
      return half({scale, 0, 0}, scale * hi) & half({-scale, 0, 0}, -scale * lo);
    };
    const SolidTree slab_x = box({lo, -100, -100}, {hi, 100, 100});
    expect_truth(slab_x - walls(inexact), ray);
    for (const Level level : sure_levels) {
      EXPECT_TRUE(spans_of(Solid(slab_x - walls(k)), ray, level).boundaries.empty());
      EXPECT_EQ(
          spans_of(Solid(slab_x | (half({k, 0, 0}, k * hi) - half({k, 0, 0}, k * lo))), ray, level).boundaries.size(),
          2u);
    }
  }
}

TEST(HardSolids, HaveGapsOfAnyWidth) {  // csg-gap
  const Ray<double> ray{{-4, 0, 0}, {1, 0, 0}};
  for (int k = 1; k <= 52; ++k) {
    const double gap = std::ldexp(1.0, -k);
    const SolidTree shell = sphere({0, 0, 0}, 1 + gap) - sphere({0, 0, 0}, 1), blocks = slab(-1, 1) | slab(1 + gap, 2);
    expect_truth(shell, ray);
    expect_truth(blocks, ray);
    for (const Level level : sure_levels) {
      EXPECT_EQ(spans_of(Solid(shell), ray, level).boundaries.size(), 4u) << k;
      EXPECT_EQ(spans_of(Solid(blocks), ray, level).boundaries.size(), 4u) << k;
    }
  }
}

TEST(HardSolids, AreTheSameInAnyFrame) {  // csg-frames
  Random random(9);
  const Dice dice = dice_of(random);
  for (int i = 0; i < 500; ++i) {
    const double scale = std::array{2.0, 0.5, 3.0, -1.0, -5.0}[static_cast<std::size_t>(dice(5))];
    const Vec3d move(dice(9) - 4, dice(9) - 4, dice(9) - 4), center(dice(9) - 4, dice(9) - 4, dice(9) - 4);
    const double radius = 1 + dice(8);
    const Frame frame{{{{scale, 0, 0, move.x}, {0, scale, 0, move.y}, {0, 0, scale, move.z}}}};
    const Vec3d there = scale * center + move, a = scale * (center - radius) + move,
                b = scale * (center + radius) + move;
    const SolidTree ball = sphere(center, radius), same_ball = framed(sphere(there, radius * std::fabs(scale)), frame);
    const SolidTree cube = box(center - radius, center + radius), same_cube = framed(box(min(a, b), max(a, b)), frame);
    Ray<double> ray{center + Vec3d(0.3, 0.7, 0.1), Vec3d(0)};
    for (int axis = 0; axis < 3; ++axis) ray.direction[axis] = random.uniform_double() - 0.5;
    for (const SolidTree& nothing : {ball - same_ball, ball ^ same_ball, cube - same_cube, same_cube - cube}) {
      expect_truth(nothing, ray);
      for (const Level level : sure_levels) EXPECT_TRUE(spans_of(Solid(nothing), ray, level).boundaries.empty());
    }
  }
}

}  // namespace
}  // namespace sightline
