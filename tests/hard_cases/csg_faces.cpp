/// Solids whose faces lie in one plane.

#include <cmath>

#include "sightline/math/random.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/csg_naive.h"
#include "tests/hard_cases/csg_parts.h"
#include "tests/hard_cases/random_vectors.h"

namespace sightline::hard {
namespace {

// ---- csg-two-ways

/// Upward along x, of numbers that are floats.
Ray<double> crossing_ray(Random& random) {
  const Vec3d origin = random_in_cube(random), direction = random_in_cube(random);
  return ray_of_floats(origin - Vec3d(3, 0, 0), {1.5 + direction.x, direction.y, direction.z});
}

NaiveSpans naive_walls(double k, double lo, double hi, const Ray<double>& ray) {
  return naive_intersection(naive_half<float>({k, 0, 0}, k * hi, ray), naive_half<float>({-k, 0, 0}, -k * lo, ray));
}

void run_two_ways(Trial& trial) {
  Random random(31);
  for (std::uint64_t i = 0, count = trial.count(1200); i < count; ++i) {
    const double lo = std::ldexp(random.below(64), -6), middle = lo + std::ldexp(1 + random.below(64), -6);
    const double hi = middle + 1, k = 1 + random.below(1000), inexact = 0.1 * k;
    const auto walls = [](double scale, double from, double to) {
      return half_space({scale, 0, 0}, scale * to) & half_space({-scale, 0, 0}, -scale * from);
    };
    const Ray<double> ray = crossing_ray(random);
    const SolidQuestion nothing(slab_of(lo, middle) - walls(k, lo, middle), ray, TrueSpans{});
    const SolidQuestion seam(slab_of(lo, middle) | walls(k, middle, hi), ray, true_solid_spans(slab_of(lo, hi), ray));
    ask_all_ways(trial, nothing);
    ask_all_ways(trial, seam);
    ask_all_ways(trial, SolidQuestion(slab_of(lo, middle) - walls(inexact, lo, middle), ray));
    const NaiveSpans slab = naive_box<float>({lo, -100, -100}, {middle, 100, 100}, ray);
    nothing.judge_spans(trial.naive("differences of spans in float"),
                        ends_of(naive_difference(slab, naive_walls(k, lo, middle, ray))));
    seam.judge_spans(trial.naive("unions of spans in float"),
                     ends_of(naive_union(slab, naive_walls(k, middle, hi, ray))));
  }
}

Sketch draw_two_ways() {
  Sketch sketch{
      "A slab, and the same slab as half-spaces with normals k times as long; what float leaves is drawn 10^6 "
      "times as wide as it is.",
      {}};
  return sketch.rectangle({0, -2}, {2, 2})
      .line({-2, -1.5}, {4, 1.5}, Role::ray)
      .polygon({{2, -2}, {2.12, -2}, {2.12, 2}, {2, 2}}, Role::naive)
      .dot({0, -0.5}, Role::aid)
      .dot({2, 0.5}, Role::aid)
      .label({0.1, -1.8}, "lo <= x <= hi")
      .label({2.3, -1.2}, "k x <= k hi: same plane, other rounding")
      .label({2.3, 1.8}, "a sliver is left", Role::naive)
      .label({-2, 1}, "truth: nothing is left", Role::truth);
}

// ---- csg-pov

/// Each hit of one solid counts where the point, as computed, is in the other or is not.
std::vector<double> hits_kept_by_points(const Ray<double>& ray, const Vec3d& wall, const Vec3d& cutter) {
  const auto has = [&](const Vec3d& corner, double t) {
    const Vec3d p = ray.at(t);
    return std::fabs(p.x) <= corner.x && std::fabs(p.y) <= corner.y && std::fabs(p.z) <= corner.z;
  };
  std::vector<double> kept;
  for (const double t : ends_of(naive_box<double>(-wall, wall, ray))) {
    if (!has(cutter, t)) kept.push_back(t);
  }
  for (const double t : ends_of(naive_box<double>(-cutter, cutter, ray))) {
    if (has(wall, t)) kept.push_back(t);
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

void run_pov(Trial& trial) {
  const Vec3d wall(1.1), cutter(0.5, 0.5, 1.1);
  const SolidTree holed = box_of(-wall, wall) - box_of(-cutter, cutter);
  Random random(32);
  for (std::uint64_t i = 0, count = trial.count(2000); i < count; ++i) {
    // Mostly through the hole, some into its walls.
    const Vec3d eye(random.uniform_double(), random.uniform_double(), -7), at = 0.6 * random_in_cube(random);
    const Ray<double> ray{eye, Vec3d(at.x, at.y, 1.1 * at.z) - eye};
    const SolidQuestion question(holed, ray);
    ask_all_ways(trial, question);
    if (i % 4 == 0) question.ask_each_structure(trial);
    question.judge_spans(trial.naive("is the point in the other solid?"), hits_kept_by_points(ray, wall, cutter));
  }
}

Sketch draw_pov() {
  Sketch sketch{"A box, less a cutter that ends in the same plane z = -1.1; z goes to the right.", {}};
  sketch.rectangle({-1.1, -1.1}, {1.1, 1.1}).rectangle({-1.1, -0.5}, {1.1, 0.5}, Role::aid);
  for (int i = -3; i <= 3; ++i) {
    const double y = 0.13 * i;
    sketch.line({-3, y}, {2, y}, Role::ray);
    if (i % 2 != 0) sketch.dot({-1.1, y}, Role::naive);
  }
  return sketch.label({-3, 1.3}, "speckle: hits of the box that rounding has put outside of the cutter", Role::naive)
      .label({1.2, -0.9}, "truth: an open hole", Role::truth);
}

// ---- csg-edge-share

/// Through `at`, exactly: in whole steps of a direction in whole numbers.
Ray<double> ray_by_steps(const Vec3d& at, Random& random, std::uint32_t size) {
  Vec3d direction(0);
  while (direction.x == 0 || direction.y == 0 || direction.z == 0) direction = random_lattice_vector(random, size);
  return {at - (1.0 + random.below(40)) * direction, direction};
}

void run_edge_share(Trial& trial) {
  Random random(33);
  for (std::uint64_t i = 0, count = trial.count(1000); i < count; ++i) {
    // Two boxes that have a corner, an edge or a face in common, and a ray through a point of that.
    const Vec3d shared = 0.125 * random_lattice_vector(random, 40), lo = shared - Vec3d(2 + random.below(5));
    Vec3d hi = shared + Vec3d(2 + random.below(5)), at = shared, second_lo = shared;
    const int common = static_cast<int>(i % 3);
    for (int axis = 0; axis < common; ++axis) second_lo[axis] = lo[axis], hi[axis] = shared[axis], at[axis] -= 1;
    const Ray<double> ray = ray_by_steps(at, random, 99);
    const SolidTree a = box_of(lo, shared), b = box_of(second_lo, hi);
    const SolidQuestion whole(a | b, ray), nothing(a & b, ray);
    ask_all_ways(trial, whole);
    ask_all_ways(trial, nothing);
    const NaiveSpans of_a = naive_box<float>(lo, shared, ray), of_b = naive_box<float>(second_lo, hi, ray);
    whole.judge_spans(trial.naive("unions of spans in float"), ends_of(naive_union(of_a, of_b)));
  }
}

Sketch draw_edge_share() {
  Sketch sketch{"Two boxes that share an edge, and a ray through it; the gap that rounding leaves is wider than it is.",
                {}};
  return sketch.rectangle({-2, -2}, {0, 0})
      .rectangle({0, 0}, {2, 2})
      .line({-3, -2.25}, {3, 2.25}, Role::ray)
      .dot({0, 0})
      .line({-0.12, -0.09}, {0.12, 0.09}, Role::naive)
      .label({0.2, -0.4}, "in and out at one point: one span", Role::truth)
      .label({-3, 2.4}, "t by x and t by y round apart: two spans", Role::naive);
}

// ---- csg-deep

/// Each box asked in its own coordinates.
NaiveSpans naive_row(const Ray<double>& ray, int count) {
  NaiveSpans all;
  for (int i = 0; i < count; ++i) {
    Ray<double> own = ray;
    own.origin.x = static_cast<float>(ray.origin.x) - 0.1f * static_cast<float>(i);
    all = naive_union(all, naive_box<float>({0, -1, -1}, {0.1, 1, 1}, own));
  }
  return all;
}

void run_deep(Trial& trial) {
  constexpr int boxes = 40;
  std::vector<SolidTree> parts;
  for (int i = 0; i < boxes; ++i) parts.push_back(box_of({0.1 * i, -1, -1}, {0.1 * (i + 1), 1, 1}));
  const SolidTree whole = box_of({0, -1, -1}, {0.1 * boxes, 1, 1});
  const UnionByStructure row(parts);
  Random random(34);
  for (std::uint64_t i = 0, count = trial.count(250); i < count; ++i) {
    const double slant = i % 4 == 0 ? 0 : 0.2;
    const Vec3d a = random_in_cube(random), b = slant * random_in_cube(random);
    const Ray<double> ray = ray_of_floats({-1, 0.9 * a.y, 0.9 * a.z}, {1, b.y, b.z});
    const SolidQuestion question(row.tree(), ray, true_solid_spans(whole, ray));
    ask_all_ways(trial, question);
    question.ask_spans(trial, row);
    question.judge_spans(trial.naive("each box in its own frame, in float"), ends_of(naive_row(ray, boxes)));
  }
}

Sketch draw_deep() {
  Sketch sketch{"A row of abutting boxes, of which eight are drawn, and a ray along it.", {}};
  for (int i = 0; i < 8; ++i) sketch.rectangle({0.5 * i, -1}, {0.5 * (i + 1), 1});
  sketch.line({-1, -0.4}, {5, 0.5}, Role::ray).dot({0, -0.25}).dot({4, 0.35});
  for (int i = 1; i < 8; ++i) sketch.dot({0.5 * i, -0.25 + 0.075 * i}, Role::naive);
  return sketch.label({0, 1.2}, "truth: one span", Role::truth)
      .label({0, -1.3}, "a seam wherever two ends of one plane round apart", Role::naive);
}

}  // namespace

HardCase csg_two_ways() {
  return {.id = "csg-two-ways",
          .group = "csg",
          .inputs =
              "a slab lo <= x <= hi less the same one as k x <= k hi and -k x <= -k lo, k to 1000; the slab and "
              "its neighbour, so written, united; random rays of floats",
          .expected = "nothing is left; slab and neighbour are one span",
          .why =
              "The same plane asked in two ways gives two values of t: (hi - o) / d and (k hi - k o) / (k d) round "
              "apart. Code that compares them finds a sliver, or a seam, wherever the rounding falls that way. Only "
              "the planes themselves can tell that they are one.",
          .oracle = Oracle::rationals,
          .reference = {},
          .is_policy = false,
          .run = run_two_ways,
          .draw = draw_two_ways};
}

HardCase csg_pov() {
  return {.id = "csg-pov",
          .group = "csg",
          .inputs = "box of +-1.1 less a cutter of +-0.5 by +-0.5 by +-1.1; rays through the hole from z = -7",
          .expected = "an open hole: rays through both mouths meet nothing",
          .why =
              "Asking whether the point hit, o + t d as computed, is inside the other solid is a coin toss where the "
              "point is on a face of both: -1.1 comes back as a neighbour of itself. The open mouth is speckled with "
              "hits of a wall that is not there. Manuals advise to make the cutter longer.",
          .oracle = Oracle::rationals,
          .reference = "POV-Ray 3.6 documentation, 1.2.3.6.1, on coincident surfaces",
          .is_policy = false,
          .run = run_pov,
          .draw = draw_pov};
}

HardCase csg_edge_share() {
  return {.id = "csg-edge-share",
          .group = "csg",
          .inputs = "boxes with a corner, an edge or a face in common, on a lattice of 1/8; rays exactly through it",
          .expected = "the union is one span, their common part none",
          .why =
              "The ray leaves one box by the face across x and enters the other by that across y. Both t are the "
              "same number, but computed from different coordinates and rounded apart: a gap that is not there, or "
              "an overlap.",
          .oracle = Oracle::rationals,
          .reference = {},
          .is_policy = false,
          .run = run_edge_share,
          .draw = draw_edge_share};
}

HardCase csg_deep() {
  return {.id = "csg-deep",
          .group = "csg",
          .inputs = "the union of 40 boxes from 0.1 i to 0.1 (i + 1); rays along the row, straight and slanted",
          .expected = "one span, as of the one box that they make; the same with operands found by any structure",
          .why =
              "Every seam is a comparison of two t of one plane. Where each is computed in its box's own frame, each "
              "of 39 seams opens when the rounding falls that way, and glass shows them all.",
          .oracle = Oracle::rationals,
          .reference = {},
          .is_policy = false,
          .run = run_deep,
          .draw = draw_deep};
}

}  // namespace sightline::hard
