/// Noise where floats, and integers, end.

#include <cmath>
#include <numbers>

#include "sightline/math/random.h"
#include "sightline/noise/noise_field.h"
#include "tests/hard_cases/noise_parts.h"
#include "tests/hard_cases/noise_question.h"

namespace sightline::hard {
namespace {

float floored(float x) { return std::floor(x); }

// ---- noise-2^24

void run_two_to_24(Trial& trial) {
  Random random(81);
  for (const NoiseKind kind : lattice_noises) {
    const NoiseField field({.noise = {.kind = kind, .seed = 3}, .frequency = 0.25});
    const Noise noise({.kind = kind, .seed = 3});
    for (std::uint64_t i = 0, count = trial.count(800); i < count; ++i) {
      const double far = i % 2 == 0 ? 0x1p24 : 1e6;
      const glm::vec3 within(random.uniform(0, 500), random.uniform(0, 500), random.uniform(0, 500));
      // The scene is far away: in double nothing of the place is lost, and noise is what it is there.
      const glm::dvec3 p = glm::dvec3(within) + far;
      judge_noise(trial.of(who_asks<double>(kind)), noise, p, noise(p));
      // Where a float is at all, it is asked for what it stands for; here of a lattice of four units a cell.
      const glm::vec3 narrow(p);
      judge_noise(trial.of(who_asks<float>(kind, ", frequency 1/4")), field.noise(), 0.25 * glm::dvec3(narrow),
                  field(narrow));
      judge_noise(trial.of(who_asks<double>(kind, ", frequency 1/4")), field.noise(), 0.25 * p, field(p));
      if (kind != NoiseKind::perlin) continue;
      const glm::vec3 moved = within + static_cast<float>(far);
      judge_noise(trial.naive(i % 2 == 0 ? "moved by 2^24 in float" : "moved by 10^6 in float"), noise, p,
                  naive_noise(noise, moved, floored));
    }
  }
}

Sketch draw_two_to_24() {
  Sketch sketch{"Floats beyond 2^24: every one is a lattice point, and gradient noise is 0 there.", {}};
  std::vector<glm::dvec2> curve;
  for (int i = 0; i <= 120; ++i) curve.emplace_back(0.05 * i, 0.6 * std::sin(std::numbers::pi * 0.05 * i));
  sketch.path(std::move(curve), Role::truth).line({-0.3, 0}, {6.3, 0}, Role::aid);
  for (int x = 0; x <= 6; ++x) sketch.dot({static_cast<double>(x), 0}, Role::naive);
  return sketch.label({0, 0.9}, "noise of the place", Role::truth)
      .label({0, -0.9}, "2^24 + x in float: x loses its fraction, all is 0", Role::naive);
}

// ---- noise-2^31

/// What processors of Intel's make of a cast that does not fit, which the language leaves undefined.
double cell_by_cast(double x) {
  const double whole = std::floor(x);
  const bool fits = whole >= -0x1p31 && whole < 0x1p31;
  return fits ? whole : -0x1p31;
}

void run_two_to_31(Trial& trial) {
  Random random(82);
  const Noise improved({.kind = NoiseKind::improved}), perlin;
  const double places[] = {0x1p31, 3e9, -3e9, -0x1p31 - 1, 0x1p32, 0x1p40, -0x1p42};
  for (std::uint64_t i = 0, count = trial.count(3000); i < count; ++i) {
    const double far = i % 8 == 0 ? 3e9 : places[random.below(7)] + random.below(1000);
    const glm::dvec3 fraction(std::ldexp(1 + random.below(254), -8), std::ldexp(random.below(256), -8),
                              random.below(9) + 0.25);
    const glm::dvec3 p = fraction + glm::dvec3(far, 0, 0),
                     near(fraction.x + std::fmod(far, 256), fraction.y, fraction.z);
    judge_noise(trial.of(who_asks<double>(NoiseKind::improved)), improved, near, improved(p));
    judge_noise(trial.of(who_asks<double>(NoiseKind::perlin)), perlin, p, perlin(p));
    const double next = perlin(p + glm::dvec3(1, 0, 0)), folded = perlin(near),
                 wrapped = perlin(p - glm::dvec3(0x1p32, 0, 0));
    const bool goes_on = perlin(p) != next && perlin(p) != folded && perlin(p) != wrapped;
    trial.of(who_asks<double>(NoiseKind::perlin, ", without repeating")).decide(goes_on, [&] {
      return Example{vector_text(p), "other values a cell, 2^32 and any number of periods away", all_digits(next)};
    });
    // Of floats as far away there are lattice points alone along x.
    const float narrow = static_cast<float>(far);
    const glm::vec3 q(narrow, fraction.y, fraction.z);
    judge_noise(trial.of(who_asks<float>(NoiseKind::improved)), improved,
                glm::dvec3(std::fmod(static_cast<double>(narrow), 256), fraction.y, fraction.z), improved(q));
    judge_noise(trial.naive("cells by (int)floor(x)"), improved, near, naive_noise(improved, p, cell_by_cast));
  }
}

Sketch draw_two_to_31() {
  Sketch sketch{"Which cell of 256 a place is in: truly, and as a cast to int has it; not to scale.", {}};
  sketch.line({0, 0}, {8, 0}, Role::ray)
      .label({7.6, -0.4}, "x")
      .line({4, -0.3}, {4, 3}, Role::aid)
      .label({4.1, 3}, "2^31");
  for (int i = 0; i < 8; ++i) {
    const double x = i;
    sketch.line({x, 0}, {x + 1, 2}, Role::truth);
    if (i >= 4) sketch.line({x, 0.05}, {x + 1, 0.05}, Role::naive);
  }
  return sketch.label({0.2, 2.2}, "x mod 256: goes on for ever", Role::truth)
      .label({4.2, -0.9}, "(int)x: the same cell for all, or anything", Role::naive);
}

// ---- noise-period

template <class T>
void ask_period(Trial& trial, const Noise& noise, const glm::vec<3, T>& p, T shift) {
  const auto here = noise.sample(p), there = noise.sample(p + shift);
  const bool is_same = noise(p) == noise(p + shift) && here.value == there.value && here.gradient == there.gradient;
  trial.of(who_asks<T>(noise.options().kind)).decide(is_same, [&] {
    return Example{vector_text(glm::dvec3(p)) + " + " + all_digits(shift), all_digits(here.value),
                   all_digits(there.value)};
  });
}

void run_period(Trial& trial) {
  Random random(83);
  for (const NoiseKind kind : lattice_noises) {
    const Noise noise({.kind = kind, .period = kind == NoiseKind::improved ? 0u : 256u});
    for (std::uint64_t i = 0, count = trial.count(4000); i < count; ++i) {
      const auto coordinate = [&] { return std::ldexp(static_cast<double>(random.below(1u << 16)), -8); };
      const double x = coordinate(), y = coordinate();
      const glm::dvec3 p(x, y, coordinate());
      for (const double shift : {256.0, -256.0, 512.0, 0x1p34, -0x1p40}) ask_period(trial, noise, p, shift);
      ask_period(trial, noise, glm::vec3(p), i % 2 == 0 ? 256.0f : -512.0f);
      if (kind != NoiseKind::perlin) continue;
      // Any fraction: the sum has fewer bits for it than the place itself.
      const glm::vec3 q(random.uniform(), random.uniform(), random.uniform());
      const float here = naive_noise(noise, q, floored), there = naive_noise(noise, q + 256.0f, floored);
      trial.naive("tiles moved by 256 in float").decide(here == there, [&] {
        return Example{vector_text(glm::dvec3(q)) + " + 256", all_digits(here), all_digits(there)};
      });
    }
  }
}

Sketch draw_period() {
  Sketch sketch{"Two tiles of noise that repeats, and the fractions that floats have in each.", {}};
  for (int tile = 0; tile < 2; ++tile) {
    const double left = 3.5 * tile;
    std::vector<glm::dvec2> curve;
    for (int i = 0; i <= 60; ++i) curve.emplace_back(left + 0.05 * i, 0.6 * std::sin(2 * std::numbers::pi * i / 60.0));
    sketch.path(std::move(curve), Role::truth).rectangle({left, -1}, {left + 3, 1}, Role::aid);
    const int steps = tile == 0 ? 24 : 6;
    for (int i = 0; i <= steps; ++i) {
      sketch.dot({left + 3.0 * i / steps, -1}, tile == 0 ? Role::truth : Role::naive);
    }
  }
  return sketch.label({0, 1.2}, "x: same bits wherever the fraction fits", Role::truth)
      .label({3.5, -1.4}, "x + 256: a coarser grid, other places", Role::naive);
}

}  // namespace

HardCase noise_two_to_24() {
  return {.id = "noise-2^24",
          .group = "noise",
          .inputs = "points of [0, 500]^3, moved by 2^24 and by 10^6; in double, and in float on a lattice of 4 units",
          .expected = "noise of the place as it is given, to a dozen roundings of numbers below 1",
          .why =
              "From 2^24 on all floats are integers, lattice points, where gradient noise is 0: a far scene turns "
              "gray. At 10^6 a float has 4 bits of fraction left, and noise is off by a tenth. What is added "
              "beforehand is lost; noise itself cannot bring it back, but takes doubles.",
          .oracle = Oracle::more_digits,
          .reference = {},
          .is_policy = false,
          .run = run_two_to_24,
          .draw = draw_two_to_24};
}

HardCase noise_two_to_31() {
  return {.id = "noise-2^31",
          .group = "noise",
          .inputs = "x = 3e9 and others around 2^31, 2^32, 2^40 and -2^42, with fractions of 1/256",
          .expected = "improved noise is that of x mod 256; the other kind goes on without repeating",
          .why =
              "Casting a number to int that does not fit is undefined: on one processor it gives -2^31 for all, on "
              "another 2^31 - 1, and a compiler may fold it to 0. The fraction is then the whole coordinate, and "
              "noise a huge number.",
          .oracle = Oracle::closed_form,
          .reference = "pbrt's noise, which takes fmod by 2^30 first; C++ [conv.fpint]",
          .is_policy = false,
          .run = run_two_to_31,
          .draw = draw_two_to_31};
}

HardCase noise_period() {
  return {.id = "noise-period",
          .group = "noise",
          .inputs = "x in steps of 1/256, and x + 256, x - 256, x + 512, x + 2^34, x - 2^40, with a period of 256",
          .expected = "the same value and gradient, bit for bit",
          .why =
              "A tile repeats only as well as the sum keeps the fraction: x + 256 has 8 bits less for it than x "
              "below 1. Dyadic fractions that fit survive, and then noise must not round on its own, in the cell's "
              "number or in the way into it.",
          .oracle = Oracle::metamorphic,
          .reference = {},
          .is_policy = false,
          .run = run_period,
          .draw = draw_period};
}

}  // namespace sightline::hard
