/// Cones through their apex, along their sides, and past their other nappe.

#include <cmath>

#include "tests/csg/evaluate.h"
#include "tests/hard_cases/cylinder_parts.h"
#include "tests/hard_cases/naive_sphere.h"
#include "tests/hard_cases/random_vectors.h"
#include "tests/hard_cases/touching_roots.h"

namespace sightline::hard {
namespace {

/// Both nappes of x^2 + y^2 = z^2, by the formula from school; contracted as compilers do by themselves where the
/// processor has a fused multiply-add.
std::vector<float> naive_cone_roots(const Vec3f& o, const Vec3f& d, bool is_contracted) {
  const float a = d.x * d.x + d.y * d.y - d.z * d.z, b = o.x * d.x + o.y * d.y - o.z * d.z;
  const float c = o.x * o.x + o.y * o.y - o.z * o.z;
  const float discriminant = is_contracted ? std::fma(b, b, -(a * c)) : b * b - a * c;
  if (discriminant < 0) return {};
  const float root = std::sqrt(discriminant);
  return {(-b - root) / a, (-b + root) / a};
}

std::vector<double> widened(const std::vector<float>& roots) { return {roots.begin(), roots.end()}; }

Vec3d whole_direction(Random& random, std::uint32_t size) {
  for (;;) {
    const Vec3d v = random_lattice_vector(random, size);
    if (v != Vec3d(0)) return v;
  }
}

/// From the side: the half planes' edges through the apex.
Sketch& draw_nappes(Sketch& sketch) {
  return sketch.polygon({{0, 0}, {-2, -2}, {2, -2}})
      .line({0, 0}, {2, 2}, Role::aid)
      .line({0, 0}, {-2, 2}, Role::aid)
      .label({0.9, 1.8}, "the other nappe, which is not there");
}

// ---- cone-apex

/// Whether the formula meets the apex at all.
void judge_apex(Tally& tally, const Ray<double>& ray, bool is_contracted) {
  const std::vector<float> roots = naive_cone_roots(Vec3f(ray.origin), Vec3f(ray.direction), is_contracted);
  tally.decide(!roots.empty(), [&] { return Example{text_of(ray), "the apex, twice", all_digits(widened(roots))}; });
}

void run_apex(Trial& trial) {
  Random random(71);
  const auto count = trial.count(800);
  for (std::uint64_t i = 0; i < count; ++i) {
    // Any whole cone, and t in halves.
    const Vec3d apex = random_lattice_vector(random, 16) / 8.0, direction = whole_direction(random, 16);
    const double t = 0.5 * (1 + random.below(8));
    const solid::Cone cone{apex, apex + whole_direction(random, 16), 0.5 * (1 + random.below(20))};
    const Ray<double> ray{apex - t * direction, direction};
    SolidQuestion(cone, ray).ask_spans(trial, "cone");
    // A line in the side itself touches it everywhere: it has no root, and is asked by spans alone.
    const Vec3d axis = cone.base - cone.apex, across = glm::cross(direction, axis);
    const double length2 = glm::dot(axis, axis), rise = cone.radius * glm::dot(direction, axis);
    if (length2 * glm::dot(across, across) != rise * rise) ask_touch(trial, "roots of the side", cone, ray, t);

    // The cone of 45 degrees, and floats whose squares have to be rounded.
    const Vec3d far_way = whole_direction(random, 40000);
    const Ray<double> far{-3.0 * far_way, far_way};
    SolidQuestion(solid::Cone{{0, 0, 0}, {0, 0, -2e5}, 2e5}, far).ask_spans(trial, "cone");
    judge_apex(trial.naive("the formula from school in float, contracted"), far, true);
  }
}

Sketch draw_apex() {
  Sketch sketch{"A cone from the side, and rays through its apex: across it, and into it.", {}};
  return draw_nappes(sketch)
      .line({-3, 0.9}, {3, -0.9}, Role::ray)
      .line({0.6, 3}, {-0.6, -3}, Role::ray)
      .dot({0, 0})
      .dot({-0.4, -2})
      .label({-3, 1.1}, "touches")
      .label({0.1, -0.8}, "b b - a c: 0, or less by a rounding", Role::naive);
}

// ---- cone-generator

void run_generator(Trial& trial) {
  Random random(72);
  const auto count = trial.count(800);
  const solid::Quadric both{{1, 1, -1, 0, 0, 0, 0, 0, 0, 0}};
  const solid::Cone lower{{0, 0, 0}, {0, 0, -2}, 2};
  for (std::uint64_t i = 0; i < count; ++i) {
    // Along a side: 3, 4, 5, and 1, 0, 1.
    const Vec3d along[] = {{1, 0, 1}, {3, 4, 5}, {-5, 12, 13}, {0, -1, 1}, {8, -15, -17}};
    const Vec3d way = along[i % 5];
    const Ray<double> ray{i == 0 ? Vec3d(3, 0, 0) : random_lattice_vector(random, 12) / 4.0, way};
    const SolidQuestion question(both, ray);
    question.ask_spans(trial, "both nappes");
    SolidQuestion(lower, ray).ask_spans(trial, "cone");
    question.judge_spans(trial.naive("the formula from school, in float"),
                         widened(naive_cone_roots(Vec3f(ray.origin), Vec3f(way), false)));
    // In the side itself: with it, from the apex on, and normals where there is none.
    const Ray<double> within{double(random.below(5)) * way, way};
    const SolidQuestion in_side(lower, within);
    in_side.ask_spans(trial, "cone");
    const Solid solid(lower);
    for (const Level level : all_levels) {
      for (const Boundary& boundary : spans_of(solid, within, level).boundaries) {
        const Vec3d normal = solid.normal(boundary, within);
        // Three roundings of each component, and as many of the length.
        trial.of("normals").decide(std::fabs(glm::dot(normal, normal) - 1) <= 0x1p-50, [&] {
          return Example{text_of(within), "a normal of length 1", vector_text(normal)};
        });
      }
    }
  }
}

Sketch draw_generator() {
  Sketch sketch{"A cone from the side, and a ray parallel to one of its sides: it meets the other one, once.", {}};
  return draw_nappes(sketch)
      .line({-0.5, -3.5}, {4, 1}, Role::ray)
      .dot({1.5, -1.5})
      .label({1.8, -1.6}, "t = -1.5")
      .label({-2, -3}, "a = 0: -6 / 0 and 0 / 0", Role::naive);
}

// ---- cone-nappe

void run_nappe(Trial& trial) {
  const solid::Cone lower{{0, 0, 0}, {0, 0, -2}, 2};
  Random random(73);
  const auto count = trial.count(1500);
  for (std::uint64_t i = 0; i < count; ++i) {
    // Through a point of the upper half, mostly level, so that many meet nothing else.
    const Vec3d target(0, 0, 1 + random.below(4));
    Vec3d way = random_lattice_vector(random, 16);
    if (i % 2) way.z = 0;
    if (way.x == 0 && way.y == 0) way.x = 1;
    const Ray<double> ray{target - 2.0 * way, way};
    const SolidQuestion question(lower, ray);
    question.ask_spans(trial, "cone");
    question.ask_first(trial, "cone's first boundary");
    question.judge_first(trial.naive("the side without a look at its nappe, in double"), [&] {
      const Vec3d &o = ray.origin, &d = ray.direction;
      const double a = d.x * d.x + d.y * d.y - d.z * d.z, b = o.x * d.x + o.y * d.y - o.z * d.z;
      const double c = o.x * o.x + o.y * o.y - o.z * o.z, root = std::sqrt(b * b - a * c);
      return first_root_ahead({(-b - root) / a, (-b + root) / a});
    }());
  }
}

Sketch draw_nappe() {
  Sketch sketch{"A cone from the side, and a ray through the nappe that squaring has added.", {}};
  return draw_nappes(sketch)
      .line({-3, 1}, {3, 1}, Role::ray)
      .dot({-1, 1}, Role::naive)
      .dot({1, 1}, Role::naive)
      .label({-2.9, 1.2}, "a ghost cone", Role::naive)
      .label({1.3, 0.7}, "true: none", Role::truth);
}

}  // namespace

HardCase cone_apex() {
  return {
      .id = "cone-apex",
      .group = "cylinder",
      .inputs =
          "whole cones, and whole rays through the apex at t = 1/2, 1, ... 4; x^2 + y^2 = z^2 and directions to 40000",
      .expected = "a double root at the apex; inside or outside before and after it as real arithmetic has it",
      .why =
          "Every line through the apex has a discriminant of 0. Rounded alike, b b and a c are the same float and it "
          "stays 0; contracted to one multiply-add it is the rounding error of the other product, which is below 0 "
          "for one line in two.",
      .oracle = Oracle::rationals,
      .run = run_apex,
      .draw = draw_apex};
}

HardCase cone_generator() {
  return {
      .id = "cone-generator",
      .group = "cylinder",
      .inputs = "x^2 + y^2 = z^2; o = (3, 0, 0), d = (1, 0, 1), and others along (3, 4, 5), (-5, 12, 13) and the like",
      .expected = "t = -1.5, and no other root: c / -2 b of the linear equation",
      .why =
          "Parallel to a side a is 0, and the formula from school divides by it. Near to 0, one root goes to "
          "infinity, which is right; the other one is the difference of two equal numbers over a tiny one, "
          "which is noise. The root is c / q, not q / a.",
      .oracle = Oracle::rationals,
      .run = run_generator,
      .draw = draw_generator};
}

HardCase cone_nappe() {
  return {.id = "cone-nappe",
          .group = "cylinder",
          .inputs = "a cone from (0, 0, 0) down to z = -2; rays through (0, 0, 1) ... (0, 0, 4), many of them level",
          .expected = "roots of the lower nappe alone",
          .why =
              "|q x a|^2 = k^2 (q.a)^2 has lost the sign of q.a, and so holds on both sides of the apex. The other "
              "side is cut off by a plane through the apex, as part of the solid, and not by a look at a rounded "
              "point.",
          .oracle = Oracle::rationals,
          .run = run_nappe,
          .draw = draw_nappe};
}

}  // namespace sightline::hard
