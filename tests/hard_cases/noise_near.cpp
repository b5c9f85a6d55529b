/// Noise at lattice points, next to them, and below 0.

#include <cmath>

#include "sightline/math/random.h"
#include "sightline/noise/noise_field.h"
#include "tests/hard_cases/noise_parts.h"
#include "tests/hard_cases/noise_question.h"

namespace sightline::hard {
namespace {

// ---- noise-lattice

template <class T>
void ask_zero(Trial& trial, std::string_view more, NoiseKind kind, const glm::dvec3& at, T got) {
  trial.of(who_asks<T>(kind, more)).decide(got == 0, [&] { return Example{vector_text(at), "0", all_digits(got)}; });
}

/// Twelve vectors to the middles of a cube's edges: two components are 1 or -1, exactly.
void ask_edge(Trial& trial, const glm::dvec3& at, const glm::dvec3& gradient) {
  int zeros = 0, ones = 0;
  for (int axis = 0; axis < 3; ++axis) zeros += gradient[axis] == 0, ones += std::fabs(gradient[axis]) == 1;
  trial.of("improved, gradient there").decide(zeros == 1 && ones == 2, [&] {
    return Example{vector_text(at), "two components of 1 or -1", vector_text(gradient)};
  });
}

void run_lattice(Trial& trial) {
  Random random(71);
  for (const NoiseKind kind : gradient_noises) {
    const Noise noise({.kind = kind, .seed = 1});
    const NoiseField field({.noise = {.kind = kind, .seed = 2}, .fractal = FractalKind::fbm, .octaves = 4});
    std::vector<glm::vec3> points;
    for (std::uint64_t i = 0, count = trial.count(4000); i < count; ++i) {
      const glm::dvec3 p = random_lattice_vector(random, i % 2 == 0 ? 300 : 1u << 21);
      ask_zero(trial, "", kind, p, noise(p));
      ask_zero(trial, "", kind, p, noise(glm::vec3(p)));
      ask_zero(trial, ", in the plane", kind, p, noise(glm::vec2(p)));
      ask_zero(trial, ", in four octaves", kind, p, field(p));  // a lattice twice as fine has these points as well
      if (kind == NoiseKind::improved) ask_edge(trial, p, noise.sample(p).gradient);
      points.emplace_back(p);
    }
    std::vector<float> values(points.size());
    noise.values<3, float>(points, values);
    for (std::size_t i = 0; i < points.size(); ++i) ask_zero(trial, ", in a batch", kind, points[i], values[i]);
  }
}

/// A line of noise with the gradients of its lattice points, for x from -2 to 2.
Sketch noise_line(std::string caption) {
  Sketch sketch{std::move(caption), {}};
  constexpr double slope[5] = {0.7, -0.9, 0.8, 0.5, -0.8};
  std::vector<glm::dvec2> curve;
  for (int i = 0; i <= 80; ++i) {
    const double x = -2 + 0.05 * i;
    const int cell = std::min(3, i / 20);
    const double f = x + 2 - cell, s = f * f * (3 - 2 * f);
    curve.emplace_back(x, (1 - s) * slope[cell] * f + s * slope[cell + 1] * (f - 1));
  }
  sketch.line({-2.2, 0}, {2.2, 0}, Role::aid).path(std::move(curve));
  for (int i = 0; i < 5; ++i) {
    const double x = i - 2;
    sketch.line({x - 0.2, -0.2 * slope[i]}, {x + 0.2, 0.2 * slope[i]}, Role::ray);
  }
  return sketch;
}

Sketch draw_lattice() {
  Sketch sketch = noise_line("Gradient noise along a line: 0 at every lattice point, whatever the slopes there.");
  for (int x = -2; x <= 2; ++x) sketch.dot({static_cast<double>(x), 0});
  return sketch.label({-2, 0.8}, "slopes by chance, heights 0", Role::truth);
}

// ---- noise-negative

float truncated(float x) { return static_cast<float>(static_cast<int>(x)); }
float floored(float x) { return std::floor(x); }

void run_negative(Trial& trial) {
  Random random(72);
  for (const NoiseKind kind : lattice_noises) {
    const Noise noise({.kind = kind}), periodic({.kind = kind, .period = 256});
    for (std::uint64_t i = 0, count = trial.count(1500); i < count; ++i) {
      const auto below_zero = [&] { return i == 0 ? -0.5 : -std::ldexp(1 + random.below(1u << 18), -12); };
      const double x = below_zero(), y = below_zero();
      const glm::dvec3 p(x, y, below_zero());
      judge_noise(trial.of(who_asks<double>(kind)), noise, p, noise(p));
      judge_noise(trial.of(who_asks<float>(kind)), noise, p, noise(glm::vec3(p)));
      const double here = periodic(p), there = periodic(p + 256.0);
      trial.of(who_asks<double>(kind, ", as a period on")).decide(here == there, [&] {
        return Example{vector_text(p), all_digits(there), all_digits(here)};
      });
      if (kind != NoiseKind::perlin) continue;
      judge_noise(trial.naive("cells by (int)x"), noise, p, naive_noise(noise, glm::vec3(p), truncated));
    }
  }
}

Sketch draw_negative() {
  Sketch sketch =
      noise_line("-0.5 lies half way from -1 to 0. Truncated, it is -0.5 away from 0, outside of its cell.");
  return sketch.dot({-0.5, 0})
      .line({-1, -0.55}, {-0.5, -0.55}, Role::truth)
      .line({0, -0.75}, {-0.5, -0.75}, Role::naive)
      .label({-2.2, -0.57}, "floor: 0.5 from -1", Role::truth)
      .label({0.1, -0.77}, "(int): -0.5 from 0, and two cells called 0", Role::naive);
}

// ---- noise-neg-tiny

void run_negative_tiny(Trial& trial) {
  Random random(73);
  for (const NoiseKind kind : gradient_noises) {
    const Noise noise({.kind = kind});
    for (std::uint64_t i = 0, count = trial.count(1500); i < count; ++i) {
      // Along a lattice line, where noise is 0, so that its slope shows; every other time anywhere on a lattice plane.
      const float tiny =
          (i % 3 == 0 ? 1.0f : -1.0f) * (i < 2 ? 1e-9f : std::ldexp(1 + random.uniform(), -25 - int(i % 90)));
      glm::vec3 p(random_lattice_vector(random, 100));
      p.x = tiny;
      const bool is_on_line = i % 2 == 0;
      if (!is_on_line) p.y += random.uniform(), p.z += random.uniform();
      const auto size = [&](double rounding) {
        return is_on_line && std::fabs(tiny) <= rounding ? std::fabs(tiny) : 1.;
      };
      judge_noise(trial.of(who_asks<float>(kind)), noise, glm::dvec3(p), noise(p), size(0x1p-25));
      judge_noise(trial.of(who_asks<double>(kind)), noise, glm::dvec3(p), noise(glm::dvec3(p)), size(0x1p-54));
      if (kind != NoiseKind::perlin) continue;
      judge_noise(trial.naive("f = x - floor(x), f - 1"), noise, glm::dvec3(p), naive_noise(noise, p, floored),
                  size(0x1p-25));
    }
  }
}

Sketch draw_negative_tiny() {
  Sketch sketch = noise_line("A point a hair below 0; drawn at -0.06.");
  return sketch.dot({-0.06, -0.05})
      .dot({0, 0}, Role::naive)
      .label({-1.9, 0.8}, "-1e-9: noise is -1e-9 of its slope", Role::truth)
      .label({0.2, -0.5}, "x - floor(x) rounds to 1: the next lattice point", Role::naive);
}

// ---- noise-c2

/// Of noise along x, on one side of a lattice point: a difference of exact slopes over a step.
double curvature(const Noise& noise, const glm::dvec3& p, double step) {
  const glm::dvec3 q(p.x + step, p.y, p.z);
  return (noise.sample(q).gradient.x - noise.sample(p).gradient.x) / step;
}

/// Slopes are known to 32 units in the last place of 1 (tests/noise/definition_test.cpp).
void judge_curvature(Tally& tally, const glm::dvec3& p, double step, double expected, double got) {
  const double off = std::fabs(got - expected), allowed = 32 * 0x1p-52 / std::fabs(step);
  const Verdict verdict = off == 0 ? Verdict::exact : off <= allowed ? Verdict::within_bound : Verdict::wrong;
  tally.add(verdict, expected == 0 ? 0 : off / std::fabs(expected), [&] {
    return Example{vector_text(p), all_digits(expected), all_digits(got)};
  });
}

double cubic_ease(double t) { return t * t * (3 - 2 * t); }

void run_second_derivative(Trial& trial) {
  constexpr double step = 0x1p-20, rest = 1 - step;
  Random random(74);
  const Noise quintic({.kind = NoiseKind::value, .ease = Ease::quintic}), cubic({.kind = NoiseKind::value});
  const glm::dvec3 x(1, 0, 0);
  for (std::uint64_t i = 0, count = trial.count(4000); i < count; ++i) {
    const glm::dvec3 p = random_lattice_vector(random, 1000);
    for (const double side : {-1.0, 1.0}) {
      const auto rise = [&](const Noise& noise) { return side * (noise(p + side * x) - noise(p)); };
      // From one lattice point to the next noise is a + rise ease(t), and its slope rise 30 t^2 (1 - t)^2, or of the
      // cubic ease rise 6 t (1 - t): what is left of it after a step, by the step.
      judge_curvature(trial.of("value, quintic"), p, step, rise(quintic) * 30 * side * step * rest * rest,
                      curvature(quintic, p, side * step));
      judge_curvature(trial.of("value, cubic, which jumps"), p, step, rise(cubic) * 6 * side * rest,
                      curvature(cubic, p, side * step));
    }
  }
  // Central second differences of the ease alone, extended by its mirror image.
  for (const double t : {0.0, 1.0}) {
    const double inside = t == 0 ? step : 1 - step, bend = 2 * (cubic_ease(inside) - cubic_ease(t)) / (step * step);
    trial.naive("3 t^2 - 2 t^3").decide(std::fabs(bend) < 1, [&] {
      return Example{"t = " + all_digits(t), "0", all_digits(bend)};
    });
  }
}

Sketch draw_second_derivative() {
  Sketch sketch{"Second derivatives of two eases over two cells; divided by 6.", {}};
  std::vector<glm::dvec2> quintic;
  for (int cell = 0; cell < 2; ++cell) {
    const double x = 2 * cell;
    sketch.path({{x, 1}, {x + 2, -1}}, Role::naive);
    for (int i = 0; i <= 20; ++i) {
      const double t = 0.05 * i;
      quintic.emplace_back(x + 2 * t, 10 * t * (1 + t * (-3 + 2 * t)));
    }
  }
  return sketch.path(std::move(quintic), Role::truth)
      .line({-0.3, 0}, {4.3, 0}, Role::aid)
      .line({2, -1}, {2, 1}, Role::aid)
      .label({2.2, 1.2}, "cubic: from -6 to 6 at once", Role::naive)
      .label({-0.3, -1.3}, "quintic: 0 at lattice points", Role::truth);
}

}  // namespace

HardCase noise_lattice() {
  return {
      .id = "noise-lattice",
      .group = "noise",
      .inputs = "integer points to 2^21, in float and double, in the plane and in space, in batches, in four octaves",
      .expected = "0; the gradient of improved noise there is one of its twelve",
      .why =
          "At a lattice point all ways are 0 or are weighed by 0, so gradient noise is 0 whatever the gradients. "
          "Octaves whose lattices share points vanish there together: a spot that returns on a grid. And a test "
          "that samples integers alone sees a constant.",
      .oracle = Oracle::closed_form,
      .reference = {},
      .is_policy = false,
      .run = run_lattice,
      .draw = draw_lattice};
}

HardCase noise_negative() {
  return {
      .id = "noise-negative",
      .group = "noise",
      .inputs = "x = -0.5, and points with coordinates from -64 to 0 in steps of 2^-12",
      .expected =
          "the cell below and a fraction in [0, 1), as the definition has in fifty digits; the same a "
          "period of 256 on",
      .why =
          "A cast to int truncates toward 0. So -0.5 and 0.5 are both in cell 0, the fraction is -0.5, and the ease "
          "leaves [0, 1]: noise is mirrored and torn along the axes.",
      .oracle = Oracle::closed_form,
      .reference = "noise-rs issue 77",
      .is_policy = false,
      .run = run_negative,
      .draw = draw_negative};
}

HardCase noise_negative_tiny() {
  return {.id = "noise-neg-tiny",
          .group = "noise",
          .inputs = "x = -1e-9f, and +-2^-25 to +-2^-115, on lattice lines and planes",
          .expected = "noise goes on through 0 by its slope: -1e-9 of it, off by no more than 8 roundings of 1e-9",
          .why =
              "floor(-1e-9f) is -1, and -1e-9f + 1 rounds to 1: the fraction is not below 1. Tables indexed by it are "
              "overrun, and the way from the upper lattice point, f - 1, is 0 where it should be -1e-9. That way has "
              "to be taken from the coordinate itself.",
          .oracle = Oracle::more_digits,
          .reference = {},
          .is_policy = false,
          .run = run_negative_tiny,
          .draw = draw_negative_tiny};
}

HardCase noise_second_derivative() {
  return {
      .id = "noise-c2",
      .group = "noise",
      .inputs = "second derivatives on both sides of lattice points, of value noise with the quintic and cubic eases",
      .expected = "quintic: 0, on both sides; cubic, which is offered for comparison: -6 and 6 times the differences",
      .why =
          "3 t^2 - 2 t^3 has no slope at 0 and 1, but its second derivative is 6 and -6: it jumps at every lattice "
          "plane. Bump maps take derivatives of noise, so shading shows the planes as creases.",
      .oracle = Oracle::closed_form,
      .reference = "Perlin, Improving Noise, 2002",
      .is_policy = false,
      .run = run_second_derivative,
      .draw = draw_second_derivative};
}

}  // namespace sightline::hard
