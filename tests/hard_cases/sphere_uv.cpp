/// Places and frames on a sphere.

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <numbers>

#include "sightline/math/random.h"
#include "sightline/math/slerp.h"
#include "sightline/texture/tangent_frame.h"
#include "sightline/texture/uv.h"
#include "tests/hard_cases/random_vectors.h"
#include "tests/hard_cases/solid_question.h"
#include "tests/hard_cases/sphere_parts.h"

namespace sightline::hard {
namespace {

// ---- sph-uv-seam

void run_uv_seam(Trial& trial) {
  Random random(23);
  const auto count = trial.count(2000);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double x = i == 0 ? -1 : random_in_cube(random).x, z = i == 0 ? 0 : random_in_cube(random).z;
    const int width = 1 + static_cast<int>(random.below(4096));
    const auto texel = [&](double u) { return static_cast<long>(std::floor(u * width)); };
    const auto example = [&](double above, double below) {
      return Example{vector_text(Vec3d(x, 0, z)) + " and y = -0, " + std::to_string(width) + " texels", "one texel",
                     std::to_string(texel(above)) + " and " + std::to_string(texel(below))};
    };
    const auto is_right = [&](double above, double below) {
      return texel(above) == texel(below) && texel(above) >= 0 && texel(above) < width;
    };
    const double above = spherical_uv({x, 0.0, z}).x, below = spherical_uv({x, -0.0, z}).x;
    const bool is_there = above == (x < 0 ? 0.5 : 0) && below == above;  // U1 of texture/uv.h
    trial.of("spherical_uv").decide(is_right(above, below) && is_there, [&] { return example(above, below); });
    // Next to the seam, too, u stays in the image.
    for (const double y : {0x1p-1074, -0x1p-1074, 1e-20, -1e-20}) {
      const double u = spherical_uv({x, y, z}).x;
      trial.of("spherical_uv").decide(u >= 0 && texel(u) < width, [&] { return example(u, u); });
    }
    const auto naive_u = [](double px, double py) {
      constexpr double pi = std::numbers::pi;
      return (std::atan2(py, px) + pi) / (2 * pi);
    };
    const double naive_above = naive_u(x, 0.0), naive_below = naive_u(x, -0.0);
    trial.naive("(atan2(y, x) + pi) / 2 pi").decide(is_right(naive_above, naive_below), [&] {
      return example(naive_above, naive_below);
    });
  }
}

Sketch draw_uv_seam() {
  Sketch sketch{"A sphere from above: where y is +0 or -0 there is one place, but the angle jumps from pi to -pi.", {}};
  return sketch.circle({0, 0}, 1)
      .line({0, 0}, {-1, 0}, Role::aid)
      .dot({-1, 0})
      .label({-2.6, 0.25}, "y = +0: u = 1", Role::naive)
      .label({-2.6, -0.35}, "y = -0: u = 0", Role::naive)
      .label({-0.7, 1.2}, "true: one texel, u = 1/2", Role::truth);
}

// ---- sph-pole

/// Exactly: at a pole all numbers are 0, 1 and -1.
bool is_orthonormal(const TangentFrame& frame) {
  using boost::multiprecision::cpp_rational;
  const std::array axes{frame.tangent, frame.bitangent, frame.normal};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_finite(axes[i]) || !is_finite(axes[k])) return false;
      cpp_rational product = 0;
      for (int axis = 0; axis < 3; ++axis) product += cpp_rational(axes[i][axis]) * cpp_rational(axes[k][axis]);
      if (product != (i == k ? 1 : 0)) return false;
    }
  }
  return true;
}

void run_pole(Trial& trial) {
  for (int exponent = -1000; exponent <= 1000; exponent += 50) {
    for (const double side : {1.0, -1.0}) {
      for (const double zero_x : {0.0, -0.0}) {
        for (const double zero_y : {0.0, -0.0}) {
          const Vec3d p(zero_x, zero_y, side * std::ldexp(1.0, exponent)), n(0, 0, side);
          const glm::dvec2 uv = spherical_uv(p);
          const auto [du, dv] = spherical_derivatives(p);
          const TangentFrame frame = frame_along(n, du, dv);
          const auto example = [&](const TangentFrame& found) {
            return Example{vector_text(p),
                           "u in [0, 1), v at an end, dp/du = 0, a frame of unit vectors at right angles",
                           all_digits(uv.x) + ", " + all_digits(uv.y) + ", " + vector_text(found.tangent) + ", " +
                               vector_text(found.bitangent)};
          };
          const bool has_place = uv.x >= 0 && uv.x < 1 && uv.y == (side > 0 ? 1 : 0) && du == Vec3d(0) && is_finite(dv);
          trial.of("spherical_uv and frame_along").decide(has_place && is_orthonormal(frame), [&] {
            return example(frame);
          });
          const Vec3d along = glm::normalize(Vec3d(-p.y, p.x, 0));
          const TangentFrame naive{along, glm::cross(n, along), n};
          trial.naive("the tangent (-y, x, 0), normalized").decide(is_orthonormal(naive), [&] {
            return example(naive);
          });
        }
      }
    }
  }
}

Sketch draw_pole() {
  Sketch sketch{"Meridians and circles of latitude from above: at the pole a circle has no length, and no direction.",
                {}};
  for (const double radius : {1.0, 0.66, 0.33}) sketch.circle({0, 0}, radius, radius == 1 ? Role::shape : Role::aid);
  for (int i = 0; i < 12; ++i) {
    const double angle = i * std::numbers::pi / 6;
    sketch.line({0, 0}, {std::cos(angle), std::sin(angle)}, Role::aid);
  }
  return sketch.dot({0, 0})
      .line({0, 0}, {0.5, 0}, Role::truth)
      .line({0, 0}, {0, 0.5}, Role::truth)
      .label({-1.6, 1.15}, "dp/du = 0: normalized 0 / 0", Role::naive)
      .label({0.1, -0.2}, "any frame around the normal is right");
}

// ---- unit-dot-acos

void run_unit_dot(Trial& trial) {
  Random random(24);
  const auto count = trial.count(20000);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec3f v = glm::normalize(Vec3f(random_in_cube(random)));
    const glm::dquat q(v.x, v.y, v.z, 0.0);  // as long as v: 1 but for rounding
    const glm::dquat between = slerp(q, q, 0.3), same = canonical(q);
    trial.of("slerp").decide(between == same, [&] {
      return Example{vector_text(Vec3d(v)) + " turned to itself", all_digits(same.w), all_digits(between.w)};
    });
    // Poles whose length is off by roundings.
    const double z = (i % 2 ? 1 : -1) * (1 + double(random.below(8)) * 0x1p-23), end = z > 0 ? 1 : 0;
    const double height = spherical_uv({0, 0, z}).y;
    trial.of("spherical_uv").decide(height == end, [&] {
      return Example{vector_text({0, 0, z}), all_digits(end), all_digits(height)};
    });

    const float angle = std::acos(glm::dot(v, v));
    trial.naive("acos(v.v), in float").decide(!std::isnan(angle), [&] {
      return Example{vector_text(Vec3d(v)), "0", all_digits(double(angle))};
    });
  }
}

Sketch draw_unit_dot() {
  Sketch sketch{"The arc cosine ends at 1. A vector normalized in float may have the product 1 + 2^-23 with itself.",
                {}};
  std::vector<glm::dvec2> curve;
  for (int i = 0; i <= 50; ++i) curve.push_back({i * 0.02, std::acos(i * 0.02)});
  return sketch.path(curve)
      .line({1, -0.2}, {1, 1.4}, Role::aid)
      .dot({1, 0})
      .dot({1.12, 0}, Role::naive)
      .label({1.05, 0.2}, "v.v > 1: NaN", Role::naive)
      .label({0.3, 0.6}, "acos")
      .label({0.86, -0.4}, "1");
}

}  // namespace

HardCase sphere_uv_seam() {
  return {.id = "sph-uv-seam",
          .group = "sphere",
          .inputs = "(x, +0, z) and (x, -0, z), (-1, 0, 0) among them, and y = +-1e-20 and +-2^-1074 beside",
          .expected = "one texel for both signs of 0, and u in [0, 1) everywhere",
          .why =
              "atan2(+0, -1) is pi and atan2(-0, -1) is -pi: points that are equal get u = 1 and u = 0, and the texel "
              "of u = 1 is the one behind the last. A sign of zero is no place.",
          .oracle = Oracle::closed_form,
          .run = run_uv_seam,
          .draw = draw_uv_seam};
}

HardCase sphere_pole() {
  return {.id = "sph-pole",
          .group = "sphere",
          .inputs = "(+-0, +-0, +-2^k), k = -1000 ... 1000",
          .expected = "u in [0, 1), v = 0 or 1, and a frame of three unit vectors at right angles",
          .why =
              "At a pole the derivative by u is the zero vector; normalized it is 0 / 0, and one NaN in a tangent "
              "frame is a black or white pixel, which filters smear.",
          .oracle = Oracle::closed_form,
          .reference = "Mitsuba, tests of si_singularity",
          .run = run_pole,
          .draw = draw_pole};
}

HardCase unit_dot_acos() {
  return {
      .id = "unit-dot-acos",
      .group = "sphere",
      .inputs = "random vectors normalized in float, and poles whose length is 1 + k 2^-23",
      .expected = "angles that are numbers: 0 between a vector and itself, latitudes in [0, 1]",
      .why =
          "Three squares and two sums are rounded, so v.v of a normalized vector is often above 1, for one in nine to "
          "one in four by how it is normalized, and the arc cosine of that is NaN. atan2 of sine and cosine has no "
          "such edge.",
      .oracle = Oracle::closed_form,
      .run = run_unit_dot,
      .draw = draw_unit_dot};
}

}  // namespace sightline::hard
