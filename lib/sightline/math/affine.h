#pragma once

#include <array>
#include <cstddef>

#include "sightline/math/vec.h"

namespace sightline {

/// The map x -> linear x + translation, by rows: three columns of the linear part, then the translation.
struct Affine {
  std::array<std::array<double, 4>, 3> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

  Vec3d column(int i) const {
    const auto k = static_cast<std::size_t>(i);
    return {rows[0][k], rows[1][k], rows[2][k]};
  }

  Vec3d point(const Vec3d& p) const { return vector(p) + column(3); }
  /// Directions and differences of points, which translations leave alone.
  Vec3d vector(const Vec3d& v) const {
    Vec3d image;
    for (int i = 0; i < 3; ++i) {
      const auto& row = rows[static_cast<std::size_t>(i)];
      image[i] = row[0] * v.x + row[1] * v.y + row[2] * v.z;
    }
    return image;
  }
  /// By the transpose of the linear part: what normals need of the inverse map.
  Vec3d covector(const Vec3d& n) const {
    return {glm::dot(column(0), n), glm::dot(column(1), n), glm::dot(column(2), n)};
  }

  bool is_identity() const { return *this == Affine(); }
  friend bool operator==(const Affine&, const Affine&) = default;

  /// First `inner`, then `outer`.
  friend Affine operator*(const Affine& outer, const Affine& inner) {
    Affine product;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& row = outer.rows[i];
      for (std::size_t k = 0; k < 4; ++k) {
        product.rows[i][k] = row[0] * inner.rows[0][k] + row[1] * inner.rows[1][k] + row[2] * inner.rows[2][k];
      }
      product.rows[i][3] += row[3];
    }
    return product;
  }
};

inline bool is_finite(const Affine& matrix) {
  return is_finite(matrix.column(0)) && is_finite(matrix.column(1)) && is_finite(matrix.column(2)) &&
         is_finite(matrix.column(3));
}

}  // namespace sightline
