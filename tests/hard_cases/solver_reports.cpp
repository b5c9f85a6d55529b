/// Quartics from reports on other programs.

#include <cmath>

#include "tests/hard_cases/graph_sketch.h"
#include "tests/hard_cases/naive_quartic.h"
#include "tests/hard_cases/solver_parts.h"
#include "tests/hard_cases/solver_question.h"

namespace sightline::hard {
namespace {

constexpr Quartic mixed_scale{1, -1000000.001, 1002, -2, .001};
constexpr Quartic diagrams{1, -240, 25449, -1325880, 26471900.25};
constexpr Quartic celeritas{1, 19.534611, -48660.891842, -476217.617178, 57126150.652217};
constexpr Quartic rpoly{1, -198.995, 15006.6, -508127, 6.52025e6};

double value(const Quartic& k, double x) {
  double sum = 0;
  for (const double c : k) sum = sum * x + c;
  return sum;
}

/// As reported, and with coefficients a few ulps off.
template <class JudgeNaive>
void run_reported(Trial& trial, const Quartic& reported, std::uint64_t seed, JudgeNaive&& judge_naive) {
  Random random(seed);
  for (std::uint64_t i = 0, count = trial.count(200); i < count; ++i) {
    const Quartic k = i == 0 ? reported : nudged(reported, random);
    judge_naive(ask_quartic(trial, k), k);
  }
}

void run_mixed_scale(Trial& trial) {
  run_reported(trial, mixed_scale, 8, [&](const RootQuestion& q, const Quartic& k) { judge_ferrari(trial, q, k); });
}

Sketch draw_mixed_scale() {
  Sketch sketch{"The near root of the polynomial, x in units of 10^-4; the other one is a million, 10^10 units away.",
                {}};
  return draw_graph(
             sketch, [](double x) { return 5000 * value(mixed_scale, x * 1e-4); }, 0, 12, 5)
      .dot({5.70195, 0})
      .dot({3.34, 0}, Role::naive)
      .label({5.9, 0.5}, "5.70194700491e-4")
      .label({1.2, -0.9}, "Ferrari: 3.34e-4", Role::naive);
}

void run_diagrams(Trial& trial) {
  run_reported(trial, diagrams, 9, [&](const RootQuestion& q, const Quartic& k) { judge_ferrari(trial, q, k); });
}

Sketch draw_diagrams() {
  Sketch sketch{"The polynomial, its height divided by 30000: it is even around x = 60.", {}};
  return draw_graph(
             sketch, [](double x) { return value(diagrams, x) / 3e4; }, 44, 76, 14)
      .dot({50.6451, 0})
      .dot({69.3549, 0})
      .label({47, 1.5}, "50.645112696944665")
      .label({66, 1.5}, "69.35488730305534")
      .label({52, -13}, "q = 0 but for noise: no root of the resolvent, or none that a tolerance lets pass",
             Role::naive);
}

void run_celeritas(Trial& trial) {
  run_reported(trial, celeritas, 10, [&](const RootQuestion& question, const Quartic& k) {
    question.judge_naive(trial.naive("Ferrari's way, by the lowest root of the resolvent"),
                         naive_quartic_roots<double, 0>({k[4], k[3], k[2], k[1], k[0]}));
  });
}

Sketch draw_celeritas() {
  Sketch sketch{"The polynomial, its height divided by 2000000: four simple roots, far apart.", {}};
  sketch = draw_graph(
      sketch, [](double x) { return value(celeritas, x) / 2e6; }, -240, 230, 300);
  for (const double root : {-223.0095, -39.8853, 30.1180, 213.2422}) sketch.dot({root, 0});
  return sketch.label({-225, 20}, "-223.0")
      .label({-75, 20}, "-39.9")
      .label({30, 20}, "30.1")
      .label({190, 20}, "213.2")
      .label({-150, -200}, "by the lowest root of the resolvent, 1e-8: off by a quarter", Role::naive);
}

/// Newton's steps, and where they end: never none.
double newton(const Quartic& k, double x) {
  for (int step = 0; step < 50; ++step) {
    const double slope = ((4 * k[0] * x + 3 * k[1]) * x + 2 * k[2]) * x + k[3];
    x -= value(k, x) / slope;
  }
  return x;
}

void run_rpoly(Trial& trial) {
  run_reported(trial, rpoly, 11, [&](const RootQuestion& question, const Quartic& k) {
    question.judge_naive(trial.naive("fifty steps of Newton's from 50"), {newton(k, 50)});
  });
}

Sketch draw_rpoly() {
  Sketch sketch{"The polynomial, its height divided by 10000. It is lowest at x = 49.78, and 6017 there.", {}};
  return draw_graph(
             sketch, [](double x) { return value(rpoly, x) / 1e4; }, 40, 60, 6)
      .label({46, -1}, "no root: the least value is above 0")
      .label({46, -2}, "Newton's steps go round and round below it, and end somewhere", Role::naive);
}

}  // namespace

HardCase quartic_mixed_scale() {
  return {.id = "quartic-mixed-scale",
          .group = "solver",
          .inputs = "x^4 - 1000000.001 x^3 + 1002 x^2 - 2 x + .001; and with coefficients a few ulps off",
          .expected = "5.70194700491e-4 and 999999.999998",
          .why =
              "Ferrari shifts by a quarter of the sum of all roots, 250000, and adds that back at the end: the small "
              "root has "
              "no digit left. Coefficients of such different sizes come of thin shapes seen from afar.",
          .oracle = Oracle::sturm_chains,
          .run = run_mixed_scale,
          .draw = draw_mixed_scale};
}

HardCase quartic_diagrams() {
  return {
      .id = "quartic-diagrams7",
      .group = "solver",
      .inputs = "x^4 - 240 x^3 + 25449 x^2 - 1325880 x + 26471900.25; and with coefficients a few ulps off",
      .expected = "50.645112696944665 and 69.35488730305534",
      .why =
          "Even around 60, so that q is 0: the resolvent has the root 0, and the others decide. Rounded, q is noise of "
          "1e-9, and tolerances that ought to tell 0 from noise drop both roots.",
      .oracle = Oracle::sturm_chains,
      .reference = "diagrams-solve, issue 7",
      .run = run_diagrams,
      .draw = draw_diagrams};
}

HardCase quartic_celeritas() {
  return {.id = "quartic-celeritas",
          .group = "solver",
          .inputs = "x^4 + 19.534611 x^3 - 48660.891842 x^2 - 476217.617178 x + 57126150.652217; and a few ulps off",
          .expected = "-223.0095, -39.8853, 30.1180, 213.2422",
          .why =
              "The resolvent cubic has three real roots here, and books say `any`. The roots lie almost opposite each "
              "other, "
              "so that its lowest one is almost 0: all its digits cancel, and Ferrari divides noise by its root. The "
              "highest "
              "one does no harm.",
          .oracle = Oracle::sturm_chains,
          .reference = "celeritas, issue 2439",
          .run = run_celeritas,
          .draw = draw_celeritas};
}

HardCase quartic_rpoly() {
  return {
      .id = "quartic-rpoly5",
      .group = "solver",
      .inputs = "x^4 - 198.995 x^3 + 15006.6 x^2 - 508127 x + 6.52025e6; and with coefficients a few ulps off",
      .expected = "no real root",
      .why =
          "Terms of 10^7 and more add up to 6017 at the least, and the root of a program is wherever it stops: where "
          "its steps "
          "are used up, or an imaginary part seems small. That there is none has to be shown by signs, as of Sturm's "
          "chain. It was reported as a root that had been missed.",
      .oracle = Oracle::sturm_chains,
      .reference = "RpolyPlusPlus, issue 5",
      .run = run_rpoly,
      .draw = draw_rpoly};
}

}  // namespace sightline::hard
