#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "sightline/texture/checker.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/hard_cases.h"
#include "tests/hard_cases/naive_sphere.h"
#include "tests/hard_cases/random_vectors.h"
#include "tests/hard_cases/solid_question.h"

namespace sightline::hard {
namespace {

/// Where n.x = w is met, as one writes it first.
double naive_plane_t(const solid::HalfSpace& half, const Ray<double>& ray) {
  return (half.offset - glm::dot(half.normal, ray.origin)) / glm::dot(half.normal, ray.direction);
}

// ---- pln-in-plane

void run_in_plane(Trial& trial) {
  // Halves of cubes: the ray is in the plane that cuts the middle one.
  const UnionByStructure halves = among_others(
      [](const Vec3d& at) {
        return SolidTree(solid::Box{at - Vec3d(1), at + Vec3d(1)}) & solid::HalfSpace{{1, 1, 1}, at.x + at.y};
      },
      3);
  Random random(31);
  const auto count = trial.count(1000);
  for (std::uint64_t i = 0; i < count; ++i) {
    Vec3d normal = random_lattice_vector(random, 20);
    if (i % 4 == 0) normal = Vec3d(0, 0, 1 + random.below(5));  // across an axis
    const Vec3d point = random_lattice_vector(random, 20),
                direction = glm::cross(normal, random_lattice_vector(random, 20));
    if (direction == Vec3d(0)) continue;
    const solid::HalfSpace half{normal, glm::dot(normal, point)};
    const Ray<double> ray{point, direction};
    SolidQuestion(half, ray).ask_spans(trial, "half-space");
    SolidQuestion(~SolidTree(half), ray).ask_spans(trial, "complement of the half-space");
    const double t = naive_plane_t(half, ray);
    trial.naive("(w - n.o) / n.d").decide(!std::isnan(t), [&] {
      return Example{text_of(SolidTree(half)) + ", " + text_of(ray), "in, all along", all_digits(t)};
    });
    if (i % 16 != 0) continue;
    const Vec3d across = glm::cross(Vec3d(1), random_lattice_vector(random, 9));
    if (across == Vec3d(0)) continue;
    const Ray<double> within{-8.0 * across, across};
    SolidQuestion(halves.tree(), within).ask_spans(trial, halves);
  }
}

Sketch draw_in_plane() {
  Sketch sketch{
      "A ray in the very plane that ends a half-space. The half-space is closed: the ray is inside, all along.", {}};
  return sketch.rectangle({-4, -2}, {4, 0})
      .line({-4, 0}, {4, 0}, Role::ray)
      .line({-2, 0}, {4, 0}, Role::truth)
      .dot({-2, 0}, Role::aid)
      .label({-2.2, 0.3}, "origin")
      .label({-1, -1}, "inside, without an end")
      .label({0, 0.4}, "t = (w - n.o) / n.d = 0 / 0", Role::naive);
}

// ---- pln-graze-abs-eps

void run_graze(Trial& trial) {
  const auto ask = [&](const solid::HalfSpace& half, const Ray<double>& ray) {
    const SolidQuestion question(half, ray);
    question.ask_spans(trial, "half-space");
    const bool is_parallel = std::fabs(glm::dot(half.normal, ray.direction)) < 1e-10;
    const double t = naive_plane_t(half, ray);
    question.judge_spans(trial.naive("a miss where |n.d| < 1e-10, in double"),
                         is_parallel ? std::span<const double>() : std::span(&t, 1));
  };
  for (int k = 1; k <= 40; ++k) {
    ask({{0, 1, 0}, -1}, {{0, 0, 0}, {1, -std::pow(10.0, -k), 0}});
    ask({{0, 1, 0}, -1}, {{0, 0, 0}, {1, -1e-11 * k, 0.5}});
    // Slanted: all of n.d cancels but a last digit.
    ask({{3, -3, 1}, 7}, {{0, 0, 0}, {1, 1 - std::ldexp(1.0, -k), 0}});
  }
}

Sketch draw_graze() {
  Sketch sketch{"A ray goes down to the floor by 1e-11 a step, drawn by 1/8.", {}};
  return sketch.rectangle({-1, -1.6}, {12, -1})
      .line({0, 0}, {11, -1.375}, Role::ray)
      .dot({8, -1})
      .dot({0, 0}, Role::aid)
      .label({5, -0.2}, "true: t = 1e11", Role::truth)
      .label({0.5, 0.5}, "|n.d| < 1e-10 counts as parallel: no floor near the horizon", Role::naive);
}

// ---- pln-checker-far

using Rational = boost::multiprecision::cpp_rational;
using Integer = boost::multiprecision::cpp_int;

bool has_odd_floor(const Rational& x) {
  Integer whole = numerator(x) / denominator(x);
  if (x < Rational(whole)) --whole;
  return whole % 2 != 0;
}

/// Of unit cells, where the ray meets the floor y = 0.
bool has_odd_cell(const Ray<double>& ray) {
  const Rational t = -Rational(ray.origin.y) / Rational(ray.direction.y);
  const auto at = [&](int axis) { return Rational(ray.origin[axis]) + t * Rational(ray.direction[axis]); };
  return has_odd_floor(at(0)) != has_odd_floor(at(2));
}

const AxisPlane ground{1, 0};

Example cell_example(const Ray<double>& ray, bool is_odd) {
  return {text_of(ray), is_odd ? "odd" : "even", is_odd ? "even" : "odd"};
}

void run_checker_far(Trial& trial) {
  Random random(33);
  const auto count = trial.count(20000);
  const Checker checker;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double slope = std::pow(10.0, -4 - 2 * random.uniform_double());
    Vec3d origin = 10.0 * random_in_cube(random), direction = random_in_cube(random);
    origin.y = 0.5 + 3.5 * random.uniform_double(), direction.y = -slope;
    if (i % 8 == 0) {  // onto the edges of cells, in whole numbers
      origin = Vec3d(random.below(20), 1, random.below(20));
      direction = {std::ldexp(random.below(64), -6), -0x1p-16, std::ldexp(random.below(64), -6)};
    }
    const Ray<double> ray = ray_of_floats(origin, direction);
    const Ray<float> narrow = ray_in_float(ray);
    const bool is_odd = has_odd_cell(ray);
    const auto judge = [&](Tally& tally, bool found) {
      tally.decide(found == is_odd, [&] { return cell_example(ray, is_odd); });
    };
    if (i % 8 == 1) {  // past an edge by a last place of double
      const double ahead = 3 + random.below(5), up = 1 + random.below(9), nudge = random.below(2) ? 0x1p-52 : -0x1p-52;
      const Ray<double> beside{{random.below(1000) - ahead, up * (1 + nudge), 0.5}, {ahead / 8, -up / 8, 0}};
      const bool truth = has_odd_cell(beside);
      trial.of("checker, ray of double").decide(checker.is_odd(ground, beside) == truth, [&] {
        return cell_example(beside, truth);
      });
    }
    judge(trial.of("checker, ray of float"), checker.is_odd(ground, narrow));
    judge(trial.of("checker, ray of double"), checker.is_odd(ground, ray));

    const float t = -narrow.origin.y / narrow.direction.y;
    const Vec3f p = narrow.at(t);
    const bool naive = std::fmod(std::floor(p.x) + std::floor(p.z), 2.0f) != 0;
    judge(trial.naive("the cell of a point in float"), naive);
  }
}

Sketch draw_checker_far() {
  Sketch sketch{"A checkered floor from the side. The hit is rounded to a point that may be in the next cell.", {}};
  for (int i = 0; i < 6; ++i) sketch.rectangle({i, -0.3}, {i + 1, 0}, i % 2 ? Role::shape : Role::aid);
  return sketch.line({-1, 1.5}, {5.5, -0.3}, Role::ray)
      .dot({4.42, 0})
      .dot({5.05, 0}, Role::naive)
      .label({3.4, 0.5}, "true", Role::truth)
      .label({5, 0.3}, "as rounded, 1e6 away: 1/16 off", Role::naive);
}

// ---- pln-checker-y0

void run_checker_y0(Trial& trial) {
  Random random(34);
  const auto count = trial.count(20000);
  const Checker checker;
  for (std::uint64_t i = 0; i < count; ++i) {
    Vec3d p = 50.0 * random_in_cube(random), direction = random_in_cube(random);
    direction.y = -0.1 - 0.9 * random.uniform_double();
    const bool is_odd = std::fmod(std::floor(p.x) + std::floor(p.z), 2.0) != 0;
    const auto judge = [&](Tally& tally, bool found, bool truth) {
      tally.decide(found == truth, [&] {
        return Example{vector_text(p), truth ? "odd" : "even", found ? "odd" : "even"};
      });
    };
    for (const double zero : {0.0, -0.0}) {
      p.y = zero;
      judge(trial.of("checker, point with y = +-0"), checker.is_odd(p), is_odd);
      judge(trial.of("checker in the plane"), checker.is_odd(glm::dvec2(p.x, p.z)), is_odd);
    }
    // The ray that a camera sends, and what its plane says of it.
    const Ray<double> ray = ray_of_floats({p.x, 3.3, p.z}, direction);
    const bool is_odd_there = has_odd_cell(ray);
    for (const double zero : {0.0, -0.0}) {
      judge(trial.of("checker, ray at y = +-0"), checker.is_odd(AxisPlane{1, zero}, ray), is_odd_there);
    }
    const Ray<float> narrow = ray_in_float(ray);
    const Vec3f hit = narrow.at(-narrow.origin.y / narrow.direction.y);
    const float sum = std::floor(hit.x) + std::floor(hit.y) + std::floor(hit.z);
    judge(trial.naive("floors of x, y and z of a hit in float"), std::fmod(sum, 2.0f) != 0, is_odd_there);
  }
}

Sketch draw_checker_y0() {
  Sketch sketch{
      "Cells in space from the side, and the floor y = 0 between two layers of them. Hits are drawn as far off "
      "as the picture shows them.",
      {}};
  for (int i = 0; i < 6; ++i) {
    sketch.rectangle({i, 0}, {i + 1, 1}, i % 2 ? Role::shape : Role::aid);
    sketch.rectangle({i, -1}, {i + 1, 0}, i % 2 ? Role::aid : Role::shape);
  }
  for (int i = 0; i < 6; ++i) sketch.dot({i + 0.5, i % 3 == 1 ? -0.1 : 0.1}, i % 3 == 1 ? Role::naive : Role::truth);
  return sketch.line({-0.5, 0}, {6.5, 0}, Role::ray)
      .label({0, 1.3}, "one layer, as long as y is 0")
      .label({0, -1.5}, "y = -1e-8: the layer below, inverted speckles", Role::naive);
}

}  // namespace

std::vector<HardCase> plane_cases() {
  return {
      {.id = "pln-in-plane",
       .group = "plane",
       .inputs = "planes n.x = n.p with whole n and p, rays from p at right angles to n; also as faces of cut cubes",
       .expected = "a closed half-space has the ray inside, without an end; its complement has nothing; never NaN",
       .why =
           "n.d is 0 and so is w - n.o: their quotient is NaN, which compares with nothing. Tests for t > 0 are then "
           "false, those for t <= 0 as well, and what is drawn depends on how the comparison was written.",
       .oracle = Oracle::rationals,
       .is_policy = true,
       .run = run_in_plane,
       .draw = draw_in_plane},
      {.id = "pln-graze-abs-eps",
       .group = "plane",
       .inputs = "y <= -1, origin 0, directions (1, -10^-k, 0), k = 1 ... 40; a slanted plane, n.d = 3 2^-k",
       .expected = "hit: for (1, -1e-11, 0) at 1e11",
       .why =
           "`Parallel if |n.d| < 1e-10` has the lengths of n and d in it, and cuts the floor off before the horizon. "
           "Only n.d = 0 is parallel.",
       .oracle = Oracle::rationals,
       .reference = "POV-Ray, plane.cpp",
       .run = run_graze,
       .draw = draw_graze},
      {.id = "pln-checker-far",
       .group = "plane",
       .inputs = "rays of float from a few units above a floor of unit cells, which meet it 1e4 to 1e6 away",
       .expected = "the cell in which the ray truly meets the floor",
       .why =
           "At 1e6 floats are 1/16 apart: the point is rounded into the next cell for one ray in sixty, and edges of "
           "cells fray. No point needs to stand between: the cell follows from the ray's own numbers.",
       .oracle = Oracle::rationals,
       .run = run_checker_far,
       .draw = draw_checker_far},
      {.id = "pln-checker-y0",
       .group = "plane",
       .inputs = "points with y = +0 and -0 and rays to the floor y = 0, in a checker of unit cells in space",
       .expected = "one layer: the parity of floor(x) + floor(z)",
       .why =
           "The floor lies between two layers of cells. A hit whose y is rounded to -1e-8 has floor -1 and the other "
           "color; a floor -0 <= y makes no difference where the plane says that y is 0.",
       .oracle = Oracle::closed_form,
       .run = run_checker_y0,
       .draw = draw_checker_y0},
  };
}

}  // namespace sightline::hard
