/// Spheres far away, very large and very small.

#include <cmath>

#include "sightline/math/random.h"
#include "sightline/shape/sphere.h"
#include "tests/hard_cases/naive_sphere.h"
#include "tests/hard_cases/solid_question.h"
#include "tests/hard_cases/sphere_parts.h"

namespace sightline::hard {
namespace {

void ask_school_formula(Trial& trial, const SolidQuestion& question, const solid::Sphere& sphere,
                        const Ray<double>& ray) {
  question.judge_spans(trial.naive("the formula from school, in float"),
                       naive_sphere_roots(Vec3f(sphere.center), static_cast<float>(sphere.radius), ray_in_float(ray)));
}

/// The sphere as a primitive of SphereSet, whose numbers are floats.
void ask_sphere_set(Trial& trial, const SolidQuestion& question, const solid::Sphere& sphere) {
  std::vector<double> ends;
  SphereSet::PreparedRay(question.ray())
      .for_each_crossing(Sphere{Vec3f(sphere.center), static_cast<float>(sphere.radius)},
                         [&](const Crossing& crossing) { ends.push_back(crossing.t); });
  question.judge_crossings(trial.of("sphere set"), ends);
}

// ---- sph-far

void run_far(Trial& trial) {
  const UnionByStructure others = among_others([](const Vec3d& at) { return solid::Sphere{at, 1}; }, 4);
  Random random(1);
  const auto turns = trial.count(30);
  for (int k = 0; k <= 40; ++k) {
    for (std::uint64_t i = 0; i < turns; ++i) {
      const double angle = i == 0 ? 0 : 6.28 * random.uniform_double();
      const Ray<double> ray =
          ray_of_floats({0.5 * std::cos(angle), 0.5 * std::sin(angle), -std::ldexp(1.0, k)}, {0, 0, 1});
      const SolidQuestion question(solid::Sphere{}, ray, sturm_sphere_spans({}, ray));
      question.ask_spans(trial, "sphere");
      ask_sphere_set(trial, question, {});
      ask_school_formula(trial, question, {}, ray);
      if (i == 0) SolidQuestion(others.tree(), ray, question.truth()).ask_spans(trial, others);
    }
  }
}

Sketch draw_far() {
  Sketch sketch{
      "A sphere far to the right of an eye, at a tenth of its distance: the true chord, and what is left of it "
      "at a distance of 2048 radii.",
      {}};
  return sketch.circle({20, 0}, 1)
      .line({-2, 0.5}, {24, 0.5}, Role::ray)
      .line({20 - 0.866, 0.5}, {20 + 0.866, 0.5}, Role::truth)
      .dot({20 - 0.866, 0.5})
      .dot({20 + 0.866, 0.5})
      .dot({19, 0.5}, Role::naive)
      .dot({21, 0.5}, Role::naive)
      .label({17, 1.6}, "true chord 1.732", Role::truth)
      .label({17, -1.8}, "in float 2, and from 8192 on none", Role::naive)
      .label({-2, 0.9}, "eye");
}

// ---- sph-planet

void run_planet(Trial& trial) {
  const solid::Sphere planet{{0, 0, 0}, 0x1p20};
  Random random(2);
  const auto count = trial.count(1000);
  for (std::uint64_t i = 0; i <= count; ++i) {
    // The horizon is 1/724 below the horizontal.
    const double slope = i == 0 ? -1.0 / 16 : -1 / (1 + 500 * random.uniform_double());
    const Ray<double> ray = ray_of_floats({0, 0x1p20 + 1, 0}, {1, slope, 0});
    const SolidQuestion question(planet, ray, sturm_sphere_spans(planet, ray));
    question.ask_first(trial, "sphere");
    question.judge_first(trial.naive("the formula from school, in float"),
                         first_root_ahead(naive_sphere_roots(Vec3f(0), 0x1p20f, ray_in_float(ray))));
  }
}

Sketch draw_planet() {
  Sketch sketch{
      "An eye over a planet looks at the ground in front of it. Heights are 4 times too large, and the error is "
      "1000 times.",
      {}};
  std::vector<glm::dvec2> ground;
  for (int x = -4; x <= 24; ++x) ground.push_back({x, -0.0005 * x * x});
  return sketch.path(ground)
      .dot({0, 4}, Role::aid)
      .label({0.4, 4.2}, "eye, 1 above a radius of 2^20")
      .line({0, 4}, {19, -0.75}, Role::ray)
      .dot({16.55, -0.137})
      .dot({18.5, -0.625}, Role::naive)
      .label({9, 1}, "true: t = 16.00195", Role::truth)
      .label({14, -1.8}, "in float: 16.00389", Role::naive);
}

// ---- sph-dir-underflow

void run_direction_underflow(Trial& trial) {
  const UnionByStructure others = among_others([](const Vec3d& at) { return solid::Sphere{at, 1}; }, 4);
  for (int k = -120; k <= 120; k += 8) {
    const Ray<double> ray{{0, 0.5, -4}, {0, 0, std::ldexp(1.0, k)}};
    const SolidQuestion question(solid::Sphere{}, ray, sturm_sphere_spans({}, ray));
    question.ask_spans(trial, "sphere");
    ask_sphere_set(trial, question, {});
    SolidQuestion(others.tree(), ray, question.truth()).ask_spans(trial, others);
    ask_school_formula(trial, question, {}, ray);
  }
}

Sketch draw_direction_underflow() {
  Sketch sketch{"A ray whose direction is 2^-80 long, drawn longer: its line is like any other.", {}};
  return sketch.circle({4, 0}, 1)
      .line({0, 0.5}, {0.5, 0.5}, Role::ray)
      .line({0.5, 0.5}, {6, 0.5}, Role::aid)
      .dot({4 - 0.866, 0.5})
      .dot({4 + 0.866, 0.5})
      .label({0, 0.75}, "d = 2^-80")
      .label({2.4, 1.3}, "true: t = 3.79e24", Role::truth)
      .label({2.4, -1.5}, "d d is 0 in float: t = infinity, or 0 / 0", Role::naive);
}

// ---- sph-scale

void run_scale(Trial& trial) {
  Random random(3);
  const auto count = trial.count(200);
  for (const int exponent : {64, -80, 100, -200}) {
    const double s = std::ldexp(1.0, exponent);
    const bool is_float = exponent >= -120;  // with its squares left out
    const auto scaled = [&](const Vec3d& at) { return solid::Sphere{s * at, s}; };
    std::optional<UnionByStructure> others;
    if (is_float) others.emplace(among_others(scaled, 4));
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto wide = [&] { return 2 * random.uniform_double() - 1; };
      const double x = 0.6 * wide(), y = 0.6 * wide();
      const Ray<double> ray = ray_of_floats({x, y, -9}, {0.05 * wide(), 0.05 * wide(), 1});
      // Lengths grow by s, and the parameters of a direction that grows with them stay.
      const Ray<double> same{s * ray.origin, s * ray.direction};
      const TrueSpans truth = true_solid_spans(solid::Sphere{}, ray);
      const SolidQuestion question(scaled(Vec3d(0)), same, truth);
      question.ask_spans(trial, "sphere");
      if (is_float) ask_sphere_set(trial, question, scaled(Vec3d(0)));
      if (is_float && i < 20) SolidQuestion(others->tree(), same, truth).ask_spans(trial, *others);
      ask_school_formula(trial, question, scaled(Vec3d(0)), same);
    }
  }
}

Sketch draw_scale() {
  Sketch sketch{
      "One scene at two scales. Everything is larger by one factor, the ray's direction too, so t is the same.", {}};
  return sketch.circle({3, 0}, 0.5)
      .line({0, 0.15}, {5, 0.15}, Role::ray)
      .dot({3 - 0.477, 0.15})
      .dot({3 + 0.477, 0.15})
      .circle({9, 0}, 1.5)
      .line({0, 0.45}, {13, 0.45}, Role::ray)
      .dot({9 - 1.431, 0.45})
      .dot({9 + 1.431, 0.45})
      .label({2, -0.9}, "1")
      .label({8.6, -2}, "2^64: in float r r is infinite", Role::naive);
}

// ---- sph-abs-eps

/// As programs do that call short chords misses.
std::vector<double> roots_of_long_chords(double radius, const Ray<double>& ray) {
  const double along = -glm::dot(ray.origin, ray.direction);
  const double half_chord2 = radius * radius - glm::dot(ray.origin, ray.origin) + along * along;
  if (half_chord2 < 1e-10) return {};
  const double half_chord = std::sqrt(half_chord2);
  return {along - half_chord, along + half_chord};
}

void run_absolute_epsilon(Trial& trial) {
  Random random(4);
  const auto count = trial.count(100);
  for (const double radius : {9e-6, 0x1p-20, 1e-9, 1e-12}) {
    const UnionByStructure others = among_others(
        [&](const Vec3d& at) {
          return solid::Sphere{at, radius};
        },
        4 * radius);
    for (std::uint64_t i = 0; i < count; ++i) {
      const double x = i == 0 ? 0 : radius * (random.uniform_double() - 0.5);
      const Ray<double> ray{{x, 0, -1}, {0, 0, 1}};
      const SolidQuestion question(solid::Sphere{{0, 0, 0}, radius}, ray);
      question.ask_spans(trial, "sphere");
      if (i < 10) SolidQuestion(others.tree(), ray, question.truth()).ask_spans(trial, others);
      question.judge_spans(trial.naive("half chords below 1e-5 are misses, in double"),
                           roots_of_long_chords(radius, ray));
    }
  }
}

Sketch draw_absolute_epsilon() {
  Sketch sketch{
      "A sphere of radius 9e-6 a unit away, some 50,000 times too large. The circle around it is the smallest "
      "that a limit of 1e-10 lets be seen.",
      {}};
  return sketch.circle({4, 0}, 0.45)
      .circle({4, 0}, 0.5, Role::naive)
      .line({0, 0}, {6, 0}, Role::ray)
      .dot({3.55, 0})
      .dot({4.45, 0})
      .label({2.6, 0.7}, "true: hit at 1 - 9e-6", Role::truth)
      .label({2.6, -0.8}, "half chord squared 8.1e-11 < 1e-10: missed", Role::naive);
}

}  // namespace

HardCase sphere_far() {
  return {.id = "sph-far",
          .group = "sphere",
          .inputs = "radius 1, rays of float that pass the center at 1/2, from 2^k away, k = 0 ... 40",
          .expected = "two roots, a chord of sqrt(3) apart, however far away",
          .why =
              "c = o.o - r r and b b - 4 a c subtract squares of the distance, which hide the square of the radius: "
              "from 2^12 radii on r r is less than the spacing of floats around o.o. The vector from the center to "
              "the closest point of the line has the chord in it, and nothing large is subtracted.",
          .oracle = Oracle::sturm_chains,
          .reference = "Haines, Guenther and Akenine-Moeller, Ray Tracing Gems, chapter 7, 2019",
          .run = run_far,
          .draw = draw_far};
}

HardCase sphere_planet() {
  return {.id = "sph-planet",
          .group = "sphere",
          .inputs = "radius 2^20, eye 1 above the ground, direction (1, -1/16, 0), and others down to near the horizon",
          .expected = "t = 16.001953602 for -1/16; the ground where it is",
          .why =
              "From next to a large sphere the near root is the small difference of two large numbers, -b and the "
              "root of the discriminant: all that they were rounded by stays in it. Adding numbers of one sign and "
              "dividing c by the sum loses nothing.",
          .oracle = Oracle::sturm_chains,
          .reference = "Haines, Guenther and Akenine-Moeller, Ray Tracing Gems, chapter 7, 2019",
          .run = run_planet,
          .draw = draw_planet};
}

HardCase sphere_direction_underflow() {
  return {.id = "sph-dir-underflow",
          .group = "sphere",
          .inputs = "radius 1, origin (0, 1/2, -4), direction (0, 0, 2^k), k = -120 ... 120, -80 among them",
          .expected = "(4 -+ sqrt(3)/2) / 2^k: for k = -80 first 3.78874281e24",
          .why =
              "a = d.d is 2^-160, which float has no number for: it becomes 0, and dividing by it gives infinities or "
              "NaN. Long directions overflow likewise. t is in units of the direction, so no length is wrong.",
          .oracle = Oracle::sturm_chains,
          .run = run_direction_underflow,
          .draw = draw_direction_underflow};
}

HardCase sphere_scale() {
  return {.id = "sph-scale",
          .group = "sphere",
          .inputs = "random rays of float at a sphere of radius 1, everything times 2^64, 2^-80, 2^100 and 2^-200",
          .expected = "the t of the scene that is not scaled, to the last bit",
          .why =
              "Powers of two scale floats exactly, but the discriminant has the fourth power of lengths: times 2^64 "
              "it is infinite in float, times 2^-80 it is 0, and two roots become none or one.",
          .oracle = Oracle::metamorphic,
          .run = run_scale,
          .draw = draw_scale};
}

HardCase sphere_absolute_epsilon() {
  return {.id = "sph-abs-eps",
          .group = "sphere",
          .inputs = "radii 9e-6, 2^-20, 1e-9 and 1e-12, seen from a distance of 1",
          .expected = "hit",
          .why =
              "A limit like 1e-10 has a length in it, that of somebody's favourite scene. What is smaller is not "
              "there, however closely one looks.",
          .oracle = Oracle::rationals,
          .reference = "POV-Ray, sphere.cpp",
          .run = run_absolute_epsilon,
          .draw = draw_absolute_epsilon};
}

}  // namespace sightline::hard
