#include "sightline/math/transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "sightline/math/dyadic.h"
#include "sightline/math/triple.h"

namespace sightline {
namespace {

struct Turn {
  double cosine, sine;
};

/// Exact for quarter turns.
Turn turn_of(double degrees) {
  const double rest = std::remainder(degrees, 360);
  if (rest == 0) return {1, 0};
  if (std::fabs(rest) == 180) return {-1, 0};
  if (std::fabs(rest) == 90) return {0, rest > 0 ? 1. : -1.};
  const double angle = rest * (std::numbers::pi / 180);
  return {std::cos(angle), std::sin(angle)};
}

Affine transposed(const Affine& linear) {
  Affine result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result.rows[i][k] = linear.rows[k][i];
  }
  return result;
}

Triple<Dyadic> exact_column(const Affine& matrix, int i) { return triple<Dyadic>(matrix.column(i)); }

/// a / b within two roundings, though neither need be in the range of double.
double quotient(const Dyadic& a, const Dyadic& b) {
  if (a.sign() == 0) return 0;
  const long a_size = a.floor_log2(), b_size = b.floor_log2();
  return std::ldexp(a.scaled(-a_size).nearest() / b.scaled(-b_size).nearest(), static_cast<int>(a_size - b_size));
}

}  // namespace

int determinant_sign(const Affine& matrix) {
  return dot(exact_column(matrix, 0), cross(exact_column(matrix, 1), exact_column(matrix, 2))).sign();
}

Transform Transform::translation(const Vec3d& by) {
  Transform result;
  for (int i = 0; i < 3; ++i) {
    result.matrix_.rows[static_cast<std::size_t>(i)][3] = by[i];
    result.inverse_.rows[static_cast<std::size_t>(i)][3] = 0 - by[i];
  }
  return result;
}

/// Rodrigues' formula.
Transform Transform::rotation(const Vec3d& axis, double degrees) {
  const double size = max_norm(axis);
  if (!sightline::is_finite(axis) || size == 0) throw std::invalid_argument("rotation: expected an axis other than 0");
  if (!std::isfinite(degrees)) throw std::invalid_argument("rotation: expected a finite angle");
  const Vec3d a = axis / size;  // whose square neither over- nor underflows
  const Vec3d unit = a / std::sqrt(glm::dot(a, a));
  const auto [c, s] = turn_of(degrees);
  Affine matrix;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    auto& row = matrix.rows[static_cast<std::size_t>(i)];
    row[static_cast<std::size_t>(i)] = unit[i] * unit[i] + c * (1 - unit[i] * unit[i]);
    row[static_cast<std::size_t>(j)] = unit[i] * unit[j] * (1 - c) - unit[k] * s;
    row[static_cast<std::size_t>(k)] = unit[i] * unit[k] * (1 - c) + unit[j] * s;
  }
  return {matrix, transposed(matrix)};
}

Transform Transform::rotation(const glm::dquat& turn) {
  const Vec3d axis(turn.x, turn.y, turn.z);
  const double size = std::max(max_norm(axis), std::fabs(turn.w));
  if (!sightline::is_finite(axis) || !std::isfinite(turn.w) || size == 0) {
    throw std::invalid_argument("rotation: expected a quaternion other than 0");
  }
  const glm::dmat3 columns = glm::mat3_cast(glm::normalize(turn / size));
  Affine matrix;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) matrix.rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = columns[k][i];
  }
  return {matrix, transposed(matrix)};
}

Transform Transform::scaling(const Vec3d& by) {
  const Vec3d inverse = 1.0 / by;
  if (!sightline::is_finite(by) || !sightline::is_finite(inverse)) {
    throw std::invalid_argument("scaling: expected factors other than 0, found " + std::to_string(by.x) + " " +
                                std::to_string(by.y) + " " + std::to_string(by.z));
  }
  Transform result;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    result.matrix_.rows[k][k] = by[i];
    result.inverse_.rows[k][k] = inverse[i];
  }
  return result;
}

/// Cramer's rule.
Transform Transform::of(const Affine& matrix) {
  if (!sightline::is_finite(matrix)) throw std::invalid_argument("matrix: expected finite numbers");
  const Triple<Dyadic> a = exact_column(matrix, 0), b = exact_column(matrix, 1), c = exact_column(matrix, 2);
  const std::array<Triple<Dyadic>, 3> rows{cross(b, c), cross(c, a), cross(a, b)};
  const Dyadic determinant = dot(a, rows[0]);
  if (determinant.sign() == 0) throw std::invalid_argument("matrix: expected one that can be inverted");
  const Triple<Dyadic> move = exact_column(matrix, 3);
  Affine inverse;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) inverse.rows[i][k] = quotient(rows[i][k], determinant);
    inverse.rows[i][3] = 0 - quotient(dot(rows[i], move), determinant);
  }
  if (!sightline::is_finite(inverse)) throw std::invalid_argument("matrix: expected an inverse within range");
  return {matrix, inverse};
}

bool Transform::is_mirroring() const { return determinant_sign(matrix_) < 0; }

}  // namespace sightline
