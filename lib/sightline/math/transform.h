#pragma once
/// Affine maps that can be undone.

#include <glm/gtc/quaternion.hpp>
#include <stdexcept>

#include "sightline/math/affine.h"

namespace sightline {

/// An affine map and its inverse, side by side.
///   X1  What is made of translations, rotations, scalings and products needs no numeric inversion: the inverse is the
///       product of inverses in reverse order.
///   X2  Whole numbers, powers of two and quarter turns about the axes are not rounded.
class Transform {
 public:
  /// The identity.
  Transform() = default;

  static Transform translation(const Vec3d& by);
  /// Counter-clockwise as seen from the axis' tip, which may have any length. Whole quarter turns are exact (X2).
  /// \throws std::invalid_argument for an axis that is zero or not finite.
  static Transform rotation(const Vec3d& axis, double degrees);
  /// By a quaternion of any length. \throws std::invalid_argument for zero, and for what is not finite.
  static Transform rotation(const glm::dquat& turn);
  /// \throws std::invalid_argument for a factor that is zero or not finite. Negative ones mirror.
  static Transform scaling(const Vec3d& by);

  /// Any invertible map; the inverse is computed exactly and each of its numbers rounded once or twice. However small
  /// the determinant, only zero is singular. \throws std::invalid_argument for a map that is singular, or whose numbers
  /// or those of the inverse are not finite.
  static Transform of(const Affine& matrix);

  const Affine& matrix() const { return matrix_; }
  const Affine& inverse() const { return inverse_; }

  Vec3d point(const Vec3d& p) const { return matrix_.point(p); }
  Vec3d vector(const Vec3d& v) const { return matrix_.vector(v); }
  /// Of surfaces: stays at right angles to them, but not of the same length.
  Vec3d normal(const Vec3d& n) const { return inverse_.covector(n); }

  Transform inverted() const { return {inverse_, matrix_}; }

  /// Whether it turns left hands into right ones: the sign of the determinant, exactly.
  bool is_mirroring() const;

  friend bool operator==(const Transform&, const Transform&) = default;

  /// First `inner`, then `outer`.
  friend Transform operator*(const Transform& outer, const Transform& inner) {
    return {outer.matrix_ * inner.matrix_, inner.inverse_ * outer.inverse_};
  }

 private:
  Transform(const Affine& matrix, const Affine& inverse) : matrix_(matrix), inverse_(inverse) {}

  Affine matrix_, inverse_;
};

/// -1, 0 or 1, as real arithmetic has it. Of finite numbers.
int determinant_sign(const Affine& matrix);

}  // namespace sightline
