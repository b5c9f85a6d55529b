/// Tori far away, thin, through themselves, and left by a ray that starts on them.

#include <algorithm>

#include "tests/hard_cases/naive_quartic.h"
#include "tests/hard_cases/naive_sphere.h"
#include "tests/hard_cases/random_vectors.h"
#include "tests/hard_cases/torus_parts.h"
#include "tests/hard_cases/torus_question.h"

namespace sightline::hard {
namespace {

const Vec3d z{0, 0, 1};
const Torus ring{Vec3d(0), z, 2, 1};

void ask_ferrari(Trial& trial, const TorusQuestion& question) {
  question.roots().judge_naive(trial.naive("Ferrari's way, in double"),
                               naive_quartic_roots<double>(question.naive_polynomial()));
}

// ---- tor-far

void run_far(Trial& trial) {
  TorusQuestion({ring, {{-0x1p14, 0.5, 0.25}, {1, 0, 0}}}).ask_structures(trial, {0, 0, 9});
  Random random(111);
  const auto count = trial.count(100);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double far = i == 0 ? 0x1p14 : std::ldexp(1.0, 8 + static_cast<int>(random.below(32)));
    const Vec3d aside = i == 0 ? Vec3d(0) : 0.25 * random_in_cube(random);
    const TorusQuestion question({ring, {{-far, 0.5 + aside.y, 0.25 + aside.z}, {1, 0, 0}}});
    question.ask(trial);
    ask_ferrari(trial, question);
    // From anywhere, to a point in the ring.
    const Vec3d eye = far * random_on_sphere(random), target = Vec3d(2, 0, 0) + 0.5 * random_in_cube(random);
    TorusQuestion({ring, {eye, (target - eye) / far}}).ask(trial);
  }
}

Sketch draw_far() {
  Sketch sketch{"A torus, cut along its axis, and a ray from 16384 away; drawn from 9 away.", {}};
  return sketch.circle({-2, 0}, 1)
      .circle({2, 0}, 1)
      .line({-9, 0.25}, {4, 0.25}, Role::ray)
      .dot({-2.9219, 0.25})
      .dot({-1.1, 0.25})
      .dot({1.1, 0.25})
      .dot({2.9219, 0.25})
      .label({-8.8, 0.6}, "|o|^4 = 2^56: its last place is 16, and the torus is 1", Role::naive)
      .label({-8.8, -0.4}, "seen from a point of the ray near the torus, nothing is lost", Role::truth);
}

// ---- tor-thin

void run_thin(Trial& trial) {
  TorusQuestion({{Vec3d(0), z, 1, 0x1p-20}, {{-3, 0, 0}, {1, 0, 0}}}).ask_structures(trial, {0, 0, 9});
  Random random(112);
  const auto count = trial.count(100);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double minor = i < 2 ? 0x1p-20 : std::ldexp(1.0, -10 - static_cast<int>(random.below(20)));
    const Torus thin{Vec3d(0), z, 1, minor};
    // Through the wire on both sides; on one; and just past it.
    const TorusQuestion both({thin, {{-3, 0, i < 2 ? 0 : minor * random.uniform_double()}, {1, 0, 0}}});
    both.ask(trial);
    ask_ferrari(trial, both);
    const double angle = 6.28 * random.uniform_double();
    const Vec3d wire(std::cos(angle), std::sin(angle), 0), way = random_on_sphere(random);
    TorusQuestion({thin, {wire - 3.0 * way, way}}).ask(trial);
    const double side = (i % 2 ? 1 : -1) * std::ldexp(1.0, -static_cast<int>(random.below(20)));
    TorusQuestion({thin, {{1 + minor * (1 + side), 0, -3}, {0, 0, 1}}}).ask(trial);
  }
}

Sketch draw_thin() {
  Sketch sketch{"A torus like a wire, cut along its axis; the wire is 2^-20 thick, drawn 1/16.", {}};
  return sketch.circle({-1, 0}, 0.0625)
      .circle({1, 0}, 0.0625)
      .line({-3, 0}, {2, 0}, Role::ray)
      .line({1.04, -1}, {1.04, 1}, Role::ray)
      .dot({-1.0625, 0})
      .dot({-0.9375, 0})
      .dot({0.9375, 0})
      .dot({1.0625, 0})
      .label({-2.9, 0.2}, "pairs of roots 2^-19 apart, as if double", Role::naive);
}

// ---- tor-horn-spindle

void run_horn_spindle(Trial& trial) {
  const Torus horn{Vec3d(0), z, 1, 1}, spindle{Vec3d(0), z, 3, 5}, wide{Vec3d(0), z, 1, 2};
  const TorusAndRay given[] = {{horn, {{-3, 0, 0}, {1, 0, 0}}},    {horn, {{0, 0, -3}, {0, 0, 1}}},
                               {spindle, {{0, 0, -6}, {0, 0, 1}}}, {wide, {{-4, 0, 0}, {1, 0, 0}}},
                               {spindle, {{-9, 0, 0}, {1, 0, 0}}}, {spindle, {{-9, 0, 4}, {1, 0, 0}}},
                               {horn, {{-2, -2, -1}, {2, 2, 1}}},  {spindle, {{0, 1, -7}, {0, 0, 1}}}};
  Random random(113);
  const auto count = trial.count(140);
  for (std::uint64_t i = 0; i < std::max<std::uint64_t>(count, std::size(given)); ++i) {
    const TorusAndRay& one = given[i % std::size(given)];
    const TorusQuestion question(i < std::size(given) ? one : varied(one, random));
    question.ask(trial);
    ask_ferrari(trial, question);
  }
  TorusQuestion(given[3]).ask_structures(trial, {0, 0, 9});
  for (std::uint64_t i = 0; i < count; ++i) {
    const Torus any{random_in_cube(random), random_on_sphere(random), random.uniform_double(), 1};
    const Vec3d eye = 4.0 * random_on_sphere(random);
    TorusQuestion({any, {eye, any.center + 0.5 * random_in_cube(random) - eye}}).ask(trial);
  }
}

Sketch draw_horn_spindle() {
  Sketch sketch{"A spindle, radii 3 and 5, cut along its axis. The lens in the middle counts as hollow.", {}};
  return sketch.circle({-3, 0}, 5)
      .circle({3, 0}, 5)
      .line({0, -6}, {0, 6}, Role::ray)
      .line({-9.5, 0}, {9.5, 0}, Role::ray)
      .dot({0, -4})
      .dot({0, 4})
      .dot({-8, 0})
      .dot({-2, 0})
      .dot({2, 0})
      .dot({8, 0})
      .label({0.3, 4.6}, "along the axis two touches, twice each")
      .label({-1.7, 0.3}, "hollow")
      .label({-9, -5.5}, "as R - r < 0: a hole of negative radius", Role::naive);
}

// ---- tor-root-elim

void run_root_elimination(Trial& trial) {
  Random random(114);
  const auto count = trial.count(200);
  for (std::uint64_t i = 0; i < count; ++i) {
    // Just inside the outer, or the inner equator: the way out is near, however near.
    const double near = std::ldexp(1.0, -14 - static_cast<int>(random.below(36)));
    const bool is_outer = i % 2 == 0;
    const TorusAndRay given{ring, {{is_outer ? 3 - near : 1 + near, 0, 0}, {is_outer ? 1.0 : -1.0, 0, 0}}};
    const TorusQuestion question(i < 2 ? given : TorusAndRay{ring, {given.ray.origin, given.ray.direction * 8.0}});
    question.ask(trial);
    std::vector<double> found;
    for (const auto& root : question.roots().roots()) {
      if (std::fabs(root.nearest) > 1e-4) found.push_back(root.nearest);
    }
    question.solid().judge_first(trial.naive("true roots, without those below 1e-4"), first_root_ahead(found));
  }
}

Sketch draw_root_elimination() {
  Sketch sketch{"A torus, cut along its axis, and a ray from 2^-14 and less inside; drawn from 1/8 inside.", {}};
  return sketch.circle({-2, 0}, 1)
      .circle({2, 0}, 1)
      .line({2.875, 0}, {4.5, 0}, Role::ray)
      .dot({3, 0})
      .dot({2.875, 0}, Role::aid)
      .label({3.1, 0.2}, "the way out, at t = 2^-14")
      .label({3.1, -0.4}, "below 1e-4: taken for noise, and dropped", Role::naive);
}

}  // namespace

HardCase torus_far() {
  return {
      .id = "tor-far",
      .group = "torus",
      .inputs = "radii 2 and 1; o = (-2^14, 1/2, 1/4), d = (1, 0, 0), and random rays from 2^8 to 2^39 away",
      .expected = "16381.0183..., and the other three, as near as a double can tell them",
      .why =
          "The constant term is of the size of |o|^4, and what the torus adds to it is below its last place. The "
          "same polynomial from a point of the ray near the torus has small coefficients; adding the way there back to "
          "the roots costs one rounding.",
      .oracle = Oracle::sturm_chains,
      .reference = "POV-Ray, issue 358",
      .run = run_far,
      .draw = draw_far};
}

HardCase torus_thin() {
  return {.id = "tor-thin",
          .group = "torus",
          .inputs = "major radius 1, minor 2^-20, and 2^-10 to 2^-29; rays through the wire, and to its edge",
          .expected = "pairs of roots as far apart as the wire is thick; none past its edge",
          .why =
              "Both roots of a pair agree in 20 bits and more, so their difference is lost where coefficients have "
              "been rounded: R^2 - r^2 is R^2 but for a few bits. Wires vanish in places, and come back as dots.",
          .oracle = Oracle::sturm_chains,
          .run = run_thin,
          .draw = draw_thin};
}

HardCase torus_horn_spindle() {
  return {
      .id = "tor-horn-spindle",
      .group = "torus",
      .inputs =
          "radii 1 and 1, 3 and 5, 1 and 2; rays along the axis, across it and through the points where the surface "
          "meets itself; random R < r",
      .expected = "all roots of the polynomial; inside is where it is negative, so that the lens is hollow",
      .why =
          "Bounds like R - r are negative here, and square roots of them NaN. Where the surface meets itself on the "
          "axis its roots are double or quadruple for each line, not just for tangents.",
      .oracle = Oracle::sturm_chains,
      .is_policy = true,
      .run = run_horn_spindle,
      .draw = draw_horn_spindle};
}

HardCase torus_root_elimination() {
  return {
      .id = "tor-root-elim",
      .group = "torus",
      .inputs = "radii 2 and 1; rays from 2^-14 to 2^-49 inside the surface, straight out",
      .expected = "the near root is the first boundary, however small its t",
      .why =
          "Small roots are dropped as noise, or as the surface that the ray has just left. Which of these they are, "
          "their size does not tell: a ray inside the solid loses its way out, and goes on to the far side of "
          "the ring.",
      .oracle = Oracle::sturm_chains,
      .reference = "POV-Ray, torus.cpp, ROOT_TOLERANCE",
      .run = run_root_elimination,
      .draw = draw_root_elimination};
}

}  // namespace sightline::hard
