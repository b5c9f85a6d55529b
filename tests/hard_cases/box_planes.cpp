/// Rays in planes of a box's faces, and directions that have no reciprocal.

#include <cmath>

#include "sightline/math/random.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/box_parts.h"
#include "tests/hard_cases/box_question.h"
#include "tests/hard_cases/naive_slabs.h"
#include "tests/hard_cases/naive_sphere.h"

namespace sightline::hard {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

void decide_hit(Tally& tally, const Ray<double>& ray, bool truth, bool is_hit) {
  tally.decide(is_hit == truth, [&] { return Example{text_of(ray), truth ? "hit" : "miss", is_hit ? "hit" : "miss"}; });
}

/// Along an axis, in the plane of a face of the box.
Ray<double> ray_in_face(const Aabb& box, int axis, int other, bool is_high, double way, double zero) {
  Ray<double> ray{Vec3d(box.center()), Vec3d(zero)};
  ray.direction[axis] = way;
  ray.origin[axis] = -16 * way;
  ray.origin[other] = is_high ? box.hi[other] : box.lo[other];
  return ray;
}

template <class Ask>
void for_rays_in_faces(const Aabb& box, Ask&& ask) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
      for (const bool is_high : {false, true}) {
        for (const double way : {1.0, -1.0}) {
          for (const double zero : {0.0, -0.0}) ask(ray_in_face(box, axis, other, is_high, way, zero));
        }
      }
    }
  }
}

Sketch sketch_of_ray_in_face(std::string caption, std::string naive) {
  Sketch sketch{std::move(caption), {}};
  return sketch.rectangle({0, 0}, {3, 2})
      .line({-2, 2}, {5, 2}, Role::ray)
      .line({0, 2}, {3, 2}, Role::truth)
      .dot({0, 2})
      .dot({3, 2})
      .label({0.6, 2.2}, "true: in the closed box", Role::truth)
      .label({-2, -0.5}, std::move(naive), Role::naive);
}

// ---- box-face-plane

void run_face_plane(Trial& trial) {
  const Aabb box{Vec3f(-1), Vec3f(1)};
  const BoxesByStructure boxes = boxes_around(box, 4);
  for_rays_in_faces(box, [&](const Ray<double>& ray) {
    const SolidQuestion question(solid_of(box), ray);
    question.ask_spans(trial, "box");
    ask_box_set(trial, box, question);
    ask_volume_tests(trial, box, box, ray_in_float(ray));
    ask_structures(trial, boxes, ray);
    decide_hit(trial.naive("slabs by min and max, in float"), ray, true, naive_slabs(box, ray_in_float(ray)).is_hit());
  });
}

Sketch draw_face_plane() {
  return sketch_of_ray_in_face("A ray along an axis, in the plane of a face.",
                               "(plane - o) / d = 0 / 0 = NaN: min and max take either side");
}

// ---- box-fma-residual

/// As some traversals do: 1 / 0 is replaced by 1e30, and o / d is made once a ray.
bool fused_slabs_hit(const Aabb& box, const Ray<float>& ray) {
  float enter = 0, leave = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    const float inverse = ray.direction[axis] == 0 ? 1e30f : 1 / ray.direction[axis];
    const float offset = -ray.origin[axis] * inverse;
    const float a = std::fma(box.lo[axis], inverse, offset), b = std::fma(box.hi[axis], inverse, offset);
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

Aabb random_box(Random& random) {
  Aabb box;
  for (int i = 0; i < 2; ++i) {
    const float x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    box.extend(Vec3f(x, y, random.uniform(-1, 1)));
  }
  return box;
}

void run_fma_residual(Trial& trial) {
  Random random(41);
  const auto count = trial.count(60);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Aabb box = random_box(random);
    std::optional<BoxesByStructure> boxes;
    if (i < 3) boxes.emplace(boxes_around(box, 4));
    for_rays_in_faces(box, [&](Ray<double> ray) {
      ray = ray_of_floats(ray.origin, ray.direction);
      const SolidQuestion question(solid_of(box), ray);
      question.ask_spans(trial, "box");
      ask_box_set(trial, box, question);
      ask_volume_tests(trial, box, box, ray_in_float(ray));
      if (boxes) ask_structures(trial, *boxes, ray);
      decide_hit(trial.naive("slabs by fma, 1 / 0 = 1e30"), ray, true, fused_slabs_hit(box, ray_in_float(ray)));
    });
  }
}

Sketch draw_fma_residual() {
  return sketch_of_ray_in_face(
      "A ray in the plane of a face, y = 0.7 say, with 1e30 for 1 / 0.",
      "fma(0.7, 1e30, -round(0.7 1e30)) = -+ 3e22, not 0: entered far ahead, or left long ago");
}

// ---- box-safe-rcp

/// As a header does that wants no infinities.
bool safe_slabs_hit(const Aabb& box, const Ray<float>& ray) {
  float enter = 0, leave = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    const float d = ray.direction[axis];
    const bool is_small = std::fabs(d) <= std::numeric_limits<float>::epsilon();
    const float inverse = is_small ? std::copysign(std::numeric_limits<float>::max(), d) : 1 / d;
    const float a = (box.lo[axis] - ray.origin[axis]) * inverse, b = (box.hi[axis] - ray.origin[axis]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave && std::isfinite(enter);
}

void run_safe_reciprocal(Trial& trial) {
  const Aabb box{{0.75f, 1.75f, 3.5f}, {1.125f, 2.25f, 5}};
  const BoxesByStructure boxes = boxes_around(box, 10);
  for (int k = 0; k <= 60; ++k) {
    const double length = std::ldexp(1e-8, -k);
    const Ray<double> ray = ray_of_floats({0, 0, 0}, {length, 2 * length, 4 * length});
    const SolidQuestion question(solid_of(box), ray);
    question.ask_spans(trial, "box");
    ask_box_set(trial, box, question);
    ask_volume_tests(trial, box, box, ray_in_float(ray));
    ask_structures(trial, boxes, ray);
    decide_hit(trial.naive("reciprocals no larger than the largest float"), ray, true,
               safe_slabs_hit(box, ray_in_float(ray)));
  }
}

Sketch draw_safe_reciprocal() {
  Sketch sketch{"A ray whose direction is 1e-8 (1, 2, 4), drawn longer, in the plane of x and y.", {}};
  return sketch.rectangle({0.75, 1.75}, {1.125, 2.25})
      .line({0, 0}, {1.5, 3}, Role::ray)
      .dot({0.875, 1.75})
      .dot({1.125, 2.25})
      .dot({0, 0}, Role::aid)
      .label({1.2, 1.8}, "true: t in [8.75e7, 1.125e8]", Role::truth)
      .label({-0.6, -0.4}, "`too small for 1 / d`: t = infinity, missed", Role::naive);
}

// ---- box-denormal-dir

/// By plane / d - o / d, keeping the range where that is NaN.
bool careful_slabs_hit(const Aabb& box, const Ray<float>& ray) {
  float enter = 0, leave = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    const float inverse = 1 / ray.direction[axis], offset = ray.origin[axis] * inverse;
    float near = box.lo[axis] * inverse - offset, far = box.hi[axis] * inverse - offset;
    if (near > far) std::swap(near, far);
    if (near > enter) enter = near;
    if (far < leave) leave = far;
  }
  return enter <= leave;
}

void run_denormal_direction(Trial& trial) {
  const Aabb box{Vec3f(-0.5f), Vec3f(0.5f)};
  const BoxesByStructure boxes = boxes_around(box, 8);
  for (int k = 130; k <= 148; ++k) {
    const double tiny = std::ldexp(1.0, -k);
    for (const double aside : {0.0, 0.25}) {
      for (const Vec3d& direction : {Vec3d(tiny, 0, 0), Vec3d(-tiny, 0, 0), Vec3d(tiny, 1, 0), Vec3d(-tiny, 1, 0)}) {
        const Ray<double> ray{{1, direction.y == 0 ? aside : -2, aside}, direction};
        const SolidQuestion question(solid_of(box), ray);
        question.ask_first(trial, "box");
        ask_box_set(trial, box, question);
        const bool is_ahead = question.first_end().has_value();
        ask_structures(trial, boxes, ray);
        if (!is_ahead) {
          decide_hit(trial.naive("slabs by plane / d - o / d, past NaN"), ray, false,
                     careful_slabs_hit(box, ray_in_float(ray)));
        }
      }
    }
  }
}

Sketch draw_denormal_direction() {
  Sketch sketch{"A ray beside a box, away from it, by a direction of 2^-140, drawn longer.", {}};
  return sketch.rectangle({-0.5, -0.5}, {0.5, 0.5})
      .line({1, 0}, {2.5, 0}, Role::ray)
      .dot({1, 0}, Role::aid)
      .label({1, 0.2}, "origin, true: miss")
      .label({-0.6, -0.9}, "1 / d is infinite: infinity - infinity = NaN bounds nothing, so it is a hit", Role::naive);
}

}  // namespace

HardCase box_face_plane() {
  return {.id = "box-face-plane",
          .group = "box",
          .inputs = "the box from -1 to 1, 48 rays along axes in planes of its faces, zeros of both signs",
          .expected = "in the closed box from face to face: t = 15 and 17 from 16 away",
          .why =
              "For the slab whose plane the ray lies in, (plane - o) / d is 0 / 0. What min and max make of NaN "
              "depends on the order of their arguments: half of the rays are lost, or two thirds. Comparisons have to "
              "be written so that NaN bounds nothing.",
          .oracle = Oracle::rationals,
          .reference = "Williams, Barrus, Morley and Shirley, An Efficient and Robust Ray-Box Intersection, 2005",
          .run = run_face_plane,
          .draw = draw_face_plane};
}

HardCase box_fma_residual() {
  return {.id = "box-fma-residual",
          .group = "box",
          .inputs = "random boxes of floats, rays along axes in planes of their faces",
          .expected = "hit",
          .why =
              "fma(plane, 1 / d, -o / d) rounds the two products differently: one exactly, one not. Where plane = o "
              "the difference should be 0 and is a rounding error, which 1 / d = 1e30 makes larger than any scene.",
          .oracle = Oracle::rationals,
          .reference = "tinybvh, SLAB_TEST_TWO_NODES; Embree's fast path",
          .run = run_fma_residual,
          .draw = draw_fma_residual};
}

HardCase box_safe_reciprocal() {
  return {
      .id = "box-safe-rcp",
      .group = "box",
      .inputs = "the box (0.75, 1.75, 3.5) to (1.125, 2.25, 5), origin 0, directions 1e-8 2^-k (1, 2, 4), k = 0 ... 60",
      .expected = "for k = 0 t from 8.75e7 to 1.125e8",
      .why =
          "A reciprocal `made safe` by calling every |d| below 1.2e-7 zero takes a short direction for none: "
          "planes are reached at infinity. Directions need not be normalized, so none is too short by itself.",
      .oracle = Oracle::rationals,
      .reference = "madmann91/bvh, safe_inverse",
      .run = run_safe_reciprocal,
      .draw = draw_safe_reciprocal};
}

HardCase box_denormal_direction() {
  return {.id = "box-denormal-dir",
          .group = "box",
          .inputs = "the box from -1/2 to 1/2, origins at x = 1, directions (+-2^-k, 0 or 1, 0), k = 130 ... 148",
          .expected = "outward and aside: miss; inward: hit at 2^(k - 1)",
          .why =
              "1 / 2^-140 is more than the largest float: infinite. Then plane / d - o / d is infinity less infinity, "
              "and code that goes past NaN, as rays in faces ask for, keeps a box that lies behind the ray.",
          .oracle = Oracle::rationals,
          .run = run_denormal_direction,
          .draw = draw_denormal_direction};
}

}  // namespace sightline::hard
