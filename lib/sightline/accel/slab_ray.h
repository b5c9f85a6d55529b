#pragma once
/// Padded rays of float against axis planes with one multiply-add each, t = plane * inverse - offset.
///   S1  A component of the direction counts as at least 2^-30 of the largest, so that all that is computed is finite.
///       Until the ray leaves the scene this moves it by 2^-30 of reach, which the structure's half of the margin
///       covers (M2).
///   S2  The offset is a moved origin times the inverse. Rounding it shifts the plane by u |moved origin|: the origin
///       is moved by that much more, and by as much again for processors that round the product. What else is rounded,
///       the inverse and t, shifts planes by 4 u of reach (M2).
///   S3  Exponents stay within the range of float for ordinary rays alone; the others need PaddedRay.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "sightline/accel/padded_ray.h"
#include "sightline/math/simd.h"

namespace sightline {

/// What S1 to S3 make of rays, a lane each, or of the axes of one ray.
template <class D>
struct MovedSlabs {
  hn::Vec<D> inverse;
  hn::Vec<D> enter_origin;  ///< Of planes through which the ray enters.
  hn::Vec<D> leave_origin;  ///< Of planes through which the ray leaves.
  hn::Mask<D> is_ordinary;
};

/// `speed` is the largest component of the direction.
template <class D>
[[gnu::always_inline]] inline MovedSlabs<D> moved_slabs(D d, hn::Vec<D> origin, hn::Vec<D> direction, hn::Vec<D> reach,
                                                        hn::Vec<D> speed) {
  using V = hn::Vec<D>;
  const V slowest = hn::Mul(speed, hn::Set(d, 0x1p-30f));
  const V inverse = hn::Div(hn::Set(d, 1.0f), hn::CopySign(hn::Max(hn::Abs(direction), slowest), direction));  // S1
  const V pad = hn::Mul(reach, hn::Set(d, margin<float>));
  constexpr float rounding = 3 * std::numeric_limits<float>::epsilon();  // S2: 6 u, of which PaddedRay has 4
  const V away = hn::CopySign(hn::MulAdd(hn::Set(d, rounding), hn::Add(hn::Abs(origin), pad), pad), direction);
  const auto is_within = [d](V x, float lowest, float highest) {  // not NaN
    return hn::And(hn::Ge(x, hn::Set(d, lowest)), hn::Le(x, hn::Set(d, highest)));
  };
  const V size = hn::Abs(inverse);
  // S3, and of the ray's own numbers in each lane, since maxima may lose a NaN.
  const auto is_in_range =
      hn::And(is_within(speed, 0x1p-90f, 0x1p+90f),
              hn::And(is_within(reach, 0x1p-100f, 0x1p+100f), is_within(hn::Mul(reach, size), 0x1p-90f, 0x1p+120f)));
  const auto is_ordinary = hn::And(is_in_range, hn::And(is_within(hn::Mul(hn::Abs(origin), size), 0, 0x1p+120f),
                                                        is_within(hn::Abs(direction), 0, 0x1p+90f)));
  return {inverse, hn::Add(origin, away), hn::Sub(origin, away), is_ordinary};
}

/// A padded ray as slabs; D names the vectors of planes.
template <class D>
class SlabRay {
  using V = hn::Vec<D>;

 public:
  [[gnu::always_inline]] SlabRay(const Ray<float>& ray, const Aabb& bounds) {
    const auto is_axis = hn::FirstN(f, 3);
    const F origin = hn::IfThenElseZero(is_axis, hn::LoadU(f, &ray.origin.x));  // reads into the direction, and so on
    const F direction = hn::IfThenElseZero(is_axis, hn::LoadU(f, &ray.direction.x));
    const F lows = hn::LoadU(f, &bounds.lo.x), highs = shifted_down(hn::LoadU(f, &bounds.lo.z));
    const F to_bounds = hn::Max(hn::Abs(hn::Sub(lows, origin)), hn::Abs(hn::Sub(highs, origin)));
    const F reach = hn::MaxOfLanes(f, hn::IfThenElseZero(is_axis, to_bounds));
    const F speed = hn::MaxOfLanes(f, hn::Abs(direction));
    const auto moved = moved_slabs(f, origin, direction, reach, speed);
    alignas(16) std::array<float, 4> inverses, enters, leaves;
    hn::Store(moved.inverse, f, inverses.data());
    hn::Store(hn::Mul(moved.enter_origin, moved.inverse), f, enters.data());
    hn::Store(hn::Mul(moved.leave_origin, moved.inverse), f, leaves.data());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      inverse_[axis] = hn::Set(D(), inverses[axis]);
      enter_[axis] = hn::Set(D(), enters[axis]);
      leave_[axis] = hn::Set(D(), leaves[axis]);
    }
    octant_ = bits_of(f, hn::And(is_axis, hn::Lt(moved.inverse, hn::Zero(f))));
    is_ordinary_ = (ray.t_min <= ray.t_max) & hn::AllTrue(f, moved.is_ordinary);
  }

  /// An ordinary one of its numbers by axis; offsets are moved origins times inverses.
  SlabRay(const std::array<float, 3>& inverse, const std::array<float, 3>& enter, const std::array<float, 3>& leave,
          std::uint32_t octant)
      : octant_(octant), is_ordinary_(true) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      inverse_[axis] = hn::Set(D(), inverse[axis]);
      enter_[axis] = hn::Set(D(), enter[axis]);
      leave_[axis] = hn::Set(D(), leave[axis]);
    }
  }

  bool is_ordinary() const { return is_ordinary_; }
  /// A bit is set where the direction is negative, or a negative zero.
  std::uint32_t octant() const { return octant_; }

  /// Where the ray first touches the half-spaces behind planes along its direction.
  V enter(int axis, V planes) const { return hn::MulSub(planes, inverse_[axis], enter_[axis]); }

  /// Where it last touches the half-spaces before planes.
  V leave(int axis, V planes) const { return hn::MulSub(planes, inverse_[axis], leave_[axis]); }

 private:
  using Axes = hn::CappedTag<hn::TFromD<D>, 4>;  // depends on D: not every processor has four lanes
  using F = hn::Vec<Axes>;
  static constexpr Axes f{};

  static F shifted_down(F v) {
    alignas(16) static constexpr std::int32_t lanes[] = {1, 2, 3, 0};
    return hn::TableLookupLanes(v, hn::SetTableIndices(f, lanes));
  }

  V inverse_[3], enter_[3], leave_[3];
  std::uint32_t octant_;
  bool is_ordinary_;
};

}  // namespace sightline
