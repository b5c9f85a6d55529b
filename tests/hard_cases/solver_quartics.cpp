/// Quartics whose roots fall together, or almost.

#include <cmath>

#include "tests/hard_cases/graph_sketch.h"
#include "tests/hard_cases/solver_parts.h"
#include "tests/hard_cases/solver_question.h"
#include "tests/hard_cases/torus_question.h"

namespace sightline::hard {
namespace {

void ask(Trial& trial, const Quartic& quartic) { judge_ferrari(trial, ask_quartic(trial, quartic), quartic); }

/// (m x - n)^2 ((m x - n)^2 - e m^2), exact for small whole numbers.
Quartic around(double m, double n, double e) {
  const double a = m * m, b = -2 * m * n, c = n * n, f = c - e * a;
  return {a * a, 2 * a * b, a * f + b * b + a * c, b * f + b * c, c * f};
}

void run_quadruple(Trial& trial) {
  ask(trial, around(1, 10, 0));
  Random random(5);
  for (std::uint64_t i = 0, count = trial.count(200); i < count; ++i) {
    ask(trial, around(1 + random.below(99), double(random.below(199)) - 99, 0));
  }
}

Sketch draw_quadruple() {
  Sketch sketch{"(x - 10)^4: flat as a table. In double it is less than its rounding error for 9.999 < x < 10.001.",
                {}};
  return draw_graph(
             sketch, [](double x) { return std::pow(x - 10, 4); }, 8.7, 11.3, 2)
      .dot({10, 0})
      .rectangle({9.6, -0.05}, {10.4, 0.05}, Role::naive)
      .label({9.6, 0.25}, "10, four times")
      .label({8.8, -0.3}, "below its rounding errors: 0 to 4 roots", Role::naive);
}

void run_double_sign(Trial& trial) {
  ask(trial, around(1, 10, 8));
  Random random(6);
  for (std::uint64_t i = 0, count = trial.count(200); i < count; ++i) {
    ask(trial, around(1 + random.below(40), double(random.below(199)) - 99, 1 + random.below(30)));
    // (x - a)^2 (x - b) (x - c), whole numbers.
    const double a = double(random.below(41)) - 20, b = double(random.below(41)) - 20,
                 c = double(random.below(41)) - 20;
    const double p = -2 * a, q = a * a, s = -(b + c), r = b * c;
    ask(trial, {1, p + s, q + p * s + r, q * s + p * r, q * r});
  }
}

Sketch draw_double_sign() {
  Sketch sketch{"(x - 10)^2 ((x - 10)^2 - 8), drawn at a sixteenth of its height.", {}};
  return draw_graph(
             sketch, [](double x) { return std::pow(x - 10, 2) * (std::pow(x - 10, 2) - 8) / 16; }, 6.8, 13.2, 2)
      .dot({7.1716, 0})
      .dot({10, 0})
      .dot({12.8284, 0})
      .label({6.9, 0.3}, "7.1716")
      .label({9.4, 0.3}, "10, twice")
      .label({12.4, 0.3}, "12.8284")
      .label({8.8, -1.4}, "lost, or two, or -10 by a wrong sign", Role::naive);
}

void run_near_biquadratic(Trial& trial) {
  const Torus ring{Vec3d(0), {0, 0, 1}, 2, 1};
  Random random(7);
  for (std::uint64_t i = 0, count = trial.count(150); i < count; ++i) {
    // Across a radius, and 2^-k off that.
    const double off = i % 4 == 0 ? 0 : std::ldexp(i % 2 ? 1.0 : -1.0, -4 - static_cast<int>(random.below(44)));
    const Vec3d foot(1 + 2.5 * random.uniform_double(), 0, random.uniform_double() - 0.5);
    const double back = double(random.below(8));
    const Vec3d way(off, 1, 0);
    const TorusQuestion question({ring, {foot - back * way, way}});
    question.ask(trial);
    const std::array<double, 5> c = question.naive_polynomial();
    ask(trial, {c[4], c[3], c[2], c[1], c[0]});
  }
}

Sketch draw_near_biquadratic() {
  Sketch sketch{"A torus from above, and a line almost at right angles to a radius.", {}};
  return sketch.circle({0, 0}, 3)
      .circle({0, 0}, 1)
      .line({0, 0}, {2, 0}, Role::aid)
      .line({1.8, -4}, {2.2, 4}, Role::ray)
      .dot({1.88, -2.34})
      .dot({2.11, 2.13})
      .label({2.3, 0.2}, "f is almost even in t: q = 0 + noise")
      .label({2.3, -0.4}, "q / sqrt(z) = noise / noise", Role::naive);
}

}  // namespace

HardCase quartic_quadruple() {
  return {
      .id = "quartic-quadruple",
      .group = "solver",
      .inputs = "(x - 10)^4, multiplied out; and (m x - n)^4 for whole m, n up to 99",
      .expected = "10, with multiplicity 4",
      .why =
          "Ferrari's p, q and r are all 0, and so is the root of the resolvent cubic that it divides by. A solver that "
          "asks for z > 0 finds nothing; one whose p, q, r have been rounded finds anything near 10.",
      .oracle = Oracle::sturm_chains,
      .reference = "POV-Ray, polynomialsolver.cpp",
      .run = run_quadruple,
      .draw = draw_quadruple};
}

HardCase quartic_double_sign() {
  return {
      .id = "quartic-double-sign",
      .group = "solver",
      .inputs =
          "(x - 10)^2 ((x - 10)^2 - 8); (m x - n)^2 ((m x - n)^2 - e m^2); (x - a)^2 (x - b) (x - c); whole numbers",
      .expected = "7.1716, 10 twice, 12.8284; and as the factors say",
      .why =
          "A double root between two simple ones is where two quadratics share a root, or where a discriminant is 0: "
          "rounding decides. And branches for special cases are seldom run: a wrong sign in one makes -10 of 10.",
      .oracle = Oracle::sturm_chains,
      .reference = "POV-Ray, polynomialsolver.cpp, solve_quartic",
      .run = run_double_sign,
      .draw = draw_double_sign};
}

HardCase quartic_near_biquadratic() {
  return {
      .id = "quartic-near-biquadratic",
      .group = "solver",
      .inputs =
          "tori of radii 2 and 1, and lines across a radius, to within 2^-4 ... 2^-47; and their polynomials in double",
      .expected = "0, 2 or 4 roots, as the exact polynomial says",
      .why =
          "By symmetry the odd term is almost 0: q is noise, the resolvent has a root near 0, which is noise, and "
          "Ferrari divides one by the root of the other. Many rays of a picture are like that: all that look at "
          "the middle of a torus.",
      .oracle = Oracle::sturm_chains,
      .run = run_near_biquadratic,
      .draw = draw_near_biquadratic};
}

}  // namespace sightline::hard
