/// Spans that have no end, and those in which the origin is.

#include <algorithm>
#include <cmath>

#include "sightline/math/random.h"
#include "tests/csg/evaluate.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/csg_naive.h"
#include "tests/hard_cases/csg_parts.h"
#include "tests/hard_cases/random_vectors.h"

namespace sightline::hard {
namespace {

// ---- csg-infinite

/// Between two ends in turn, the middle is asked whether it is in x . n <= w or in -x . n <= -w.
bool is_all_by_middles(const Vec3d& n, double w, const Ray<double>& ray) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double t = (w - glm::dot(n, ray.origin)) / glm::dot(n, ray.direction);
  for (const auto& [lo, hi] : NaiveSpans{{-infinity, t}, {t, infinity}}) {
    const Vec3d middle = ray.at((lo + hi) / 2);
    if (!(glm::dot(n, middle) <= w) && !(glm::dot(-n, middle) <= -w)) return false;
  }
  return true;
}

void run_infinite(Trial& trial) {
  Random random(61);
  const TrueSpans everything{true, {}, {}};
  for (std::uint64_t i = 0, count = trial.count(1500); i < count; ++i) {
    const Vec3d normal = i % 2 == 0 ? random_on_sphere(random) : random_lattice_vector(random, 5);
    if (normal == Vec3d(0)) continue;
    const double offset = i % 4 < 2 ? random.below(9) : random.uniform_double();
    Ray<double> ray{4.0 * random_in_cube(random), random_in_cube(random)};
    if (i % 3 == 0) ray = {random_lattice_vector(random, 5), {0, 0, 1}};
    if (i % 5 == 0) ray.direction = glm::cross(normal, Vec3d(1, 2, 4));  // along the plane, when in whole numbers
    if (ray.direction == Vec3d(0)) continue;
    const SolidTree half = half_space(normal, offset);
    ask_all_ways(trial, SolidQuestion(half | ~half, ray, everything));
    ask_all_ways(trial, SolidQuestion(half & ~half, ray, TrueSpans{}));
    ask_all_ways(trial, SolidQuestion(~(half & ~half), ray, everything));
    ask_all_ways(trial, SolidQuestion((half | ~half) - box_of(Vec3d(-1), Vec3d(1)), ray));
    trial.naive("the middle of a span without end").decide(is_all_by_middles(normal, offset, ray), [&] {
      return Example{text_of(half) + " or not, " + text_of(ray), "everywhere", "a span is missing"};
    });
  }
}

Sketch draw_infinite() {
  Sketch sketch{"A half-space and its complement: together all of space.", {}};
  return sketch.line({0, -2}, {0, 2}, Role::shape)
      .line({-4, -0.8}, {4, 0.8}, Role::ray)
      .dot({0, 0}, Role::naive)
      .label({-3.5, 1.3}, "n . x <= w")
      .label({1.5, 1.3}, "not n . x <= w")
      .label({-3.5, -1.3}, "truth: from -infinity to infinity, without a seam", Role::truth)
      .label({-3.5, -1.8}, "its middle is (inf - inf) / 2, not a number", Role::naive);
}

// ---- csg-camera-inside

/// Entries alone, ahead of the eye.
std::optional<double> first_entry(const NaiveSpans& spans) {
  for (const NaiveSpan& span : spans) {
    if (span.lo > 0) return span.lo;
  }
  return std::nullopt;
}

/// Whether the normal that goes with the first boundary tells entering from leaving.
void ask_normal(Trial& trial, const SolidTree& tree, const Ray<double>& ray, const SolidQuestion& question) {
  const auto first = question.first_end();
  if (!first) return;
  const bool leaves = (*first % 2 == 0) == question.truth().begins_inside;
  const Solid solid(tree);
  for (const Level level : all_levels) {
    const auto boundary = first_of(solid, ray, 0, std::numeric_limits<double>::infinity(), level);
    const double along = boundary ? glm::dot(solid.normal(*boundary, ray), ray.direction) : 0;
    trial.of("normal", level).decide(leaves ? along > 0 : along < 0, [&] {
      return Example{text_of(tree) + ", " + text_of(ray),
                     leaves ? "outward, the ray leaves" : "outward, the ray enters",
                     "normal . direction = " + all_digits(along)};
    });
  }
}

void run_camera_inside(Trial& trial) {
  const SolidTree cut_ball = ball_of({0, 0, 0}, 1) & half_space({1, 0, 0}, 0.25);
  const SolidTree hollow = box_of(Vec3d(-2), Vec3d(2)) - ball_of({0, 0, 0}, 1);
  Random random(62);
  for (std::uint64_t i = 0, count = trial.count(250); i < count; ++i) {
    const Vec3d in_cube = random_in_cube(random);
    const Vec3d inside = 0.5 * in_cube - Vec3d(0.3, 0, 0), on_cut(0.25, 0.5 * in_cube.y, 0.5 * in_cube.z);
    const Vec3d in_wall(1.5, in_cube.y, in_cube.z), on_ball(0, 0.6, i % 2 == 0 ? 0.8 : -0.8),
        on_face(2, in_wall.y, 0.5);
    const Vec3d direction = random_on_sphere(random);
    const auto ask = [&](const SolidTree& tree, const Vec3d& eye, const Vec3d& towards) {
      const Ray<double> ray{eye, towards};
      const SolidQuestion question(tree, ray);
      ask_all_ways(trial, question);
      if (i % 8 == 0) question.ask_each_structure(trial);
      ask_normal(trial, tree, ray, question);
    };
    for (const Vec3d& eye : {inside, on_cut}) ask(cut_ball, eye, direction), ask(cut_ball, eye, {i % 2 ? 1 : -1, 0, 0});
    for (const Vec3d& eye : {in_wall, on_ball, on_face, in_cube}) ask(hollow, eye, direction);
    const Ray<double> ray{inside, direction};
    SolidQuestion(cut_ball, ray)
        .judge_first(trial.naive("the first entry ahead"),
                     first_entry(naive_intersection(naive_ball<double>({0, 0, 0}, 1, ray),
                                                    naive_half<double>({1, 0, 0}, 0.25, ray))));
  }
}

Sketch draw_camera_inside() {
  Sketch sketch{"A ball cut at x = 1/4, seen from within and from the cut.", {}};
  return sketch.circle({0, 0}, 1)
      .line({0.25, -1.3}, {0.25, 1.3}, Role::shape)
      .line({-0.5, -0.2}, {1.5, 0.3}, Role::ray)
      .dot({-0.5, -0.2}, Role::aid)
      .dot({0.25, -0.0125})
      .dot({0.25, 0.5}, Role::aid)
      .line({0.25, 0.5}, {1.4, 0.9}, Role::ray)
      .label({-0.9, -0.4}, "from inside: the way out comes first", Role::truth)
      .label({0.4, 1.1}, "on the cut, outward: t = 0 is behind, nothing comes", Role::truth)
      .label({-1.4, -1.4}, "who looks for entries alone sees through it", Role::naive);
}

}  // namespace

HardCase csg_infinite() {
  return {.id = "csg-infinite",
          .group = "csg",
          .inputs =
              "a half-space united with its complement, cut with it, and a box taken from the union; any rays, "
              "some along the plane",
          .expected = "(-inf, inf) without a boundary; nothing; the box's complement",
          .why =
              "Spans of unbounded solids end at infinities, and these do not calculate: the middle of (-inf, inf) is "
              "inf - inf, a point at infinity has coordinates 0 * inf, and a ray along the plane divides 0 by 0. Each "
              "NaN then fails every comparison. Inside or outside at -infinity is a flag, not a number.",
          .oracle = Oracle::closed_form,
          .reference = {},
          .is_policy = false,
          .run = run_infinite,
          .draw = draw_infinite};
}

HardCase csg_camera_inside() {
  return {.id = "csg-camera-inside",
          .group = "csg",
          .inputs =
              "eyes within a cut ball, exactly on the cut, in a hollow box, in its wall, on its faces and on its "
              "inner sphere",
          .expected = "the first boundary with t > 0, entering or leaving; the normal says which",
          .why =
              "From inside, the first boundary leaves: code that waits for an entry sees through the solid. Exactly "
              "on a face t is 0 and must not count, but rounding makes 1e-17 of it; then the eye meets the surface it "
              "sits on.",
          .oracle = Oracle::rationals,
          .reference = {},
          .is_policy = false,
          .run = run_camera_inside,
          .draw = draw_camera_inside};
}

}  // namespace sightline::hard
