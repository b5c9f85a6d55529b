/// Faces of boxes.

#include <cmath>

#include "sightline/math/random.h"
#include "tests/csg/evaluate.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/box_parts.h"
#include "tests/hard_cases/box_question.h"
#include "tests/hard_cases/naive_slabs.h"
#include "tests/hard_cases/naive_sphere.h"
#include "tests/hard_cases/random_vectors.h"

namespace sightline::hard {
namespace {

using Rational = boost::multiprecision::cpp_rational;

constexpr double infinity = std::numeric_limits<double>::infinity();

// ---- box-flat

void run_flat(Trial& trial) {
  const Aabb flat{{0, 0, 1}, {1, 1, 1}};
  const BoxesByStructure boxes = boxes_around(flat, 4);
  Random random(52);
  const auto count = trial.count(300);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec3d through(0.1 + 0.8 * random.uniform_double(), 0.1 + 0.8 * random.uniform_double(), 1);
    const Vec3d origin = i == 0 ? Vec3d(0.5, 0.5, -1) : Vec3d(random_in_cube(random)) - Vec3d(0, 0, 1.5);
    const Ray<double> ray = ray_of_floats(origin, i == 0 ? Vec3d(0, 0, 1) : through - origin);
    // A solid with no inside is none; a primitive is met where its plane is.
    SolidQuestion(solid_of(flat), ray).ask_spans(trial, "box");
    const Rational t = (1 - Rational(ray.origin.z)) / Rational(ray.direction.z);
    TrueSpans truth{false, {true_number(t), true_number(t)}, {}};
    truth.round_ends();
    const SolidQuestion question(solid_of(flat), ray, truth);
    ask_box_set(trial, flat, question);
    ask_volume_tests(trial, flat, flat, ray_in_float(ray));
    ask_triangles(trial, boxes, question);
    const NaiveSlabs<float> slabs = naive_slabs(flat, ray_in_float(ray));
    question.judge_first(trial.naive("hit where enter < leave"),
                         slabs.enter < slabs.leave ? slabs.first() : std::nullopt);
  }
}

Sketch draw_flat() {
  Sketch sketch{"A box without height, as around a floor, from the side.", {}};
  return sketch.line({0, 1}, {4, 1}, Role::shape)
      .line({2, -1}, {2, 2}, Role::ray)
      .dot({2, 1})
      .label({2.2, 1.2}, "true: entered and left at t = 2", Role::truth)
      .label({2.2, 0.4}, "enter < leave is false: no floor", Role::naive);
}

// ---- box-origin-on-face

void run_origin_on_face(Trial& trial) {
  const Aabb box{Vec3f(-1), Vec3f(1)};
  const BoxesByStructure boxes = boxes_around(box, 4);
  Random random(54);
  const auto count = trial.count(400);
  for (std::uint64_t i = 0; i < count; ++i) {
    const int axis = static_cast<int>(random.below(3));
    Vec3d origin = 0.9 * random_in_cube(random), direction = random_in_cube(random);
    origin[axis] = i % 2 ? 1 : -1;
    if (i % 8 < 2) {
      direction = Vec3d(0);
      direction[axis] = i % 8 == 0 ? 1 : -1;
    }
    const Ray<double> ray = ray_of_floats(origin, direction);
    const SolidQuestion question(solid_of(box), ray);
    question.ask_spans(trial, "box");
    question.ask_first(trial, "box, ahead");
    ask_box_set(trial, box, question);
    ask_volume_tests(trial, box, box, ray_in_float(ray));
    if (i % 2 == 0) ask_triangles(trial, boxes, SolidQuestion(boxes.solids().tree(), ray));
    question.judge_first(trial.naive("the entry where it is >= 0, else the exit"), naive_slabs(box, ray).first());
  }
}

Sketch draw_origin_on_face() {
  Sketch sketch{"Rays that begin on a face, one into the box and one away from it.", {}};
  return sketch.rectangle({-1, -1}, {1, 1})
      .line({1, 0.3}, {-2, 0.3}, Role::ray)
      .line({1, -0.3}, {3, -0.3}, Role::ray)
      .dot({-1, 0.3})
      .dot({1, 0.3}, Role::naive)
      .dot({1, -0.3}, Role::naive)
      .label({1.1, 0.4}, "t = 0: found again", Role::naive)
      .label({-2.4, 0.5}, "true: t = 2", Role::truth)
      .label({1.2, -0.6}, "true: none", Role::truth);
}

// ---- box-normal-eps

/// The axis of the slab entered last; -1 where two are entered at once.
int entered_axis(const Aabb& box, const Ray<double>& ray) {
  int found = -1;
  Rational last;
  for (int axis = 0; axis < 3; ++axis) {
    const Rational d(ray.direction[axis]);
    if (d == 0) continue;
    const Rational enter = (Rational(d > 0 ? box.lo[axis] : box.hi[axis]) - Rational(ray.origin[axis])) / d;
    if (found >= 0 && enter == last) return -1;
    if (found < 0 || enter > last) last = enter, found = axis;
  }
  return found;
}

/// The axis of the face that a point is on, as one looks for it first.
int nearby_face(const Aabb& box, const Vec3f& p) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::fabs(p[axis] - box.lo[axis]) < 1e-6f || std::fabs(p[axis] - box.hi[axis]) < 1e-6f) return axis;
  }
  return -1;
}

void run_normal_epsilon(Trial& trial) {
  const Aabb box{Vec3f(0.1f), Vec3f(1.1f)};
  const Solid solid(solid_of(box));
  Random random(55);
  const auto count = trial.count(1000);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec3d target = Vec3d(0.6) + 0.4 * random_in_cube(random);
    const Vec3d origin = target + 1000.0 * random_on_sphere(random);
    const Ray<double> ray = ray_of_floats(origin, glm::normalize(target - origin));
    const int axis = entered_axis(box, ray);
    const auto clip = true_clip(box, ray);
    if (axis < 0 || !clip || clip->enter == clip->leave) continue;
    Vec3d truth(0);
    truth[axis] = ray.direction[axis] > 0 ? -1 : 1;
    for (const Level level : all_levels) {
      const auto first = first_of(solid, ray, 0, infinity, level);
      const Vec3d normal = first ? solid.normal(*first, ray) : Vec3d(0);
      trial.of("normal of the box", level).decide(normal == truth, [&] {
        return Example{text_of(ray), vector_text(truth), first ? vector_text(normal) : "no hit"};
      });
    }
    const Ray<float> narrow = ray_in_float(ray);
    const int face = nearby_face(box, narrow.at(naive_slabs(box, narrow).enter));
    trial.naive("the face within 1e-6 of the point, in float").decide(face == axis, [&] {
      return Example{text_of(ray), std::string(1, "xyz"[axis]), face < 0 ? "none" : std::string(1, "xyz"[face])};
    });
  }
}

Sketch draw_normal_epsilon() {
  Sketch sketch{"A hit on a box seen from 1000 units away, as rounded to float: larger than true.", {}};
  return sketch.rectangle({0, 0}, {3, 2})
      .line({-3, 1.6}, {0, 1}, Role::ray)
      .dot({0, 1})
      .dot({0.3, 0.94}, Role::naive)
      .line({0, 1}, {-1, 1}, Role::truth)
      .label({-2.4, 0.7}, "true normal: of the slab entered last", Role::truth)
      .label({0.5, 0.9}, "on no face within 1e-6", Role::naive);
}

}  // namespace

HardCase box_flat() {
  return {.id = "box-flat",
          .group = "box",
          .inputs = "the box from (0, 0, 1) to (1, 1, 1), the ray from (0.5, 0.5, -1) along z and random ones",
          .expected = "as a volume, a primitive and triangles: met at t = 2; as a solid: nothing, it has no inside",
          .why =
              "In a flat box a ray enters and leaves at the same t. `enter < leave` is false there, and every floor "
              "along the axes vanishes; some programs pad such boxes, by a number that fits one scene.",
          .oracle = Oracle::rationals,
          .reference = "Shirley, Ray Tracing: The Next Week, aabb pad",
          .run = run_flat,
          .draw = draw_flat};
}

HardCase box_origin_on_face() {
  return {.id = "box-origin-on-face",
          .group = "box",
          .inputs = "the box from -1 to 1, origins on its faces, rays inward and outward",
          .expected = "the boundary at t = 0 is there and is not ahead: inward the exit is first, outward nothing",
          .why =
              "The entry or the exit is at t = 0 exactly. Tests with >= find the face that the ray starts from once "
              "more; tests that drop the whole box lose the way out.",
          .oracle = Oracle::rationals,
          .run = run_origin_on_face,
          .draw = draw_origin_on_face};
}

HardCase box_normal_epsilon() {
  return {.id = "box-normal-eps",
          .group = "box",
          .inputs = "a box of size 1 seen from 1000 away, random rays of float",
          .expected = "the normal of the slab that is entered last",
          .why =
              "A point 1000 away is known to 6e-5 in float: it is within 1e-6 of no face, so it has no normal, or by "
              "luck another face's. Which slab was entered last is known from the test, and needs no point.",
          .oracle = Oracle::rationals,
          .run = run_normal_epsilon,
          .draw = draw_normal_epsilon};
}

}  // namespace sightline::hard
