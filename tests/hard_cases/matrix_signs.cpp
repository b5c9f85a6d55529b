/// Matrices with small determinants, and with negative ones.

#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>
#include <stdexcept>

#include "sightline/csg/solid.h"
#include "sightline/math/random.h"
#include "sightline/math/transform.h"
#include "sightline/shape/instances.h"
#include "tests/csg/evaluate.h"
#include "tests/hard_cases/matrix_parts.h"
#include "tests/hard_cases/random_vectors.h"
#include "tests/hard_cases/solid_question.h"
#include "tests/math/exact.h"

namespace sightline::hard {
namespace {

using exact::Rational;

std::string text_of(const Affine& map) {
  return vector_text(map.column(0)) + ", " + vector_text(map.column(1)) + ", " + vector_text(map.column(2));
}

Affine whole_matrix(Random& random, std::uint32_t size) {
  Affine map;
  for (auto& row : map.rows) {
    for (double& x : row) x = static_cast<double>(random.below(2 * size + 1)) - size;
  }
  return map;
}

// ---- mat-det-test

std::optional<Transform> made_of(const Affine& map) {
  try {
    return Transform::of(map);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// Its numbers are rounded once or twice (math/transform.h), the quotient's parts among them: three roundings in all.
void judge_inverse(Tally& tally, const Affine& map) {
  const exact::Map truth(map);
  const Rational determinant = truth.determinant();
  const std::optional<Transform> made = made_of(map);
  Verdict verdict = made.has_value() == (determinant != 0) ? Verdict::exact : Verdict::wrong;
  double error = 0;
  const std::array<exact::Point, 3> columns{exact::cross(truth.row(1), truth.row(2)),
                                            exact::cross(truth.row(2), truth.row(0)),
                                            exact::cross(truth.row(0), truth.row(1))};
  for (std::size_t i = 0; i < 3 && made && verdict != Verdict::wrong; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational entry = columns[k][i] / determinant, off = abs(Rational(made->inverse().rows[i][k]) - entry);
      if (off == 0) continue;
      error = entry == 0 ? 1 : std::max(error, static_cast<double>(Rational(off / abs(entry))));
      const bool is_within = off <= abs(entry) * Rational(3.001 * 0x1p-53);
      const bool is_nearest = made->inverse().rows[i][k] == static_cast<double>(entry);
      verdict = std::max(verdict, is_nearest ? Verdict::exact : is_within ? Verdict::within_bound : Verdict::wrong);
    }
  }
  tally.add(verdict, error, [&] {
    return Example{text_of(map), determinant == 0 ? "singular" : "an inverse",
                   made ? text_of(made->inverse()) : "singular"};
  });
}

/// What says that there is an inverse is often a threshold for the determinant.
bool has_inverse_by_threshold(const Affine& map) {
  const glm::mat3 m{Vec3f(map.column(0)), Vec3f(map.column(1)), Vec3f(map.column(2))};
  return std::fabs(glm::determinant(m)) > 1e-6f;
}

void run_determinant_test(Trial& trial) {
  Random random(103);
  const double scales[] = {1e-15, 1, 0x1p-300, 0x1p+300, 1e5};
  for (std::uint64_t i = 0, count = trial.count(2500); i < count; ++i) {
    Affine map = whole_matrix(random, 9);
    if (i == 0) map = Affine();
    if (i % 4 == 1) {  // singular; every other one but for the last place of a number
      for (auto& row : map.rows) row[2] = row[0] + row[1];
      if (i % 8 == 1 && map.rows[2][2] != 0) map.rows[2][2] = std::nextafter(map.rows[2][2], 20.0);
    }
    for (auto& row : map.rows) {
      for (std::size_t k = 0; k < 3; ++k) row[k] *= scales[i % 5];
    }
    judge_inverse(trial.of("Transform::of"), map);
    const int sign = exact::Map(map).determinant().sign(), found = determinant_sign(map);
    trial.of("determinant_sign").decide(found == sign, [&] {
      return Example{text_of(map), std::to_string(sign), std::to_string(found)};
    });
    trial.naive("|det| > 1e-6 in float").decide(has_inverse_by_threshold(map) == (sign != 0), [&] {
      return Example{text_of(map), sign != 0 ? "an inverse" : "singular", sign != 0 ? "singular" : "an inverse"};
    });
  }
}

Sketch draw_determinant_test() {
  Sketch sketch{"A small square, and a flat one: one can be made large again. Not to scale.", {}};
  return sketch.rectangle({0, 0}, {0.4, 0.4})
      .rectangle({1.5, -0.8}, {3.5, 1.2}, Role::truth)
      .line({0.5, 0.2}, {1.4, 0.2}, Role::ray)
      .line({-3, 0}, {-1.2, 0.4}, Role::shape)
      .label({-3, -0.4}, "singular: det 0")
      .label({-0.2, -1.2}, "scaled by 1e-15: det 1e-45, and invertible", Role::truth)
      .label({-0.2, -1.7}, "as a float 1.4e-45, its last bit: \"singular\"", Role::naive);
}

// ---- mat-reflect

/// Outward before, outward after: by the cofactors with the determinant's sign, in rationals.
exact::Point outward_truth(const Affine& map, const Vec3d& n) {
  const exact::Map truth(map);
  const exact::Point normal = exact::point(n);
  const std::array<exact::Point, 3> rows{exact::cross(truth.row(1), truth.row(2)),
                                         exact::cross(truth.row(2), truth.row(0)),
                                         exact::cross(truth.row(0), truth.row(1))};
  const Rational sign(truth.determinant().sign());
  return {sign * exact::dot(rows[0], normal), sign * exact::dot(rows[1], normal), sign * exact::dot(rows[2], normal)};
}

void ask_mirrored_solid(Trial& trial, Random& random) {
  SolidTree ball(solid::Sphere{{0.5, 0, 0}, 1});
  const auto axis = random.below(3);
  ball.frame.rows[axis][axis] = -1;
  const SolidTree cut = ball - SolidTree(solid::Box{{-9, -9, 0}, {9, 9, 9}});
  const Vec3d towards = 0.3 * random_in_cube(random), eye = 4.0 * random_on_sphere(random) - Vec3d(0, 0, 2);
  const Ray<double> ray{eye, towards - eye};
  const SolidQuestion question(cut, ray);
  question.ask_spans(trial, "solid in a mirrored frame");
  const Solid solid(cut);
  for (const Level level : all_levels) {
    const Spans spans = spans_of(solid, ray, level);
    bool enters = !spans.begins_inside;
    for (const Boundary& boundary : spans.boundaries) {
      const double along = glm::dot(solid.normal(boundary, ray), ray.direction);
      trial.of("its normals", level).decide(enters ? along < 0 : along > 0, [&] {
        return Example{vector_text(eye) + " to " + vector_text(towards), enters ? "against the ray" : "with the ray",
                       all_digits(along)};
      });
      enters = !enters;
    }
  }
}

void run_reflect(Trial& trial) {
  Random random(104);
  for (std::uint64_t i = 0, count = trial.count(2000); i < count; ++i) {
    Affine map = whole_matrix(random, 4);
    if (i == 0) map = Transform::scaling({-1, 1, 1}).matrix();
    const int sign = exact::Map(map).determinant().sign();
    if (sign == 0) continue;
    const Transform transform = Transform::of(map);
    trial.of("Transform::is_mirroring").decide(transform.is_mirroring() == (sign < 0), [&] {
      return Example{text_of(map), sign < 0 ? "mirroring" : "not", sign < 0 ? "not" : "mirroring"};
    });
    const Triangle local{Vec3f(0), Vec3f(1, 0, 2), Vec3f(0, 3, 1)};
    const auto normal_of = [](const Vec3d& a, const Vec3d& b, const Vec3d& c) { return glm::cross(b - a, c - a); };
    const Vec3d a(local.a), b(local.b), c(local.c), n = normal_of(a, b, c);
    const exact::Point truth = outward_truth(map, n);
    const auto judge = [&](Tally& tally, const Vec3d& got) {
      tally.decide(exact::dot(exact::point(got), truth) > 0, [&] {
        return Example{text_of(map), "outward", vector_text(got)};
      });
    };
    const Triangle placed = Placement(map, 0).triangle(local);
    judge(trial.of("Placement::triangle"), normal_of(Vec3d(placed.a), Vec3d(placed.b), Vec3d(placed.c)));
    judge(trial.of("Transform::normal"), transform.normal(n));
    judge(trial.naive("corners moved in their order"), normal_of(map.point(a), map.point(b), map.point(c)));
    if (i % 4 == 0) ask_mirrored_solid(trial, random);
  }
}

Sketch draw_reflect() {
  Sketch sketch{"A triangle and its mirror image, corners in the same order.", {}};
  return sketch.polygon({{-3, -1}, {-1, -1}, {-2.4, 1}})
      .polygon({{3, -1}, {1, -1}, {2.4, 1}})
      .line({0, -1.4}, {0, 1.4}, Role::aid)
      .label({-3.3, -1.3}, "1")
      .label({-1, -1.3}, "2")
      .label({-2.4, 1.1}, "3")
      .label({3.1, -1.3}, "1")
      .label({0.8, -1.3}, "2")
      .label({2.4, 1.1}, "3")
      .label({-3.2, -1.9}, "counter-clockwise: seen from outside", Role::truth)
      .label({-3.2, -2.4}, "clockwise: now outside is inside", Role::naive);
}

}  // namespace

HardCase matrix_determinant_test() {
  return {
      .id = "mat-det-test",
      .group = "matrix",
      .inputs =
          "scale 1e-15; whole numbers to 9 times 1e-15, 2^-300, 1, 1e5 and 2^300; singular ones, and such as miss "
          "it by the last place of one number",
      .expected = "an inverse for all but determinant 0, its numbers within three roundings",
      .why =
          "A determinant is a volume: at scale 1e-15 it is 1e-45, the last bit of float, and at 2^-300 below all of "
          "double. A threshold calls these singular, and a matrix of large numbers that really is passes it by "
          "rounding. Only its exact sign tells.",
      .oracle = Oracle::rationals,
      .reference = {},
      .is_policy = false,
      .run = run_determinant_test,
      .draw = draw_determinant_test};
}

HardCase matrix_reflect() {
  return {.id = "mat-reflect",
          .group = "matrix",
          .inputs =
              "scale (-1, 1, 1), and matrices of whole numbers from -4 to 4; triangles, normals and cut balls in "
              "mirrored frames",
          .expected = "what faced outward faces outward, and spans enter and leave as they did",
          .why =
              "A mirror turns the order of corners around. Who keeps it gets normals that point inward: culled faces, "
              "black shading, and solids that are full where they were empty. The determinant's sign says when to "
              "swap two corners.",
          .oracle = Oracle::metamorphic,
          .reference = {},
          .is_policy = false,
          .run = run_reflect,
          .draw = draw_reflect};
}

}  // namespace sightline::hard
