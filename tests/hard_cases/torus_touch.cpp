/// Lines that touch tori, in whole numbers, so that they touch exactly.

#include "tests/hard_cases/naive_quartic.h"
#include "tests/hard_cases/torus_parts.h"
#include "tests/hard_cases/torus_question.h"

namespace sightline::hard {
namespace {

const Vec3d z{0, 0, 1};
const Torus ring{Vec3d(0), z, 2, 1};

/// The case itself by all structures; itself, and in other places, sizes and directions; and beside it by 2^-k, where
/// the touch falls apart into two roots, or none.
void run_touching(Trial& trial, const TorusAndRay& given, const Vec3d& apart, std::uint64_t seed) {
  TorusQuestion(given).ask_structures(trial, apart);
  Random random(seed);
  const auto count = trial.count(100);
  for (std::uint64_t i = 0; i < count; ++i) {
    const TorusAndRay one = i == 0 ? given : varied(given, random);
    const TorusQuestion question(one);
    question.ask(trial);
    const RootQuestion& roots = question.roots();
    roots.judge_naive(trial.naive("Ferrari's way, in double"),
                      naive_quartic_roots<double>(question.naive_polynomial()));
    roots.judge_naive(trial.naive("Ferrari's way, in float"), naive_quartic_roots<float>(question.naive_polynomial()));
    TorusAndRay beside = one;
    beside.ray.origin[static_cast<int>(random.below(3))] +=
        std::ldexp(i % 2 ? 1.0 : -1.0, -4 - static_cast<int>(random.below(38)));
    TorusQuestion(beside).solid().ask_spans(trial, "torus beside the ray");
  }
}

/// The ring cut along its axis: x to the right, z up.
Sketch& draw_cut(Sketch& sketch, double major, double minor) {
  return sketch.circle({-major, 0}, minor)
      .circle({major, 0}, minor)
      .line({0, -minor - 0.5}, {0, minor + 0.5}, Role::aid);
}
/// The ring from above.
Sketch& draw_plan(Sketch& sketch, double major, double minor) {
  return sketch.circle({0, 0}, major + minor).circle({0, 0}, major - minor).circle({0, 0}, major, Role::aid);
}

void run_quadruple(Trial& trial) { run_touching(trial, {ring, {{-10, 2, 1}, {1, 0, 0}}}, {0, 0, 9}, 101); }
Sketch draw_quadruple() {
  Sketch sketch{"The top of a torus from above, and the line at its height that touches the circle of its crest.", {}};
  return draw_plan(sketch, 2, 1)
      .line({-4, 2}, {4, 2}, Role::ray)
      .dot({0, 2})
      .label({0.1, 2.2}, "10, four times")
      .label({-4, 1.5}, "in float 0 to 4 roots", Role::naive);
}

void run_crest(Trial& trial) { run_touching(trial, {ring, {{-10, 0, 1}, {1, 0, 0}}}, {0, 9, 0}, 102); }
Sketch draw_crest() {
  Sketch sketch{"A torus, cut along its axis, and a line that lies on top of it.", {}};
  return draw_cut(sketch, 2, 1)
      .line({-4, 1}, {4, 1}, Role::ray)
      .dot({-2, 1})
      .dot({2, 1})
      .label({-2.2, 1.2}, "8, twice")
      .label({1.8, 1.2}, "12, twice")
      .label({-0.9, -1.2}, "no change of sign: bracketing finds nothing, or noise", Role::naive);
}

void run_equator(Trial& trial) { run_touching(trial, {ring, {{3, -10, 0}, {0, 1, 0}}}, {0, 0, 9}, 103); }
Sketch draw_equator() {
  Sketch sketch{"A torus from above, and a line that touches its outer equator.", {}};
  return draw_plan(sketch, 2, 1)
      .line({3, -4}, {3, 4}, Role::ray)
      .dot({3, 0})
      .label({3.1, 0.1}, "10, twice")
      .label({3.1, -1}, "two complex roots beside it", Role::naive);
}

void run_inner(Trial& trial) { run_touching(trial, {ring, {{1, -10, 0}, {0, 1, 0}}}, {0, 0, 9}, 104); }
Sketch draw_inner() {
  Sketch sketch{"A torus from above, and a line that touches its inner equator, from within the ring.", {}};
  return draw_plan(sketch, 2, 1)
      .line({1, -4}, {1, 4}, Role::ray)
      .dot({1, -2.828})
      .dot({1, 0})
      .dot({1, 2.828})
      .label({1.2, -2.9}, "7.17157")
      .label({1.1, 0.1}, "10, twice: still inside")
      .label({1.2, 2.9}, "12.82843");
}

void run_villarceau(Trial& trial) {
  run_touching(trial, {{Vec3d(0), z, 5, 3}, {{-16, 0, -12}, {4, 0, 3}}}, {0, 30, 0}, 105);
}
Sketch draw_villarceau() {
  Sketch sketch{"A torus of radii 5 and 3, cut along its axis, and the line that touches both of its circles.", {}};
  return draw_cut(sketch, 5, 3)
      .line({-10, -7.5}, {10, 7.5}, Role::ray)
      .dot({-3.2, -2.4})
      .dot({3.2, 2.4})
      .label({-3, -3.2}, "3.2, twice")
      .label({2.2, 3.4}, "4.8, twice")
      .label({-9, 3.5}, "the plane through it cuts two circles, those of Villarceau");
}

}  // namespace

HardCase torus_quadruple() {
  return {
      .id = "tor-quadruple",
      .group = "torus",
      .inputs = "radii 2 and 1; o = (-10, 2, 1), d = (1, 0, 0); the same moved, scaled, turned; and 2^-k beside it",
      .expected = "10, with multiplicity 4: touched, not entered",
      .why =
          "Near a quadruple root f is the fourth power of the distance: an error of u in f moves it by the fourth root "
          "of u, 1/100 in float, 1/10000 in double, and makes 0, 2 or 4 roots of it. How many there are, "
          "rounded coefficients do not know.",
      .oracle = Oracle::sturm_chains,
      .run = run_quadruple,
      .draw = draw_quadruple};
}

HardCase torus_crest() {
  return {.id = "tor-crest",
          .group = "torus",
          .inputs = "radii 2 and 1; o = (-10, 0, 1), d = (1, 0, 0); the same moved, scaled, turned; and 2^-k beside it",
          .expected = "8 and 12, each twice",
          .why =
              "Two touches: f never changes its sign, so signs at steps find nothing, and rounding makes three or four "
              "roots of it. Ferrari's way takes square roots of what ought to be 0.",
          .oracle = Oracle::sturm_chains,
          .run = run_crest,
          .draw = draw_crest};
}

HardCase torus_equator() {
  return {
      .id = "tor-equator",
      .group = "torus",
      .inputs = "radii 2 and 1; o = (3, -10, 0), d = (0, 1, 0); the same moved, scaled, turned; and 2^-k beside it",
      .expected = "10, twice",
      .why =
          "One real root, twice, and two complex ones: a discriminant of 0, which rounding makes positive or negative. "
          "The silhouette of each torus is made of such lines.",
      .oracle = Oracle::sturm_chains,
      .run = run_equator,
      .draw = draw_equator};
}

HardCase torus_inner() {
  return {
      .id = "tor-inner",
      .group = "torus",
      .inputs = "radii 2 and 1; o = (1, -10, 0), d = (0, 1, 0); the same moved, scaled, turned; and 2^-k beside it",
      .expected = "10 - sqrt 8, 10 twice, 10 + sqrt 8: one span",
      .why =
          "The line grazes the hole from within. A solver that loses the pair in the middle is right by luck, one that "
          "finds it once makes an odd number of crossings: the ray goes in and never comes out.",
      .oracle = Oracle::sturm_chains,
      .run = run_inner,
      .draw = draw_inner};
}

HardCase torus_villarceau() {
  return {
      .id = "tor-villarceau",
      .group = "torus",
      .inputs = "radii 5 and 3; o = (-16, 0, -12), d = (4, 0, 3); the same moved, scaled, turned; and 2^-k beside it",
      .expected = "3.2 and 4.8, each twice",
      .why =
          "The line of slope 3 / 4 touches both circles of the cut, and no root is a double: nothing cancels by luck, "
          "as "
          "it does for lines along an axis. Ferrari's discriminants are noise, and half of it is below 0: no "
          "roots at all.",
      .oracle = Oracle::sturm_chains,
      .run = run_villarceau,
      .draw = draw_villarceau};
}

}  // namespace sightline::hard
