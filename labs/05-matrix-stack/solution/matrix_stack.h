#pragma once
/// Lab 05: matrices, and a stack of them.

#include "sightline/math/vec.h"

namespace student {

using namespace sightline;

/// Four rows of four; points are columns, so that a product a b does b first. The last row is 0 0 0 1.
struct Matrix {
  std::array<std::array<double, 4>, 4> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
};

/// What has been computed: the checks look at it, you need not.
struct Work {
  std::uint64_t products = 0;  ///< Of two matrices.
  std::uint64_t points = 0;    ///< Of a matrix and a point.
};
inline Work work;

/// First b, then a.
inline Matrix multiply(const Matrix& a, const Matrix& b) {
  ++work.products;
  Matrix product;
  // lab:hole multiply | 1. Rows times columns
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      double sum = 0;
      for (std::size_t k = 0; k < 4; ++k) sum += a.rows[row][k] * b.rows[k][column];
      product.rows[row][column] = sum;
    }
  }
  // lab:end
  return product;
}

/// Moves everything by v.
inline Matrix translation(const Vec3d& v) {
  Matrix m;
  // lab:hole translation | 2. Move, stretch, turn
  for (std::size_t axis = 0; axis < 3; ++axis) m.rows[axis][3] = v[static_cast<int>(axis)];
  // lab:end
  return m;
}

/// Stretches each axis by its own factor, from the origin.
inline Matrix scaling(const Vec3d& v) {
  Matrix m;
  // lab:hole scaling | 2. Move, stretch, turn
  for (std::size_t axis = 0; axis < 3; ++axis) m.rows[axis][axis] = v[static_cast<int>(axis)];
  // lab:end
  return m;
}

/// Turns about an axis, 0 to 2, by the angle with this cosine and sine, counter-clockwise seen from the axis' tip: a
/// quarter turn about z takes x to y, about x takes y to z, about y takes z to x.
inline Matrix rotation(int axis, double cosine, double sine) {
  Matrix m;
  // lab:hole rotation | 2. Move, stretch, turn
  const auto one = static_cast<std::size_t>((axis + 1) % 3), other = static_cast<std::size_t>((axis + 2) % 3);
  m.rows[one][one] = cosine;
  m.rows[one][other] = -sine;
  m.rows[other][one] = sine;
  m.rows[other][other] = cosine;
  // lab:end
  return m;
}

/// Where a point goes.
inline Vec3d transform_point(const Matrix& m, const Vec3d& p) {
  ++work.points;
  // lab:hole transform_point | 3. Points, directions, normals
  Vec3d moved;
  for (std::size_t row = 0; row < 3; ++row) {
    moved[static_cast<int>(row)] = m.rows[row][0] * p.x + m.rows[row][1] * p.y + m.rows[row][2] * p.z + m.rows[row][3];
  }
  return moved;
  // lab:end
}

/// Where a direction goes: a difference of points, which no translation changes.
inline Vec3d transform_direction(const Matrix& m, const Vec3d& d) {
  // lab:hole transform_direction | 3. Points, directions, normals
  Vec3d turned;
  for (std::size_t row = 0; row < 3; ++row) {
    turned[static_cast<int>(row)] = m.rows[row][0] * d.x + m.rows[row][1] * d.y + m.rows[row][2] * d.z;
  }
  return turned;
  // lab:end
}

/// A normal of the transformed surface, on the same side of it as `n` was before. Of any length but 0, where the matrix
/// can be inverted.
inline Vec3d transform_normal(const Matrix& m, const Vec3d& n) {
  // lab:hole transform_normal | 3. Points, directions, normals
  const auto column = [&](std::size_t c) { return Vec3d(m.rows[0][c], m.rows[1][c], m.rows[2][c]); };
  const Vec3d x = column(0), y = column(1), z = column(2);
  // The inverse transpose, times the determinant: columns are cross products of the others.
  const Vec3d turned = n.x * glm::cross(y, z) + n.y * glm::cross(z, x) + n.z * glm::cross(x, y);
  const double determinant = glm::dot(x, glm::cross(y, z));
  return determinant < 0 ? -turned : turned;  // mirrored
  // lab:end
}

/// Where one draws, and where to come back to. Each step is done within what is current: it moves things before the
/// steps that were taken earlier.
class MatrixStack {
 public:
  const Matrix& current() const { return current_; }

  /// Keeps the current matrix.
  void push() {
    // lab:hole MatrixStack::push | 4. The stack
    kept_.push_back(current_);
    // lab:end
  }
  /// Brings back the matrix that was kept last, bit for bit. \throws std::logic_error where none is kept
  void pop() {
    // lab:hole MatrixStack::pop | 4. The stack
    if (kept_.empty()) throw std::logic_error("pop without push");
    current_ = kept_.back();
    kept_.pop_back();
    // lab:end
  }
  void multiply(const Matrix& step) {
    // lab:hole MatrixStack::multiply | 4. The stack
    current_ = student::multiply(current_, step);
    // lab:end
  }

 private:
  Matrix current_;
  std::vector<Matrix> kept_;
};

/// Every point through all matrices of the chain, the last one first, as a product of them would.
inline std::vector<Vec3d> transform_all(const std::vector<Matrix>& chain, const std::vector<Vec3d>& points) {
  std::vector<Vec3d> moved;
  // lab:hole transform_all | 5. Once for all
  Matrix all;
  for (const Matrix& m : chain) all = multiply(all, m);
  for (const Vec3d& p : points) moved.push_back(transform_point(all, p));
  // lab:end
  return moved;
}

// ---- Given: a plant, drawn with your stack

struct Stroke {
  Vec3d from, to;
};

/// A stem with three smaller plants on it, each a copy of the whole, moved, turned and shrunk.
inline void grow(MatrixStack& stack, int age, std::vector<Stroke>& strokes) {
  strokes.push_back({transform_point(stack.current(), Vec3d(0)), transform_point(stack.current(), {0, 1, 0})});
  if (age == 0) return;
  constexpr double branches[3][4] = {{0.55, 0.82, 0.57, 0.55}, {0.75, 0.85, -0.53, 0.5}, {1.0, 0.998, 0.06, 0.72}};
  for (const auto& [height, cosine, sine, size] : branches) {
    stack.push();
    stack.multiply(translation({0, height, 0}));
    stack.multiply(rotation(2, cosine, sine));
    stack.multiply(scaling(Vec3d(size)));
    grow(stack, age - 1, strokes);
    stack.pop();
  }
}

}  // namespace student
