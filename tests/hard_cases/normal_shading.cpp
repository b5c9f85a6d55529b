/// Normals that are moved with their surface, and those that are interpolated.

#include <cmath>
#include <glm/mat3x3.hpp>

#include "sightline/math/random.h"
#include "sightline/math/transform.h"
#include "sightline/texture/normal_map.h"
#include "sightline/texture/tangent_frame.h"
#include "tests/hard_cases/normal_parts.h"
#include "tests/hard_cases/wide_vector.h"

namespace sightline::hard {
namespace {

// ---- nm-nonuniform

void run_nonuniform_scale(Trial& trial) {
  Random random(94);
  for (std::uint64_t i = 0, count = trial.count(4000); i < count; ++i) {
    Vec3d scale(1), n = i % 2 == 0 ? glm::normalize(Vec3d(1, 1, 0)) : random_on_sphere(random);
    scale[static_cast<int>(i % 3)] = i < 3 ? 100 : std::ldexp(1 + random.uniform_double(), int(random.below(40)) - 20);
    if (random.below(3) == 0) scale[static_cast<int>(random.below(3))] *= -1;
    const WideVec truth = unit({Wide(n.x) / scale.x, Wide(n.y) / scale.y, Wide(n.z) / scale.z});
    const std::string inputs = "n = " + vector_text(n) + ", scaled by " + vector_text(scale);
    const glm::dmat3 linear(Vec3d(scale.x, 0, 0), Vec3d(0, scale.y, 0), Vec3d(0, 0, scale.z));
    judge_unit(trial.of("transform_normal"), transform_normal(linear, n), truth, inputs);
    Vec3d carried = Transform::scaling(scale).normal(n);
    normalize_safely(carried);
    judge_unit(trial.of("Transform::normal"), carried, truth, inputs);
    judge_unit(trial.naive("the matrix times the normal"), glm::normalize(linear * n), truth, inputs, 0x1p-19);
  }
}

Sketch draw_nonuniform_scale() {
  Sketch sketch{"A slope of 45 degrees, stretched along x; here 4:1, in the case 100:1.", {}};
  return sketch.line({-5, 1}, {-3, -1}, Role::shape)
      .line({-4, 0}, {-3.2, 0.8}, Role::ray)
      .line({-1, 1}, {7, -1}, Role::shape)
      .line({3, 0}, {3.28, 1.1}, Role::truth)
      .line({3, 0}, {4.1, 0.28}, Role::naive)
      .label({-3.1, 0.9}, "n")
      .label({2.2, 1.3}, "by the inverse transpose", Role::truth)
      .label({4.3, 0.35}, "moved like a point: in the surface", Role::naive);
}

// ---- interp-normal-below

/// What facing_normal is to be of normals on one side of the surface, in fifty digits.
WideVec facing_truth(const Vec3d& shading, const Vec3d& viewer) {
  const WideVec n = wide(shading), w = wide(viewer);
  return dot(n, w) > 0 ? n : sum(1, n, -2 * dot(n, w) / dot(w, w), w);
}

void run_interpolated_below(Trial& trial) {
  Random random(95);
  for (std::uint64_t i = 0, count = trial.count(4000); i < count; ++i) {
    const Vec3d geometric = random_on_sphere(random), viewer = random_on_sphere(random);
    // Every other one so that the viewer is below what the normal says.
    Vec3d shading = random_on_sphere(random);
    if (glm::dot(shading, geometric) < 0) shading = -shading;
    const double side = glm::dot(geometric, viewer) < 0 ? -1 : 1;
    const std::string inputs =
        "shading " + vector_text(shading) + ", flat " + vector_text(geometric) + ", viewer " + vector_text(viewer);
    const Vec3d got = facing_normal(shading, geometric, viewer);
    const WideVec truth = unit(facing_truth(side * shading, viewer));
    const WideVec as_given = facing_truth(side * shading, viewer);  // which is not touched where it faces the viewer
    judge_unit(trial.of("facing_normal"), got, glm::dot(side * shading, viewer) > 0 ? as_given : truth, inputs);
    const auto sees = [&](const Vec3d& n) {
      return glm::dot(n, viewer) > 0 && dot(wide(n), wide(side * geometric)) >= -Wide(frame_bound);
    };
    const auto example = [&](const Vec3d& n) {
      return Example{inputs, "towards the viewer, on the surface's side", vector_text(n)};
    };
    trial.of("facing_normal, its side").decide(sees(got), [&] { return example(got); });
    const Vec3d turned = glm::dot(shading, viewer) < 0 ? -shading : shading;
    trial.naive("as it is interpolated").decide(sees(side * shading), [&] { return example(side * shading); });
    trial.naive("turned towards the viewer").decide(sees(turned), [&] { return example(turned); });
  }
}

Sketch draw_interpolated_below() {
  Sketch sketch{"A flat triangle whose interpolated normal leans away from a viewer who sees the triangle.", {}};
  return sketch.line({-3, 0}, {3, 0}, Role::shape)
      .line({0, 0}, {2.7, 0.7}, Role::ray)
      .line({0, 0}, {-0.6, 1.1}, Role::naive)
      .line({0, 0}, {0.6, -1.1}, Role::naive)
      .line({0, 0}, {-0.01, 1.253}, Role::truth)
      .label({2.2, 0.9}, "to the viewer")
      .label({-2.9, 1.1}, "n . w < 0: black", Role::naive)
      .label({0.7, -1.1}, "-n: light leaks from below", Role::naive)
      .label({0.1, 1.35}, "reflected at the plane across w", Role::truth);
}

}  // namespace

HardCase normal_nonuniform_scale() {
  return {.id = "nm-nonuniform",
          .group = "normal",
          .inputs =
              "unit normals, (1, 1, 0) / sqrt(2) among them; scaled along an axis by 100 and by 2^-20 to 2^20, "
              "mirrored now and then",
          .expected = "the inverse transpose's direction, to ten roundings",
          .why =
              "A normal is not a direction but what is at right angles to all directions of the surface. Multiplied by "
              "the matrix like these, it follows the stretch and ends up almost in the surface: 88.85 degrees off at "
              "100:1.",
          .oracle = Oracle::closed_form,
          .reference = {},
          .is_policy = false,
          .run = run_nonuniform_scale,
          .draw = draw_nonuniform_scale};
}

HardCase normal_interpolated_below() {
  return {.id = "interp-normal-below",
          .group = "normal",
          .inputs = "shading normals within 90 degrees of the flat one, and viewers all around",
          .expected =
              "a unit normal that faces the viewer: the interpolated one where it does, else its reflection, on "
              "the surface's side",
          .why =
              "Near silhouettes an interpolated normal may face away from a viewer who sees the triangle. Its cosine "
              "is negative: black patches where it is clamped, a root of a negative number in Fresnel's terms, and "
              "light from below the surface where the normal is simply turned over.",
          .oracle = Oracle::closed_form,
          .reference = {},
          .is_policy = false,
          .run = run_interpolated_below,
          .draw = draw_interpolated_below};
}

}  // namespace sightline::hard
