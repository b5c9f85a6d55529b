/// Quadrics that are almost flat, or two planes.

#include <cmath>

#include "tests/hard_cases/cylinder_parts.h"
#include "tests/hard_cases/random_vectors.h"
#include "tests/hard_cases/touching_roots.h"

namespace sightline::hard {
namespace {

/// Roots of a t^2 + b t + c, as renderers have had them: a below a limit is none.
std::vector<double> naive_roots(double a, double b, double c) {
  if (std::fabs(a) < 1e-10) return {-c / b};
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return {};
  const double root = std::sqrt(discriminant), one = (-b - root) / (2 * a), other = (-b + root) / (2 * a);
  return {std::min(one, other), std::max(one, other)};
}

// ---- quadric-threshold

void run_threshold(Trial& trial) {
  Random random(81);
  const auto count = trial.count(1000);
  const Ray<double> along_x{{0, 0, 0}, {1, 0, 0}};
  for (std::uint64_t i = 0; i < count; ++i) {
    double a = 1e-11, b = 1, c = -1;
    if (i > 0) {
      a = (i % 2 ? 1 : -1) * std::pow(10.0, -double(random.below(60))), b = 4 * random.uniform_double() - 2,
      c = 4 * random.uniform_double() - 2;
    }
    const SolidQuestion question(solid::Quadric{{a, 0, 0, 0, 0, 0, b, 0, 0, c}}, along_x);
    question.ask_spans(trial, "quadric");
    question.judge_spans(trial.naive("linear where |a| < 1e-10, in double"), naive_roots(a, b, c));
    // The same in all of space: coefficients of any sizes.
    solid::Quadric any;
    for (double& k : any.coefficients) {
      k = (2 * random.uniform_double() - 1) * std::pow(10.0, -double(random.below(20)));
    }
    SolidQuestion(any, {3.0 * random_in_cube(random), random_in_cube(random)}).ask_spans(trial, "quadric");
  }
}

Sketch draw_threshold() {
  Sketch sketch{"f(t) = a t^2 + t - 1, drawn with a = 1/8. For a = 1e-11 the left root is at -1e11.", {}};
  std::vector<glm::dvec2> curve;
  for (double t = -10.5; t <= 3; t += 0.25) curve.emplace_back(t, t * t / 8 + t - 1);
  return sketch.path(curve)
      .line({-11, 0}, {4, 0}, Role::ray)
      .dot({-8.899, 0})
      .dot({0.899, 0})
      .line({-3.5, -4.5}, {4, 3}, Role::naive)
      .label({-10.8, 0.7}, "lost where |a| < 1e-10 counts as 0", Role::naive);
}

// ---- quadric-crease

void run_crease(Trial& trial) {
  Random random(82);
  const auto count = trial.count(1000);
  const solid::Quadric crease{{1, -1, 0, 0, 0, 0, 0, 0, 0, 0}};
  const Solid solid(crease);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec3d at(0, 0, double(random.below(17)) - 8);
    Vec3d way = random_lattice_vector(random, 100);
    if (i % 4 == 0) way.z = 0;
    if (way.x == way.y || way.x == -way.y) continue;  // within one of the planes, or along the crease
    const double t = 1 + random.below(7);
    const Ray<double> ray{at - t * way, way};
    SolidQuestion(crease, ray).ask_spans(trial, "quadric");
    SolidQuestion(~SolidTree(crease), ray).ask_spans(trial, "complement of the quadric");
    ask_touch(trial, "roots of the quadric", crease, ray, t);
    // Beside the crease there are two planes, however near.
    Ray<double> beside = ray;
    beside.origin.x += std::ldexp(1.0, -static_cast<int>(random.below(44)));
    SolidQuestion(crease, beside).ask_spans(trial, "quadric");

    const Vec3d point = ray.at(t), gradient(2 * point.x, -2 * point.y, 0);
    const Example expected{text_of(ray), "a normal of length 1, against the ray", ""};
    const auto judge = [&](Tally& tally, const Vec3d& normal) {
      // As in cone-generator: three roundings of each component, and as many of the length.
      tally.decide(std::fabs(glm::dot(normal, normal) - 1) <= 0x1p-50 && glm::dot(normal, way) < 0, [&] {
        return Example{expected.inputs, expected.expected, vector_text(normal)};
      });
    };
    judge(trial.of("normals"), solid.normal(Boundary(t, 0, 0, 0, 0), ray));
    judge(trial.naive("the gradient over its length, in double"), gradient / glm::length(gradient));
  }
}

Sketch draw_crease() {
  Sketch sketch{"x^2 = y^2 from above: two planes, which meet in a crease. Inside is where |x| <= |y|.", {}};
  return sketch.line({-2, -2}, {2, 2}, Role::shape)
      .line({-2, 2}, {2, -2}, Role::shape)
      .line({-3, -1}, {3, 1}, Role::ray)
      .line({-0.8, -3}, {0.8, 3}, Role::ray)
      .dot({0, 0})
      .label({0.2, -0.3}, "touched, by both: nothing begins or ends")
      .label({0.2, -1.2}, "gradient (0, 0, 0): normal 0 / 0", Role::naive)
      .label({-0.5, 2.2}, "in");
}

}  // namespace

HardCase quadric_threshold() {
  return {
      .id = "quadric-threshold",
      .group = "cylinder",
      .inputs = "a x^2 + x - 1 with a = 1e-11, and random a down to 1e-59; random quadrics of ten such coefficients",
      .expected = "two roots, -1e11 and 1 - 1e-11; one only where a is 0",
      .why =
          "A limit below which a counts as 0 knows nothing of b and c, nor of the units that the scene was drawn "
          "in: large curved things become flat, and their far side is gone. Roots as q / a and c / q need no "
          "limit.",
      .oracle = Oracle::rationals,
      .reference = "POV-Ray, quadric.cpp",
      .run = run_threshold,
      .draw = draw_threshold};
}

HardCase quadric_crease() {
  return {
      .id = "quadric-crease",
      .group = "cylinder",
      .inputs = "x^2 - y^2 <= 0; whole rays through the crease, and 2^-k beside it",
      .expected =
          "a double root at the crease, where nothing is entered; two beside it; a normal against the ray where "
          "the surface has none",
      .why =
          "Where two sheets cross the gradient is 0, and as a normal 0 / 0: one black pixel, which a filter makes a "
          "black spot. And the discriminant is 0 for each ray there, as at an apex.",
      .oracle = Oracle::rationals,
      .run = run_crease,
      .draw = draw_crease};
}

}  // namespace sightline::hard
