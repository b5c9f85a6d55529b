#pragma once
/// Roots of quadratics in lanes.

#include "sightline/csg/face_roots.h"
#include "sightline/math/simd.h"

namespace sightline {

/// Whether lanes find at a level what scalars do: floats need the fused operations that those are given.
template <Level level>
inline constexpr bool has_lane_roots = level != Level::fast || HWY_NATIVE_FMA;

/// Of quadratics a t^2 + 2 b t + c, one a lane, where a is not negative.
///   S1  Roots and their radii are, bit for bit, those that quick_span finds (quick_spans.h): the same operations in
///       the same order. Where that does not find two or none, surely, the lane is neither.
template <Level level, class D>
class LaneRoots {
 public:
  using Real = hn::TFromD<D>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  V t[2], radius[2];  ///< Radii are those of levels above fast.
  M are_two, are_none;

  /// What the coefficients are made of: the line in coordinates in which the face is round, and the face's numbers.
  struct Face {
    V square, error_a, error_b, error_c;
  };
  [[gnu::always_inline]] LaneRoots(const V (&along)[3], const V (&away)[3], const Face& face) {
    const auto sum = [](V x, V y, V z) { return hn::Add(hn::Add(x, y), z); };
    const auto dot = [&](const V* u, const V* v) {
      return sum(hn::Mul(u[0], v[0]), hn::Mul(u[1], v[1]), hn::Mul(u[2], v[2]));
    };
    const V a = dot(along, along), far2 = dot(away, away), c = hn::Sub(far2, face.square);
    const V x = hn::Mul(along[0], away[0]), y = hn::Mul(along[1], away[1]), z = hn::Mul(along[2], away[2]);
    const V b = sum(x, y, z);
    if constexpr (level == Level::fast) {
      find_by_floats(a, b, c);
    } else {
      const V least = hn::Set(d, SizedDouble::step);
      const V sizes_b = sum(hn::Abs(x), hn::Abs(y), hn::Abs(z));
      const V error_a = hn::Add(hn::Mul(a, face.error_a), least);
      const V error_b = hn::Add(hn::Mul(sizes_b, face.error_b), least);
      const V error_c = hn::Add(hn::Mul(hn::Add(far2, face.square), face.error_c), least);
      find_sized(a, b, c, error_a, error_b, error_c);
    }
  }

 private:
  static constexpr D d{};

  /// quadratic_roots of SizedDouble.
  [[gnu::always_inline]] void find_sized(V a, V b, V c, V error_a, V error_b, V error_c) {
    const auto real = [](double x) { return hn::Set(d, static_cast<Real>(x)); };
    const V size_b = hn::Abs(b), size_c = hn::Abs(c);
    const V square = hn::Mul(b, b), product = hn::Mul(a, c), discriminant = hn::Sub(square, product);
    const V of_terms =
        hn::Add(hn::Add(hn::Mul(hn::Add(hn::Add(size_b, size_b), error_b), error_b), hn::Mul(a, error_c)),
                hn::Mul(hn::Add(size_c, error_c), error_a));
    const V of_roundings = hn::Mul(hn::Add(square, hn::Abs(product)), real(0x1p-52));
    const V error = hn::Add(hn::Mul(hn::Add(of_terms, of_roundings), real(1 + 0x1p-40)), real(SizedDouble::step));
    const M is_quadratic = hn::Gt(a, hn::Mul(real(0x1p+20), error_a));
    const M is_certain = hn::And(is_quadratic, hn::Gt(hn::Abs(discriminant), error));
    const M is_met = hn::Gt(discriminant, hn::Zero(d));

    const V root = hn::Sqrt(discriminant), size_q = hn::Add(size_b, root);
    const M is_behind = hn::Gt(b, hn::Zero(d));
    const V q = hn::IfThenElse(is_behind, hn::Neg(size_q), size_q);
    const V error_q =
        hn::Add(hn::Mul(hn::Add(error_b, hn::Div(error, root)), real(1 + 0x1p-40)), hn::Mul(size_q, real(0x1p-51)));
    const M is_apart = hn::Gt(size_q, hn::Mul(real(0x1p+20), error_q));
    const V inverse_a = hn::Div(real(1), a), inverse_q = hn::Div(real(1), q);
    const V one = hn::Mul(q, inverse_a), other = hn::Mul(c, inverse_q);
    const V size_one = hn::Abs(one), size_other = hn::Abs(other), slack = real(1 + 0x1p-18), tiny = real(0x1p-51);
    const V first = hn::Add(hn::Mul(hn::Mul(hn::Add(error_q, hn::Mul(size_one, error_a)), inverse_a), slack),
                            hn::Mul(size_one, tiny));
    const V second =
        hn::Add(hn::Mul(hn::Mul(hn::Add(error_c, hn::Mul(size_other, error_q)), hn::Abs(inverse_q)), slack),
                hn::Mul(size_other, tiny));
    t[0] = hn::IfThenElse(is_behind, one, other), t[1] = hn::IfThenElse(is_behind, other, one);
    radius[0] = hn::IfThenElse(is_behind, first, second);
    radius[1] = hn::IfThenElse(is_behind, second, first);
    are_two = hn::And(hn::And(is_certain, is_met), is_apart);
    are_none = hn::AndNot(is_met, is_certain);
  }

  /// quadratic_roots of float, where nothing needs to be scaled.
  [[gnu::always_inline]] void find_by_floats(V a, V b, V c) {
    const V zero = hn::Zero(d), large = hn::Set(d, Real(0x1p+62));
    const V product = hn::Mul(a, c);
    const V discriminant = hn::Add(hn::MulSub(b, b, product), hn::NegMulAdd(a, c, product));
    const V size_b = hn::Abs(b), size_c = hn::Abs(c), most = hn::Max(size_b, size_c);
    const M is_small = hn::And(hn::And(hn::Lt(a, large), hn::Lt(size_b, large)), hn::Lt(size_c, large));
    const M is_ordinary = hn::And(is_small, hn::Gt(hn::Mul(hn::Min(a, most), large), hn::Set(d, Real(1))));
    const M is_behind = hn::Gt(b, zero);
    const V size_q = hn::Add(size_b, hn::Sqrt(discriminant)), q = hn::IfThenElse(is_behind, hn::Neg(size_q), size_q);
    const V one = hn::Div(q, a), other = hn::Div(c, q);
    t[0] = hn::Min(one, other), t[1] = hn::Max(one, other);
    radius[0] = radius[1] = zero;
    are_two = hn::And(is_ordinary, hn::Gt(discriminant, zero));
    are_none = hn::And(is_ordinary, hn::Lt(discriminant, zero));
  }
};

/// Where planes are passed is known to within twice its radius (S2 of lane_spans.h); these grow with t.
template <Level level, class D>
class LanePassings {
 public:
  using Real = hn::TFromD<D>;
  using V = hn::Vec<D>;

  static V lower(V t) {
    if constexpr (level == Level::fast) return t;
    return hn::Sub(t, slack(t));
  }
  static V upper(V t) {
    if constexpr (level == Level::fast) return t;
    return hn::Add(t, slack(t));
  }

 private:
  static V slack(V t) {
    constexpr D d{};
    return hn::Add(hn::Mul(hn::Abs(t), hn::Set(d, Real(2 * QuickRay<level>::passing_share))),
                   hn::Set(d, Real(2 * QuickRay<level>::passing_step)));
  }
};

}  // namespace sightline
