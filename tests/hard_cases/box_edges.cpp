/// Edges and corners of boxes.

#include <cmath>

#include "sightline/math/random.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/box_parts.h"
#include "tests/hard_cases/box_question.h"
#include "tests/hard_cases/naive_slabs.h"
#include "tests/hard_cases/naive_sphere.h"
#include "tests/hard_cases/random_vectors.h"

namespace sightline::hard {
namespace {

using Rational = boost::multiprecision::cpp_rational;

// ---- box-silhouette

void judge_hit(Tally& tally, const Aabb& box, const Ray<double>& ray, bool is_hit) {
  const auto clip = true_clip(box, ray);
  const bool truth = clip && clip->leave >= 0;
  tally.decide(is_hit == truth, [&] { return Example{text_of(ray), truth ? "hit" : "miss", is_hit ? "hit" : "miss"}; });
}

void run_silhouette(Trial& trial) {
  const Aabb box{{0.1f, 0.2f, 0.3f}, {0.7f, 0.9f, 1.1f}};
  const BoxesByStructure boxes = boxes_around(box, 8);
  Random random(51);
  const auto count = trial.count(1000);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec3d eye = Vec3d(Vec3f(Vec3d(4, 4, 0) + 2.0 * random_in_cube(random)));
    const Vec3d on_edge(box.hi.x, box.lo.y, 0.3 + 0.8 * random.uniform_double());
    const auto ask = [&](const Ray<double>& ray) {
      const SolidQuestion question(solid_of(box), ray);
      question.ask_spans(trial, "box");
    };
    // Both neighbours of a direction to the edge, in float and in double.
    Ray<float> narrow{Vec3f(eye), Vec3f(on_edge - eye)};
    const float side = i % 2 ? INFINITY : -INFINITY;
    narrow.direction.x = std::nextafter(narrow.direction.x, side);
    const Ray<double> ray = to_double(narrow);
    ask(ray);
    ask_volume_tests(trial, box, box, narrow);
    if (i % 4 == 0) ask_structures(trial, boxes, ray);
    judge_hit(trial.naive("slabs in float"), box, ray, naive_slabs(box, narrow).is_hit());

    Ray<double> wide{eye, on_edge - eye};
    wide.direction.x = std::nextafter(wide.direction.x, double(side));
    ask(wide);
    judge_hit(trial.naive("slabs in double"), box, wide, naive_slabs(box, wide).is_hit());
  }
}

Sketch draw_silhouette() {
  Sketch sketch{"Two rays from one eye, aimed a last place to either side of an edge; drawn far apart.", {}};
  return sketch.rectangle({0, 0}, {3, 2})
      .dot({7, 4}, Role::aid)
      .line({7, 4}, {1, -1.625}, Role::ray)
      .line({7, 4}, {1.4, -1.95}, Role::ray)
      .dot({3, 0}, Role::aid)
      .dot({3, 0.25})
      .label({7, 4.3}, "eye")
      .label({-1.6, -1}, "true: one hits, one misses", Role::truth)
      .label({3.3, -0.2}, "rounded slabs: either", Role::naive);
}

// ---- box-corner-touch

void run_corner_touch(Trial& trial) {
  const Aabb box{Vec3f(0), Vec3f(4)};
  const BoxesByStructure boxes = boxes_around(box, 1 << 14);
  Random random(53);
  const auto count = trial.count(500);
  for (std::uint64_t i = 0; i < count; ++i) {
    // Up in x and down in y through an edge or a corner, so that only that point is in the box.
    const Vec3d point(4, 4, i % 2 ? 4 : 1 + random.below(3));
    const auto whole = [&] { return 1.0 + random.below(500); };
    const double x = whole(), y = -whole();
    const Vec3d direction(x, y, i % 2 ? whole() : random.below(3) == 0 ? 0 : 0.125 * whole());
    const double t = 1 + random.below(9);
    const Ray<double> ray{point - t * direction, direction};
    SolidQuestion(solid_of(box), ray).ask_spans(trial, "box");
    const SolidQuestion touch(solid_of(box), ray,
                              {false, {true_number(Rational(t)), true_number(Rational(t))}, {t, t}});
    ask_box_set(trial, box, touch);
    ask_volume_tests(trial, box, box, ray_in_float(ray));
    if (i % 4 < 2) {
      SolidQuestion(boxes.solids().tree(), ray).ask_spans(trial, boxes.solids());
      ask_triangles(trial, boxes, SolidQuestion(boxes.solids().tree(), ray, touch.truth()));
    }
    judge_hit(trial.naive("slabs in float"), box, ray, naive_slabs(box, ray_in_float(ray)).is_hit());
  }
}

Sketch draw_corner_touch() {
  Sketch sketch{"A ray that meets a box in one point, an edge seen from above.", {}};
  return sketch.rectangle({0, 0}, {2, 2})
      .line({0, 4}, {4, 0}, Role::ray)
      .dot({2, 2})
      .label({2.2, 2.1}, "touched: enter = leave")
      .label({-0.6, -0.6}, "3 (1 / 3) and 7 (1 / 7) rounded: hit or missed, by direction", Role::naive);
}

}  // namespace

HardCase box_silhouette() {
  return {
      .id = "box-silhouette",
      .group = "box",
      .inputs = "the box from (0.1, 0.2, 0.3) to (0.7, 0.9, 1.1) in float, rays at an edge less or more a last place",
      .expected = "hit or missed as real arithmetic says; volumes that are truly met are kept",
      .why =
          "Near an edge two slabs are entered and left at almost one t, each rounded three times: which of them "
          "comes first is a matter of luck, and a box whose triangle would be hit is skipped. A margin of the "
          "rounding, or a decision by exact numbers, mends it.",
      .oracle = Oracle::rationals,
      .reference = "Ize, Robust BVH Ray Traversal, 2013",
      .run = run_silhouette,
      .draw = draw_silhouette};
}

HardCase box_corner_touch() {
  return {
      .id = "box-corner-touch",
      .group = "box",
      .inputs = "the box from 0 to 4, lines in whole numbers that meet only an edge or a corner",
      .expected = "solid: not entered; primitive and triangles: met there, enter = leave; volume: kept",
      .why =
          "Two slabs are left and entered at one t, which is k / 3 by one axis and 2 k / 6 by the other: equal, but "
          "not by products with reciprocals. Either answer is good; one that changes with the direction is not.",
      .oracle = Oracle::rationals,
      .is_policy = true,
      .run = run_corner_touch,
      .draw = draw_corner_touch};
}

}  // namespace sightline::hard
