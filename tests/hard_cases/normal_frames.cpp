/// Frames around normals: from images that have no direction, or are mirrored, and from the normal alone.

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "sightline/math/random.h"
#include "sightline/texture/normal_map.h"
#include "sightline/texture/tangent_frame.h"
#include "tests/hard_cases/normal_parts.h"
#include "tests/hard_cases/wide_vector.h"

namespace sightline::hard {
namespace {

using Corners = std::array<Vec3d, 3>;
using Uvs = std::array<glm::dvec2, 3>;

std::string text_of(const Corners& corners, const Uvs& uv) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    text += (i > 0 ? ", " : "") + vector_text(corners[i]) + " at (" + all_digits(uv[i].x) + ", " + all_digits(uv[i].y) +
            ")";
  }
  return text;
}

/// Twice the area in the image, times the derivatives by u and v.
struct Derivatives {
  Vec3d u, v;
  double area;
};
Derivatives derivatives_of(const Corners& corners, const Uvs& uv) {
  const Vec3d first = corners[1] - corners[0], second = corners[2] - corners[0];
  const glm::dvec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
  return {b.y * first - a.y * second, a.x * second - b.x * first, a.x * b.y - a.y * b.x};
}

/// As engines' tutorials have it: divided by the area, and the bitangent from the normal.
std::array<Vec3d, 3> naive_frame(const Vec3d& n, const Corners& corners, const Uvs& uv) {
  const Derivatives by = derivatives_of(corners, uv);
  const Vec3d tangent = glm::normalize(by.u * (1 / by.area)),
              level = glm::normalize(tangent - glm::dot(n, tangent) * n);
  return {level, glm::cross(n, level), n};
}

std::array<Vec3d, 3> axes_of(const TangentFrame& frame) { return {frame.tangent, frame.bitangent, frame.normal}; }

/// A triangle in whole numbers that has an area.
Corners whole_triangle(Random& random) {
  for (;;) {
    const Corners corners{random_lattice_vector(random, 9), random_lattice_vector(random, 9),
                          random_lattice_vector(random, 9)};
    if (glm::cross(corners[1] - corners[0], corners[2] - corners[0]) != Vec3d(0)) return corners;
  }
}

// ---- nm-degenerate-uv

/// On one line, in one point, or not finite.
Uvs degenerate_uv(Random& random, std::uint64_t kind) {
  const glm::dvec2 from(random.below(64) / 64.0, random.below(64) / 64.0), along(random.below(8), random.below(8));
  const double steps[] = {random.below(5) / 64.0, random.below(5) / 64.0};
  const double none = kind % 2 == 0 ? std::nan("") : std::numeric_limits<double>::infinity();
  switch (kind % 4) {
    case 0:
      return {from, from, from};
    case 1:
      return {from, from + along * steps[0], from + along * steps[1]};
    case 2:
      return {from, glm::dvec2(none, 0), glm::dvec2(0, 1)};
    default:
      return {glm::dvec2(0, 1), glm::dvec2(1, none), from};
  }
}

int sign_in_rationals(const Uvs& uv) {
  using Rational = boost::multiprecision::cpp_rational;
  const auto side = [&](std::size_t i, int axis) { return Rational(uv[i][axis]) - Rational(uv[0][axis]); };
  return Rational(side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0)).sign();
}

void run_degenerate_uv(Trial& trial) {
  Random random(91);
  for (std::uint64_t i = 0, count = trial.count(3000); i < count; ++i) {
    const Corners corners = whole_triangle(random);
    const Uvs uv = degenerate_uv(random, i);
    const Vec3d n = random_on_sphere(random);
    const std::string inputs = text_of(corners, uv) + ", normal " + vector_text(n);
    const TangentFrame frame = triangle_frame(n, corners, uv), fallback = frame_around(n);
    judge_frame(trial.of("triangle_frame"), axes_of(frame), inputs);
    trial.of("triangle_frame, the fallback").decide(axes_of(frame) == axes_of(fallback), [&] {
      return Example{inputs, vector_text(fallback.tangent), vector_text(frame.tangent)};
    });
    // A height in such an image has no slope either.
    const Vec3d du = random_on_sphere(random), dented = dented_normal(n, du, 2.0 * du, {0, 0});
    judge_unit(trial.of("dented_normal"), dented, wide(n), inputs);
    judge_frame(trial.naive("the derivatives over the area"), naive_frame(n, corners, uv), inputs);
    // Next to it: on a line but for rounding. Whether there is an area is decided exactly.
    Uvs thin;
    const glm::dvec2 from(random.uniform_double(), random.uniform_double()), way(random.uniform_double(), 1);
    for (glm::dvec2& at : thin) at = from + random.uniform_double() * way;
    const int truth = sign_in_rationals(thin), got = uv_orientation(thin);
    trial.of("uv_orientation").decide(got == truth, [&] {
      return Example{text_of(corners, thin), std::to_string(truth), std::to_string(got)};
    });
    judge_frame(trial.of("triangle_frame, thin"), axes_of(triangle_frame(n, corners, thin)), text_of(corners, thin));
  }
}

Sketch draw_degenerate_uv() {
  Sketch sketch{"A triangle, and the place that it has in an image: a point, without direction.", {}};
  return sketch.polygon({{-3, -1}, {0, -1}, {-2, 1.4}})
      .rectangle({1, -1}, {3.4, 1.4}, Role::aid)
      .dot({2.1, 0.3}, Role::naive)
      .line({-1.7, -0.3}, {-0.7, -0.3}, Role::truth)
      .line({-1.7, -0.3}, {-1.7, 0.7}, Role::truth)
      .label({-3, -1.5}, "any frame around the normal", Role::truth)
      .label({1, -1.5}, "area 0: 1 / 0 is inf, inf * 0 is NaN", Role::naive)
      .label({1.1, 1.55}, "u, v");
}

// ---- nm-mirrored-uv

void run_mirrored_uv(Trial& trial) {
  Random random(92);
  for (std::uint64_t i = 0, count = trial.count(3000); i < count; ++i) {
    const Corners corners = whole_triangle(random);
    Uvs uv;
    for (glm::dvec2& at : uv) at = {random.below(16) / 16.0, random.below(16) / 16.0};
    const Derivatives by = derivatives_of(corners, uv);  // of small whole numbers: nothing is rounded
    if (by.area == 0) continue;
    const Vec3d n = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    const TangentFrame frame = triangle_frame(n, corners, uv);
    const std::string inputs = text_of(corners, uv);
    const auto follows = [&](const Vec3d& tangent, const Vec3d& bitangent) {
      const double sign = by.area < 0 ? -1 : 1;
      return dot(wide(tangent), wide(sign * by.u)) > 0 && dot(wide(bitangent), wide(sign * by.v)) > 0;
    };
    judge_frame(trial.of("triangle_frame"), axes_of(frame), inputs);
    trial.of("triangle_frame, its sides")
        .decide(follows(frame.tangent, frame.bitangent) && frame.is_mirrored() == (by.area < 0), [&] {
          return Example{inputs, by.area < 0 ? "mirrored, along u and v" : "not mirrored, along u and v",
                         vector_text(frame.tangent) + ", " + vector_text(frame.bitangent)};
        });
    const auto naive = naive_frame(n, corners, uv);
    trial.naive("the bitangent is normal x tangent").decide(follows(naive[0], naive[1]), [&] {
      return Example{inputs, "along u and v", vector_text(naive[0]) + ", " + vector_text(naive[1])};
    });
  }
}

Sketch draw_mirrored_uv() {
  Sketch sketch{"A dent painted on one half of a face, and mirrored onto the other.", {}};
  return sketch.polygon({{-3, -1}, {-0.2, -1}, {-0.2, 1.4}})
      .polygon({{3, -1}, {0.2, -1}, {0.2, 1.4}})
      .line({-1.4, -0.5}, {-0.6, -0.5}, Role::truth)
      .line({-1.4, -0.5}, {-1.4, 0.3}, Role::truth)
      .line({1.4, -0.5}, {0.6, -0.5}, Role::truth)
      .line({1.4, -0.5}, {1.4, 0.3}, Role::truth)
      .line({1.4, -0.5}, {1.4, -0.95}, Role::naive)
      .label({-0.9, -0.85}, "u", Role::truth)
      .label({-1.75, 0.1}, "v", Role::truth)
      .label({0.7, -0.35}, "u", Role::truth)
      .label({1.5, 0.2}, "v: still upward", Role::truth)
      .label({1.6, -0.9}, "normal x tangent: lit from below", Role::naive);
}

// ---- frame-pole

/// With a single branch left out: the denominator is 1 + z.
std::array<Vec3d, 3> frisvad_frame(const Vec3d& n) {
  const double a = 1 / (1 + n.z), b = -n.x * n.y * a;
  return {Vec3d(1 - n.x * n.x * a, b, -n.x), Vec3d(b, 1 - n.y * n.y * a, -n.y), n};
}

void ask_frame(Trial& trial, const Vec3d& n) {
  const TangentFrame frame = frame_around(n);
  judge_frame(trial.of("frame_around"), axes_of(frame), vector_text(n));
  const bool is_right_hand = dot(cross(wide(frame.tangent), wide(frame.bitangent)), wide(n)) > 0;
  trial.of("frame_around, a right hand's").decide(is_right_hand && frame.normal == n, [&] {
    return Example{vector_text(n), "tangent x bitangent = normal",
                   vector_text(frame.tangent) + ", " + vector_text(frame.bitangent)};
  });
  judge_frame(trial.of("frame_along, with no part within the plane"), axes_of(frame_along(n, 2.0 * n, n)),
              vector_text(n));
  judge_frame(trial.naive("Frisvad's, 1 / (1 + z)"), frisvad_frame(n), vector_text(n));
}

void run_frame_pole(Trial& trial) {
  Random random(93);
  for (const double z : {-1.0, 1.0}) {
    for (const double x : {0.0, -0.0}) {
      for (const double y : {0.0, -0.0}) ask_frame(trial, {x, y, z});
    }
    for (int k = 1; k <= 60; ++k) {
      for (std::uint64_t i = 0, count = trial.count(20); i < count; ++i) {
        const Vec3d aside = std::ldexp(1.0, -k) * random_on_sphere(random);
        Vec3d n(aside.x, aside.y, z);
        normalize_safely(n);
        ask_frame(trial, n);
      }
    }
  }
  for (const double zero : {0.0, -0.0}) ask_frame(trial, {0.6, 0.8, zero});
  for (std::uint64_t i = 0, count = trial.count(1000); i < count; ++i) ask_frame(trial, random_on_sphere(random));
}

Sketch draw_frame_pole() {
  Sketch sketch{"Normals around a sphere; frames by 1 / (1 + z) go wrong around the lower pole.", {}};
  sketch.circle({0, 0}, 1);
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.5236 * i, x = std::cos(angle), y = std::sin(angle);
    const Role role = i == 9 ? Role::naive : Role::truth;
    sketch.line({x, y}, {1.3 * x, 1.3 * y}, Role::ray);
    sketch.line({x - 0.15 * y, y + 0.15 * x}, {x + 0.15 * y, y - 0.15 * x}, role);
  }
  return sketch.dot({0, -1}, Role::naive).label({0.15, -1.5}, "z = -1: x x / (1 + z) = 0 / 0", Role::naive);
}

}  // namespace

HardCase normal_degenerate_uv() {
  return {.id = "nm-degenerate-uv",
          .group = "normal",
          .inputs =
              "triangles in whole numbers whose (u, v) are one point, on one line, NaN or infinite; and such as are "
              "on a line but for rounding",
          .expected = "the frame that any normal has, orthonormal; whether there is an area, exactly",
          .why =
              "Tangents are usually divided by the area in the image. Where that is 0, the tangent is inf or NaN, and "
              "so is every pixel of the triangle; where it is all rounding, its sign, and with it the tangent's, is a "
              "coin toss.",
          .oracle = Oracle::closed_form,
          .reference = "Mitsuba 3, test_normalmap",
          .is_policy = false,
          .run = run_degenerate_uv,
          .draw = draw_degenerate_uv};
}

HardCase normal_mirrored_uv() {
  return {
      .id = "nm-mirrored-uv",
      .group = "normal",
      .inputs = "triangles in whole numbers with (u, v) in sixteenths, half of them mirrored",
      .expected = "u grows along the tangent and v to the side of the bitangent; the frame is mirrored if the image is",
      .why =
          "Models share one half of an image on both sides. On the mirrored half the determinant is negative, and "
          "the bitangent is tangent x normal: who always takes normal x tangent lights dents from below there, "
          "with a seam along the middle.",
      .oracle = Oracle::closed_form,
      .reference = "Lengyel, Mathematics for 3D Game Programming and Computer Graphics, 2001",
      .is_policy = false,
      .run = run_mirrored_uv,
      .draw = draw_mirrored_uv};
}

HardCase normal_frame_pole() {
  return {
      .id = "frame-pole",
      .group = "normal",
      .inputs = "n = (+-0, +-0, -1), its neighbours as near as 2^-60, and normals all over",
      .expected = "an orthonormal frame, a right hand's, around n",
      .why =
          "Frisvad's frame divides by 1 + z: at z = -1 that is 0 / 0, and next to it 1 + z has lost all its digits, "
          "so that the frame is bent long before it is NaN. With the sign of z, -0 included, the denominator "
          "is never below 1.",
      .oracle = Oracle::more_digits,
      .reference = "Duff et al., Building an Orthonormal Basis, Revisited, 2017; pbrt, CoordinateSystem",
      .is_policy = false,
      .run = run_frame_pole,
      .draw = draw_frame_pole};
}

}  // namespace sightline::hard
