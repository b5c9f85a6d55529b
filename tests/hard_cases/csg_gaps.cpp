/// Spans and gaps that are short, and such as have no length.

#include <cmath>
#include <variant>

#include "sightline/math/random.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/csg_naive.h"
#include "tests/hard_cases/csg_parts.h"
#include "tests/hard_cases/random_vectors.h"

namespace sightline::hard {
namespace {

constexpr double point = -1e-300;  ///< What is no shorter than this is kept: points are.

// ---- csg-self

void run_self(Trial& trial) {
  Random random(41);
  const Dice dice = dice_of(random);
  for (std::uint64_t i = 0, count = trial.count(1200); i < count; ++i) {
    const SolidTree any = any_primitive(dice);
    const Ray<double> ray = lattice_ray(dice);
    ask_all_ways(trial, SolidQuestion(any - any, ray, TrueSpans{}));
    ask_all_ways(trial, SolidQuestion(any ^ any, ray, TrueSpans{}));
    if (!std::holds_alternative<Torus>(any.shape)) {
      ask_all_ways(trial, SolidQuestion(any | any, ray, true_solid_spans(any, ray)));
    }

    const Vec3d center = random_lattice_vector(random, 3);
    const SolidQuestion nothing(ball_of(center, 2) - ball_of(center, 2), ray, TrueSpans{});
    ask_all_ways(trial, nothing);
    const NaiveSpans ball = naive_ball<float>(center, 2, ray);
    nothing.judge_spans(trial.naive("differences that keep lo <= hi"), ends_of(naive_difference(ball, ball, point)));
  }
}

/// Spans above each other, along the ray.
Sketch spans_beside(std::string caption, const std::vector<NaiveSpan>& operands,
                    const std::vector<std::string>& names) {
  Sketch sketch{std::move(caption), {}};
  sketch.line({-1, 0}, {6, 0}, Role::ray).label({5.2, 0.2}, "t");
  double y = 1;
  for (std::size_t i = 0; i < operands.size(); ++i, ++y) {
    sketch.rectangle({operands[i].lo, y}, {operands[i].hi, y + 0.5}).label({-1, y + 0.2}, names[i]);
  }
  return sketch;
}

Sketch draw_self() {
  return spans_beside("Spans of a solid and of itself along one ray.", {{1, 4}, {1, 4}}, {"A", "A"})
      .dot({1, -0.7}, Role::naive)
      .dot({4, -0.7}, Role::naive)
      .label({1.2, -1.2}, "[1, 1] and [4, 4]: as long as lo <= hi is asked", Role::naive)
      .label({-1, -2}, "truth of A - A: nothing", Role::truth);
}

// ---- csg-gap

Ray<double> along_x_through(Random& random, double size) {
  const Vec3d at = size * random_in_cube(random), slant = 0.25 * random_in_cube(random);
  return ray_of_floats({-4, at.y, at.z}, {1, slant.y / 4, slant.z / 4});
}

void ask_gap(Trial& trial, double gap, const Ray<double>& ray) {
  const SolidQuestion shell(ball_of({0, 0, 0}, 1 + gap) - ball_of({0, 0, 0}, 1), ray);
  const SolidQuestion blocks(slab_of(-1, 1) | slab_of(1 + gap, 2), ray);
  Ray<double> from_inside = ray;
  from_inside.origin.x = 0;
  const SolidQuestion shell_from_inside(ball_of({0, 0, 0}, 1 + gap) - ball_of({0, 0, 0}, 1), from_inside);
  for (const SolidQuestion* question : {&shell, &blocks, &shell_from_inside}) ask_all_ways(trial, *question);

  constexpr double near = 1e-5;
  shell.judge_spans(trial.naive("what is shorter than 1e-5 is nothing"),
                    ends_of(naive_difference(naive_ball<double>({0, 0, 0}, 1 + gap, ray),
                                             naive_ball<double>({0, 0, 0}, 1, ray), near)));
  blocks.judge_spans(trial.naive("what is nearer than 1e-5 is one"),
                     ends_of(naive_union(naive_box<double>({-1, -100, -100}, {1, 100, 100}, ray),
                                         naive_box<double>({1 + gap, -100, -100}, {2, 100, 100}, ray), near)));
}

void run_gap(Trial& trial) {
  Random random(42);
  for (int k = 1; k <= 52; ++k) {
    for (std::uint64_t i = 0, count = trial.count(15); i < count; ++i) {
      ask_gap(trial, std::ldexp(1.0, -k), along_x_through(random, 0.5));
    }
  }
  for (std::uint64_t i = 0, count = trial.count(100); i < count; ++i) ask_gap(trial, 0, along_x_through(random, 0.5));
}

Sketch draw_gap() {
  Sketch sketch{"A shell of thickness 2^-k, here 1/4; in the case down to 2^-52, and 0.", {}};
  return sketch.circle({0, 0}, 1.25)
      .circle({0, 0}, 1)
      .line({-3, 0.2}, {3, 0.2}, Role::ray)
      .line({-1.234, 0.2}, {-0.98, 0.2}, Role::truth)
      .line({0.98, 0.2}, {1.234, 0.2}, Role::truth)
      .dot({-1.234, 0.2})
      .dot({-0.98, 0.2})
      .dot({0.98, 0.2})
      .dot({1.234, 0.2})
      .label({-3, 1.5}, "two spans as long as it has any thickness", Role::truth)
      .label({-2.6, -1.6}, "with eps = 1e-5 it is gone from k = 17 on", Role::naive);
}

// ---- csg-ulp-seam

void run_ulp_seam(Trial& trial) {
  const double below = 0.3, above = 0.1 + 0.2;
  const SolidTree halves = half_space({1, 0, 0}, below) | half_space({-1, 0, 0}, -above);
  const SolidTree boxes = box_of({-9, -9, -9}, {below, 9, 9}) | box_of({above, -9, -9}, {9, 9, 9});
  const SolidTree common = box_of({-9, -9, -9}, {above, 9, 9}) & box_of({below, -9, -9}, {9, 9, 9});
  Random random(43);
  for (std::uint64_t i = 0, count = trial.count(1000); i < count; ++i) {
    Ray<double> ray = along_x_through(random, 1);
    ray.origin.x = i % 2 == 0 ? 0 : -std::ldexp(1.0, -static_cast<int>(random.below(20)));
    ray.direction *= std::ldexp(1.0, static_cast<int>(random.below(60)) - 30);
    if (i % 3 == 0) ray.direction.y = ray.direction.z = 0;
    const SolidQuestion gap(halves, ray), gap_of_boxes(boxes, ray);
    for (const SolidQuestion* question : {&gap, &gap_of_boxes}) ask_all_ways(trial, *question);
    ask_all_ways(trial, SolidQuestion(common, ray));
    gap.judge_spans(trial.naive("what is nearer than 1e-10 is one"),
                    ends_of(naive_union(naive_half<double>({1, 0, 0}, below, ray),
                                        naive_half<double>({-1, 0, 0}, -above, ray), 1e-10 / ray.direction.x)));
  }
}

Sketch draw_ulp_seam() {
  return spans_beside("What is below 0.3 and what is above 0.1 + 0.2, the gap widened 10^16 times.",
                      {{0.7, 2}, {2.6, 6}}, {"x <= 0.3", "x >= 0.1 + 0.2"})
      .line({2, 0}, {2.6, 0}, Role::truth)
      .label({1.2, -0.5}, "5.55e-17 of nothing between two neighbouring doubles", Role::truth)
      .label({1.2, -1.1}, "any eps closes it", Role::naive);
}

// ---- csg-zero-length

void run_zero_length(Trial& trial) {
  Random random(44);
  for (std::uint64_t i = 0, count = trial.count(1500); i < count; ++i) {
    const double lo = std::ldexp(random.below(64), -5), cut = lo + std::ldexp(1 + random.below(63), -6), hi = lo + 2;
    Ray<double> ray = along_x_through(random, 1);
    if (i % 4 == 0) ray.direction = {1, 0, 0};
    const SolidQuestion whole(slab_of(lo, hi) - slab_of(cut, cut), ray, true_solid_spans(slab_of(lo, hi), ray));
    ask_all_ways(trial, whole);
    ask_all_ways(trial, SolidQuestion(slab_of(lo, hi) & slab_of(cut, cut), ray, TrueSpans{}));
    const NaiveSpans none{{(cut - ray.origin.x) / ray.direction.x, (cut - ray.origin.x) / ray.direction.x}};
    whole.judge_spans(trial.naive("differences of any spans"),
                      ends_of(naive_difference(naive_box<double>({lo, -100, -100}, {hi, 100, 100}, ray), none)));
  }
}

Sketch draw_zero_length() {
  return spans_beside("[0, 2] less [1, 1], a slice without thickness.", {{1, 5}}, {"A"})
      .line({3, 0.7}, {3, 1.8}, Role::aid)
      .dot({3, 0}, Role::naive)
      .label({3.1, 2}, "a cut that takes nothing away")
      .label({-1, -0.6}, "[0, 1] and [1, 2]: a face within the solid", Role::naive)
      .label({-1, -1.2}, "truth: [0, 2]", Role::truth);
}

}  // namespace

HardCase csg_self() {
  return {
      .id = "csg-self",
      .group = "csg",
      .inputs =
          "A - A, A xor A and A | A of boxes, balls, cylinders, cones, tori, quadrics, meshes and half-spaces, often "
          "in a frame; rays through lattice points",
      .expected = "nothing, nothing and A, along every ray",
      .why =
          "Both operands end at the same t. Where spans are closed, [a, b] less itself leaves [a, a] and [b, b] "
          "unless lo = hi counts as empty; where the operands are rounded apart, slivers as well. A point has no "
          "volume: results are regularised.",
      .oracle = Oracle::metamorphic,
      .reference = "Requicha and Voelcker, Constructive Solid Geometry, 1977 (regularised sets)",
      .is_policy = false,
      .run = run_self,
      .draw = draw_self};
}

HardCase csg_gap() {
  return {.id = "csg-gap",
          .group = "csg",
          .inputs =
              "ball of radius 1 + 2^-k less the unit ball, slabs to 1 and from 1 + 2^-k, k = 1 to 52, and gap 0; "
              "rays from outside and from within",
          .expected = "the shell is there, and the gap is, if and only if it is wider than 0",
          .why =
              "An epsilon is a claim that nothing smaller matters. With 1e-5 all shells from 2^-17 on are gone, and "
              "all gaps are closed; with a smaller one coincident faces fall apart. There is no good value: only "
              "exact comparison tells a thin shell from none.",
          .oracle = Oracle::rationals,
          .reference = {},
          .is_policy = false,
          .run = run_gap,
          .draw = draw_gap};
}

HardCase csg_ulp_seam() {
  return {.id = "csg-ulp-seam",
          .group = "csg",
          .inputs = "x <= 0.3 united with x >= 0.1 + 0.2, as doubles; also as boxes, and what two such boxes share",
          .expected = "a gap of 5.55e-17 between 0.3 and its upper neighbour; a common part as thin",
          .why =
              "0.1 + 0.2 rounds to the double above 0.3: as written, the two planes differ, and the gap between them "
              "is part of the scene. Any epsilon closes it; and once t is computed, the gap is below its rounding, so "
              "that t alone cannot tell.",
          .oracle = Oracle::rationals,
          .reference = {},
          .is_policy = false,
          .run = run_ulp_seam,
          .draw = draw_ulp_seam};
}

HardCase csg_zero_length() {
  return {.id = "csg-zero-length",
          .group = "csg",
          .inputs =
              "a slab of thickness 2 less a slice of thickness 0 within it, such as [0, 2] - [1, 1]; their common "
              "part; rays across",
          .expected = "[0, 2]; nothing in common",
          .why =
              "Interval arithmetic on lists splits [0, 2] into [0, 1] and [1, 2]: a surface appears inside of the "
              "solid, with shadows and refraction. As sets of points with volume, regularised, the two are one.",
          .oracle = Oracle::closed_form,
          .reference = "Requicha and Voelcker, Constructive Solid Geometry, 1977 (regularised sets)",
          .is_policy = false,
          .run = run_zero_length,
          .draw = draw_zero_length};
}

}  // namespace sightline::hard
