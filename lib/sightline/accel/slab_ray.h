#pragma once

#include <cstdint>

#include "sightline/accel/padded_ray.h"
#include "sightline/math/simd.h"

namespace sightline {

/// A padded ray of float against axis planes with one multiply-add each, t = plane * inverse - offset.
///   S1  A component of the direction counts as at least 2^-30 of the largest, so that all that is computed is finite.
///       Until the ray leaves the scene this moves it by 2^-30 of reach, which the structure's half of the margin
///       covers (M2).
///   S2  The offset is a moved origin times the inverse. Rounding it shifts the plane by u |moved origin|: the origin
///       is moved by that much more, and by as much again for processors that round the product. What else is rounded,
///       the inverse and t, shifts planes by 4 u of reach (M2).
///   S3  Exponents stay within the range of float for ordinary rays alone; the others need PaddedRay.
/// D names the vectors of planes.
template <class D>
class SlabRay {
  using V = hn::Vec<D>;

 public:
  [[gnu::always_inline]] SlabRay(const Ray<float>& ray, const Aabb& bounds) {
    const auto is_axis = hn::FirstN(f, 3);
    const F origin = hn::IfThenElseZero(is_axis, hn::LoadU(f, &ray.origin.x));  // reads into the direction, and so on
    const F direction = hn::IfThenElseZero(is_axis, hn::LoadU(f, &ray.direction.x));
    const F lows = hn::LoadU(f, &bounds.lo.x), highs = hn::Shuffle0321(hn::LoadU(f, &bounds.lo.z));
    const F to_bounds = hn::Max(hn::Abs(hn::Sub(lows, origin)), hn::Abs(hn::Sub(highs, origin)));
    const F reach = hn::MaxOfLanes(f, hn::IfThenElseZero(is_axis, to_bounds));
    const F speed = hn::MaxOfLanes(f, hn::Abs(direction));
    const F slowest = hn::Mul(speed, hn::Set(f, 0x1p-30f));
    const F inverse = hn::Div(hn::Set(f, 1.0f), hn::CopySign(hn::Max(hn::Abs(direction), slowest), direction));  // S1
    const F pad = hn::Mul(reach, hn::Set(f, margin<float>));
    constexpr float rounding = 3 * std::numeric_limits<float>::epsilon();  // S2: 6 u, of which PaddedRay has 4
    const F away = hn::CopySign(hn::MulAdd(hn::Set(f, rounding), hn::Add(hn::Abs(origin), pad), pad), direction);
    alignas(16) float inverses[4], enters[4], leaves[4];
    hn::Store(inverse, f, inverses);
    hn::Store(hn::Mul(hn::Add(origin, away), inverse), f, enters);
    hn::Store(hn::Mul(hn::Sub(origin, away), inverse), f, leaves);
    for (int axis = 0; axis < 3; ++axis) {
      inverse_[axis] = hn::Set(D(), inverses[axis]);
      enter_[axis] = hn::Set(D(), enters[axis]);
      leave_[axis] = hn::Set(D(), leaves[axis]);
    }
    const auto is_within = [](F x, float lowest, float highest) {  // not NaN
      return hn::And(hn::Ge(x, hn::Set(f, lowest)), hn::Le(x, hn::Set(f, highest)));
    };
    const F size = hn::Abs(inverse);
    is_ordinary_ = (ray.t_min <= ray.t_max) &
                   hn::AllTrue(f, hn::And(hn::And(is_within(reach, 0x1p-100f, 0x1p+100f),  // S3
                                                  is_within(hn::Mul(reach, size), 0x1p-90f, 0x1p+120f)),
                                          hn::And(is_within(hn::Mul(hn::Abs(origin), size), 0, 0x1p+120f),
                                                  is_within(speed, 0x1p-90f, 0x1p+90f))));
    octant_ = bits_of(f, hn::And(is_axis, hn::Lt(inverse, hn::Zero(f))));
  }

  bool is_ordinary() const { return is_ordinary_; }
  /// A bit is set where the direction is negative, or a negative zero.
  std::uint32_t octant() const { return octant_; }

  /// Where the ray first touches the half-spaces behind planes along its direction.
  V enter(int axis, V planes) const { return hn::MulSub(planes, inverse_[axis], enter_[axis]); }

  /// Where it last touches the half-spaces before planes.
  V leave(int axis, V planes) const { return hn::MulSub(planes, inverse_[axis], leave_[axis]); }

 private:
  using Axes = hn::CappedTag<float, 4>;
  using F = hn::Vec<Axes>;
  static constexpr Axes f{};

  V inverse_[3], enter_[3], leave_[3];
  std::uint32_t octant_;
  bool is_ordinary_;
};

}  // namespace sightline
