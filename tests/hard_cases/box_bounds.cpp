/// Boxes around things, and boxes very far away.

#include <array>
#include <cmath>
#include <stdexcept>

#include "sightline/csg/solid_set.h"
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

// ---- box-far-sentinel

void run_far_sentinel(Trial& trial) {
  Random random(61);
  const auto count = trial.count(20);
  for (const float far : {1e30f, 1.5e30f, 1e33f, 1e36f}) {
    // So far away that copies along x are in one place: nine boxes in three.
    const Aabb box{{far, -1, -1}, {2 * far, 1, 1}};
    const BoxesByStructure boxes = boxes_around(box, 4);
    for (std::uint64_t i = 0; i < count; ++i) {
      const Vec3d aside = i == 0 ? Vec3d(0) : 0.9 * random_in_cube(random);
      const Ray<double> ray = ray_of_floats({0, aside.y, aside.z}, {1, 0, 0});
      const SolidQuestion question(solid_of(box), ray);
      question.ask_first(trial, "box");
      ask_box_set(trial, box, question);
      ask_volume_tests(trial, box, box, ray_in_float(ray));
      ask_structures(trial, boxes, ray);

      float nearest = 1e30f;  // no hit so far
      const float t = naive_slabs(box, ray_in_float(ray)).enter;
      const bool is_nearer = t < nearest;
      question.judge_first(trial.naive("a miss is t = 1e30"), is_nearer ? std::optional<double>(t) : std::nullopt);
    }
  }
}

Sketch draw_far_sentinel() {
  Sketch sketch{"A box 1e30 away, drawn nearer.", {}};
  return sketch.rectangle({6, -0.5}, {8, 0.5})
      .line({0, 0}, {8.5, 0}, Role::ray)
      .dot({6, 0})
      .dot({0, 0}, Role::aid)
      .label({4.2, 0.7}, "true: t = 1e30", Role::truth)
      .label({1, -1}, "1e30 < 1e30 is false: no hit", Role::naive);
}

// ---- bounds-round

struct TrueBounds {
  std::array<Rational, 3> lo, hi;
};

/// Whether the box holds the bounds, and whether no box of floats inside it does.
Verdict verdict_of(const Aabb& box, const TrueBounds& truth) {
  Verdict verdict = Verdict::exact;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (!std::isfinite(box.lo[axis]) || !std::isfinite(box.hi[axis])) return Verdict::wrong;
    if (Rational(box.lo[axis]) > truth.lo[i] || Rational(box.hi[axis]) < truth.hi[i]) return Verdict::wrong;
    const bool is_tight = Rational(std::nextafter(box.lo[axis], INFINITY)) > truth.lo[i] &&
                          Rational(std::nextafter(box.hi[axis], -INFINITY)) < truth.hi[i];
    if (!is_tight) verdict = Verdict::within_bound;
  }
  return verdict;
}

void judge_bounds(Tally& tally, const SolidTree& tree, const Aabb& box, const TrueBounds& truth) {
  const auto text = [](const auto& lo, const auto& hi) {
    return "x from " + all_digits(static_cast<double>(lo)) + " to " + all_digits(static_cast<double>(hi));
  };
  tally.add(verdict_of(box, truth), [&] {
    return Example{text_of(tree), "around " + text(truth.lo[0], truth.hi[0]), text(box.lo.x, box.hi.x)};
  });
}

void run_bounds_round(Trial& trial) {
  Random random(62);
  const auto count = trial.count(2000);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec3d center = std::ldexp(1.0, static_cast<int>(random.below(20)) - 10) * random_in_cube(random);
    const double radius = random.uniform_double();
    const SolidTree ball = solid::Sphere{center, radius}, cube = solid::Box{center - radius, center + radius};
    const auto bounds = [&](const Vec3d& lo, const Vec3d& hi, const Rational& more, const Vec3d& move, double scale) {
      TrueBounds truth;
      for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        truth.lo[k] = (Rational(lo[axis]) - more - Rational(move[axis])) / Rational(scale);
        truth.hi[k] = (Rational(hi[axis]) + more - Rational(move[axis])) / Rational(scale);
      }
      return truth;
    };
    const Vec3d still(0), lo = center - radius, hi = center + radius;
    judge_bounds(trial.of("bounds of a sphere"), ball, Solid(ball).bounds(), bounds(center, center, radius, still, 1));
    judge_bounds(trial.of("bounds of a box"), cube, Solid(cube).bounds(), bounds(lo, hi, 0, still, 1));
    // In a frame, as a point of the world has the place scale p + move.
    const double scale = 0.5 + random.uniform_double();
    const Vec3d move = random_in_cube(random);
    SolidTree moved_ball = ball, moved_cube = cube;
    moved_ball.frame.rows = {{{scale, 0, 0, move.x}, {0, scale, 0, move.y}, {0, 0, scale, move.z}}};
    moved_cube.frame = moved_ball.frame;
    judge_bounds(trial.of("bounds of a sphere in a frame"), moved_ball, Solid(moved_ball).bounds(),
                 bounds(center, center, radius, move, scale));
    judge_bounds(trial.of("bounds of a box in a frame"), moved_cube, Solid(moved_cube).bounds(),
                 bounds(lo, hi, 0, move, scale));
    judge_bounds(trial.naive("numbers cast to float"), cube, {Vec3f(lo), Vec3f(hi)}, bounds(lo, hi, 0, still, 1));
  }
}

Sketch draw_bounds_round() {
  Sketch sketch{"A solid in double, and its box in float on a grid of floats, which is drawn far too coarse.", {}};
  for (int i = 0; i <= 6; ++i) sketch.line({i, 0}, {i, 4}, Role::aid);
  for (int i = 0; i <= 4; ++i) sketch.line({0, i}, {6, i}, Role::aid);
  return sketch.circle({2.9, 2.1}, 1.5)
      .rectangle({1, 0}, {5, 4}, Role::truth)
      .rectangle({1.03, 1}, {4.03, 3.97}, Role::naive)
      .label({0, 4.3}, "rounded outward: holds it")
      .label({0, -0.5}, "rounded to nearest: rays past its rim are skipped", Role::naive);
}

// ---- bounds-infinite

/// The surface area heuristic's measure, as one writes it.
float naive_half_area(const Aabb& box) {
  const Vec3f e = box.hi - box.lo;
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

/// Whether every node has a measure, or says that it goes on without end.
bool has_measures(const Solid& solid) {
  for (const SolidNode& node : solid.nodes()) {
    if (node.is_bounded && !std::isfinite(half_area(node.bounds))) return false;
  }
  return true;
}

bool is_refused(const SolidTree& tree) {
  try {
    SolidSet<Level::watertight>({std::make_shared<const Solid>(tree)});
  } catch (const std::invalid_argument&) {
    return true;
  }
  return false;
}

void run_bounds_infinite(Trial& trial) {
  std::vector<SolidTree> operands;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) operands.emplace_back(solid::Sphere{{3.0 * x, 3.0 * y, 0}, 1});
  }
  operands.emplace_back(solid::HalfSpace{{0, 0, 1}, -2});
  operands.emplace_back(solid::HalfSpace{{1, 1, 1}, -40});
  const UnionByStructure scene(operands);
  Random random(63);
  const auto count = trial.count(200);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Ray<double> ray = ray_of_floats(6.0 * random_in_cube(random) + Vec3d(0, 0, 6), random_in_cube(random));
    SolidQuestion(scene.tree(), ray).ask_spans(trial, scene);
  }
  for (const auto& [structure, solid] : scene.all()) {
    const bool is_right = has_measures(solid) && !solid.is_bounded();
    trial.of("measures of nodes").decide(is_right, [&, name = structure] {
      return Example{std::string(name) + " over spheres and half-spaces", "finite, or without bounds", "NaN"};
    });
  }
  trial.of("solids below a structure").decide(is_refused(scene.tree()), [&] {
    return Example{"a union with half-spaces", "refused: it has no bounds", "taken"};
  });
  const float everywhere = INFINITY;
  for (int axis = 0; axis < 3; ++axis) {
    Aabb plane{Vec3f(-everywhere), Vec3f(everywhere)};
    plane.lo[axis] = plane.hi[axis] = 0;
    const float area = naive_half_area(plane);
    trial.naive("the area of a plane's box").decide(std::isfinite(area), [&] {
      return Example{"a plane across an axis", "a number", all_digits(double(area))};
    });
  }
}

Sketch draw_bounds_infinite() {
  Sketch sketch{"Spheres over a floor without end. Spheres have boxes; the floor has none, and stands beside the tree.",
                {}};
  for (const double x : {0.0, 3.0, 6.0}) sketch.circle({x, 1}, 1).rectangle({x - 1, 0}, {x + 1, 2}, Role::aid);
  return sketch.line({-4, -0.5}, {10, -0.5}, Role::shape)
      .line({4.3, 4}, {4.5, -0.5}, Role::ray)
      .dot({4.5, -0.5})
      .label({-3.5, -1.2}, "its box: infinity times 0 = NaN, and no split is ever best", Role::naive)
      .label({4.8, 2.6}, "true: hit", Role::truth);
}

}  // namespace

HardCase box_far_sentinel() {
  return {.id = "box-far-sentinel",
          .group = "box",
          .inputs = "boxes from (f, -1, -1) to (2 f, 1, 1), f = 1e30, 1.5e30, 1e33 and 1e36, rays along x from x = 0",
          .expected = "hit at t = f",
          .why =
              "A number that stands for `no hit` is a number like others: what is that far away is no nearer than "
              "nothing. Infinity is the one t that no hit has.",
          .oracle = Oracle::rationals,
          .reference = "tinybvh, BVH_FAR",
          .run = run_far_sentinel,
          .draw = draw_far_sentinel};
}

HardCase bounds_round() {
  return {.id = "bounds-round",
          .group = "box",
          .inputs = "spheres and boxes in random doubles, in the world and in frames; their bounds in float",
          .expected = "bounds that contain the solid, and no wider than the next floats",
          .why =
              "A cast rounds to nearest: half of all lower corners go up and half of all upper ones down. What sticks "
              "out of its box is lost to rays that meet it there, and nobody sees why.",
          .oracle = Oracle::rationals,
          .run = run_bounds_round,
          .draw = draw_bounds_round};
}

HardCase bounds_infinite() {
  return {
      .id = "bounds-infinite",
      .group = "box",
      .inputs = "nine spheres and two half-spaces as one union, below every structure; a plane's box",
      .expected = "the true spans; each node measured by a number, or known to have no bounds; no tree over the latter",
      .why =
          "A plane's box is infinite in two directions and flat in the third: its area is infinity times 0, NaN, "
          "and so is every cost that it is part of. Comparisons with NaN are false, so no split is chosen, or "
          "always the first.",
      .oracle = Oracle::closed_form,
      .run = run_bounds_infinite,
      .draw = draw_bounds_infinite};
}

}  // namespace sightline::hard
