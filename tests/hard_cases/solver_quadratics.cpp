/// Quadratics.

#include <array>
#include <cmath>

#include "tests/hard_cases/graph_sketch.h"
#include "tests/hard_cases/solver_parts.h"
#include "tests/hard_cases/solver_question.h"

namespace sightline::hard {
namespace {

void ask(Trial& trial, const Quadratic& quadratic) {
  ask_quadratic(trial, quadratic);
  judge_school(trial, quadratic);
}

void run_cancel(Trial& trial) {
  ask(trial, {1, -1e8, 1});
  Random random(1);
  for (std::uint64_t i = 0, count = trial.count(600); i < count; ++i) {
    const double b = std::pow(10.0, 1 + 15 * random.uniform_double());
    ask(trial, {1 + random.uniform_double(), i % 2 ? b : -b, i % 3 ? 1 : -1.5});
  }
}

Sketch draw_cancel() {
  Sketch sketch{"x^2 - b x + 1, drawn with b = 4: one root near 0, the other one near b. In the case b is 10^8.", {}};
  return draw_graph(
             sketch, [](double x) { return x * x - 4 * x + 1; }, -0.5, 4.5, 4)
      .dot({0.2679, 0})
      .dot({3.7321, 0})
      .label({0.3, 0.3}, "c / q: 1.0000000000000001e-8")
      .label({0.3, -0.9}, "b - sqrt(b b - 4): 7.45e-9", Role::naive);
}

void run_kahan(Trial& trial) {
  ask(trial, {94906265.625, -189812534, 94906268.375});
  Random random(2);
  for (std::uint64_t i = 0, count = trial.count(600); i < count; ++i) {
    // (k x - m) (l x - n) with roots some 2^-52 apart, its coefficients exact in 53 bits.
    const double k = 0x1p25 + random.below(1u << 24), m = k + 1 + random.below(8);
    const double l = k - 1 - random.below(8), n = m - (k - l) - (i % 3);
    ask(trial, {k * l, -(k * n + l * m), m * n});
  }
}

Sketch draw_kahan() {
  Sketch sketch{"A parabola that dips below 0 by one part in 10^16; drawn by a quarter.", {}};
  return draw_graph(
             sketch, [](double x) { return x * x - 0.25; }, -2, 2, 3)
      .dot({-0.5, 0})
      .dot({0.5, 0})
      .dot({0, 0}, Role::naive)
      .label({-1.2, -0.35}, "1")
      .label({0.6, -0.35}, "1.0000000289759583")
      .label({-0.9, 0.3}, "b b = 4 a c, as rounded: twice the middle", Role::naive);
}

void run_overflow(Trial& trial) {
  for (const double scale : {1e200, 1e-200}) ask(trial, {scale, -3 * scale, 2 * scale});
  Random random(3);
  for (std::uint64_t i = 0, count = trial.count(600); i < count; ++i) {
    // Powers of two for the coefficients, and for the roots; not so large that these would not be doubles.
    const int size = static_cast<int>(random.below(1400)) - 700, unit = static_cast<int>(random.below(200)) - 100;
    const Quadratic k{double(1 + random.below(9)), double(random.below(99)) - 49, double(random.below(99)) - 49};
    ask(trial, {std::ldexp(k[0], size - unit), std::ldexp(k[1], size), std::ldexp(k[2], size + unit)});
  }
}

Sketch draw_overflow() {
  Sketch sketch{"x^2 - 3 x + 2, and 10^200 times as much: the same roots.", {}};
  return draw_graph(
             sketch, [](double x) { return x * x - 3 * x + 2; }, 0, 3, 2)
      .dot({1, 0})
      .dot({2, 0})
      .label({0.8, -0.4}, "1")
      .label({2.1, -0.4}, "2")
      .label({0.6, 1.2}, "b b = inf: none; b b = 0: 1.5 twice", Role::naive);
}

void run_linear_limit(Trial& trial) {
  ask(trial, {1e-30, -1, 1});
  ask(trial, {0, -1, 1});
  Random random(4);
  for (std::uint64_t i = 0, count = trial.count(600); i < count; ++i) {
    const double a = i % 8 == 0 ? 0 : (i % 2 ? 1 : -1) * std::pow(10.0, -10 - 60 * random.uniform_double());
    ask(trial, {a, 4 * random.uniform_double() - 2, 4 * random.uniform_double() - 2});
  }
}

Sketch draw_linear_limit() {
  Sketch sketch{"a x^2 - x + 1 for a = 1/8, 1/32 and 0: the near root stays, the far one leaves to infinity.", {}};
  for (const double a : {0.125, 0.03125, 0.0}) {
    draw_graph(
        sketch, [a](double x) { return a * x * x - x + 1; }, -1, 8, 2);
  }
  return sketch.dot({1, 0})
      .dot({1.172, 0})
      .dot({6.828, 0})
      .label({0.2, -0.6}, "1")
      .label({2.2, 1}, "a = 1e-30: (1 - 1) / 2e-30 = 0; a = 0: 0 / 0", Role::naive);
}

}  // namespace

HardCase quadratic_cancel() {
  return {.id = "quad-cancel",
          .group = "solver",
          .inputs = "x^2 - 1e8 x + 1, in double; and random b from 10 to 1e16",
          .expected = "1.0000000000000001e-8 and 99999999.99999999",
          .why =
              "sqrt(b b - 4) is b but for its last bit, and b less that is what rounding has left: all digits of the "
              "small root cancel. q = -(b + sign(b) root) adds instead; the roots are q / a and c / q.",
          .oracle = Oracle::sturm_chains,
          .reference =
              "Kahan, On the Cost of Floating-Point Computation Without Extra-Precise Arithmetic, 2004; pbrt, "
              "Quadratic()",
          .run = run_cancel,
          .draw = draw_cancel};
}

HardCase quadratic_kahan() {
  return {
      .id = "quad-kahan-disc",
      .group = "solver",
      .inputs = "94906265.625 x^2 - 189812534 x + 94906268.375; and random (k x - m) (l x - n) with close roots",
      .expected = "1 and 1.0000000289759583",
      .why =
          "b b and 4 a c need 106 bits and agree in the first 53. Rounded, their difference is 0, and two roots are "
          "one, wrong from the eighth digit on. Two fused multiply-adds give the difference with one rounding.",
      .oracle = Oracle::sturm_chains,
      .reference = "Kahan, 2004; Jeannerod, Louvet and Muller, 2013",
      .run = run_kahan,
      .draw = draw_kahan};
}

HardCase quadratic_overflow() {
  return {
      .id = "quad-overflow",
      .group = "solver",
      .inputs =
          "1e200 (x^2 - 3 x + 2) and 1e-200 of it; random whole ones times 2^-700 ... 2^700, x times 2^-100 ... 2^100",
      .expected = "1 and 2, but for the rounding of the coefficients",
      .why =
          "b b is 1e400, which is infinite, or 1e-400, which is 0. Neither the roots nor the coefficients are extreme, "
          "only what is computed on the way. Powers of two bring it into range without rounding.",
      .oracle = Oracle::sturm_chains,
      .run = run_overflow,
      .draw = draw_overflow};
}

HardCase quadratic_linear_limit() {
  return {.id = "quad-linear-limit",
          .group = "solver",
          .inputs = "1e-30 x^2 - x + 1, and with a = 0; random a from 1e-10 to 1e-70, and 0",
          .expected = "1, and 1e30 where a is not 0",
          .why =
              "The formula from school takes 1 - 1 and divides it by 2e-30: 0. With a = 0 it is 0 / 0. A ray that is "
              "parallel to "
              "a cone's side, or to a cylinder's axis, has just this polynomial.",
          .oracle = Oracle::sturm_chains,
          .reference = "mitsuba, math.h",
          .run = run_linear_limit,
          .draw = draw_linear_limit};
}

}  // namespace sightline::hard
