/// Rays from a sphere's surface and from next to it.

#include <array>
#include <cmath>

#include "sightline/math/random.h"
#include "tests/hard_cases/naive_sphere.h"
#include "tests/hard_cases/random_vectors.h"
#include "tests/hard_cases/solid_question.h"
#include "tests/hard_cases/sphere_parts.h"

namespace sightline::hard {
namespace {

// ---- sph-near-root

void run_near_root(Trial& trial) {
  Random random(21);
  const auto count = trial.count(1500);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec3d up = i == 0 ? Vec3d(0, 0, 1) : glm::normalize(random_in_cube(random));
    Vec3d direction = i == 0 ? Vec3d(0, 0, -1) : glm::normalize(random_in_cube(random));
    if (glm::dot(direction, up) > 0) direction = -direction;
    const Ray<double> ray = ray_of_floats((1 + 0x1p-22) * up, direction);
    const SolidQuestion question(solid::Sphere{}, ray, sturm_sphere_spans({}, ray));
    question.ask_first(trial, "sphere");
    question.judge_first(trial.naive("the formula from school, in float"),
                         first_root_ahead(naive_sphere_roots(Vec3f(0), 1.0f, ray_in_float(ray))));
  }
}

Sketch draw_near_root() {
  Sketch sketch{
      "A ray into a sphere from 2^-22 above its surface, drawn 1/8 above: the first root is the small "
      "difference of b and the root of the discriminant.",
      {}};
  return sketch.circle({0, 0}, 1)
      .line({-0.4, 1.06}, {0.8, -1.3}, Role::ray)
      .dot({-0.4, 1.06}, Role::aid)
      .dot({-0.339, 0.941})
      .dot({0.56, -0.828}, Role::naive)
      .label({-0.9, 1.2}, "origin")
      .label({-1.4, 0.6}, "true: t > 0, and tiny", Role::truth)
      .label({0.8, -0.8}, "in float often this one", Role::naive);
}

// ---- sph-on-surface

void run_on_surface(Trial& trial) {
  Random random(22);
  const auto count = trial.count(2000);
  const std::array points{Vec3d(0, 0, 1), Vec3d(1, 2, 2), Vec3d(3, 4, 0), Vec3d(2, 3, 6), Vec3d(1, 4, 8)};
  for (std::uint64_t i = 0; i < count; ++i) {
    // Truly on the surface, in whole numbers times a power of two.
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(40)) - 20);
    const Vec3d point = points[i % points.size()], center = glm::floor(8.0 * random_in_cube(random));
    const solid::Sphere sphere{scale * center, scale * glm::length(point)};
    const Ray<double> ray = ray_of_floats(scale * (center + point), random_in_cube(random));
    const SolidQuestion question(sphere, ray);
    question.ask_first(trial, "sphere, from on it");

    // As close to the surface as a computed hit is: then the rounded point decides, which is inside or outside.
    const Ray<float> eye{{0, 0, -3}, Vec3f(0.25 * random_in_cube(random)) + Vec3f(0, 0, 1)};
    const std::vector<double> roots = naive_sphere_roots(Vec3f(0), 1.0f, eye);
    if (roots.empty()) continue;
    const Vec3d hit(eye.at(static_cast<float>(roots[0])));
    const Ray<double> away = ray_of_floats(hit, glm::normalize(hit) + 0.9 * glm::normalize(random_in_cube(random)));
    const SolidQuestion next(solid::Sphere{}, away);
    next.ask_first(trial, "sphere, from a computed hit");
    const std::optional<double> again = first_root_ahead(naive_sphere_roots(Vec3f(0), 1.0f, ray_in_float(away)));
    trial.naive("a ray away from its hit, t > 0, in float").decide(!again, [&] {
      return Example{vector_text(hit) + " along " + vector_text(away.direction), "none",
                     again ? all_digits(*again) : "none"};
    });
  }
}

Sketch draw_on_surface() {
  Sketch sketch{
      "A ray leaves a sphere from a hit. The computed point is a little inside, so the sphere is hit again; "
      "the distance is drawn a million times too large.",
      {}};
  return sketch.circle({0, 0}, 1)
      .line({-2, 1.4}, {-0.6, 0.8}, Role::ray)
      .line({-0.55, 0.7}, {-0.9, 2}, Role::ray)
      .dot({-0.6, 0.8})
      .dot({-0.55, 0.7}, Role::aid)
      .dot({-0.62, 0.9}, Role::naive)
      .label({-0.4, 0.55}, "as rounded")
      .label({-0.4, 1.1}, "hit again: speckles", Role::naive)
      .label({-2.2, 0.6}, "on the surface t = 0 is no hit");
}

}  // namespace

HardCase sphere_near_root() {
  return {.id = "sph-near-root",
          .group = "sphere",
          .inputs = "radius 1, random rays of float downward from 1 + 2^-22 above the center",
          .expected = "the first root ahead, tiny and above 0 where the origin is outside, to its own last digits",
          .why =
              "t = -b - sqrt(b b - c) is the difference of two numbers that agree in all but their last digits: t is "
              "off by half of itself, or 0, or negative and lost. c / (-b + sqrt(b b - c)) is the same number, and "
              "nothing cancels.",
          .oracle = Oracle::sturm_chains,
          .reference = "Kahan, On the cost of floating-point computation without extra-precise arithmetic, 2004",
          .run = run_near_root,
          .draw = draw_near_root};
}

HardCase sphere_on_surface() {
  return {.id = "sph-on-surface",
          .group = "sphere",
          .inputs = "origins truly on spheres, in whole numbers times powers of two, and hits computed in float",
          .expected = "t = 0 is no hit; from a computed hit, what is true of that rounded point",
          .why =
              "A hit computed in float is not on the sphere but next to it, half of the time inside. From there a ray "
              "that leaves finds the sphere once more, at a t just above 0, which no test for t > 0 keeps out: "
              "acne. The rounded point has to be moved by what it may be off.",
          .oracle = Oracle::rationals,
          .reference = "Waechter and Binder, Ray Tracing Gems, chapter 6, 2019",
          .run = run_on_surface,
          .draw = draw_on_surface};
}

}  // namespace sightline::hard
