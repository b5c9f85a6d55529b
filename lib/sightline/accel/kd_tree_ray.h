#pragma once
/// A ray as a kd-tree's traversal needs it: against the splits of one treelet at a time.

#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "sightline/accel/kd_tree_treelet.h"
#include "sightline/accel/padded_ray.h"
#include "sightline/math/simd.h"

namespace sightline::detail {

/// A ray against treelets: each of its planes is in front of some children and behind others.
///
/// The padded ray is in a plane's near half until `leave` and in its far half from `enter` on; a child's cell is the
/// intersection of the halves along its path. The halves overlap by the margin.
template <class T>
class KdRay {
 public:
  KdRay(const Ray<T>& ray, const Aabb& bounds) : padded_(ray, bounds), range_(padded_.clip(bounds, padded_.t_max)) {}

  /// Parameters at which the ray is within the bounds; empty where it is not, or is broken.
  Interval<T> range() const { return range_; }

  /// Puts the children that the ray meets between `enter` and `leave` on the stack, farthest first.
  void step(const KdTreelet& treelet, T enter, T leave, KdStack<T>& stack) const {
    std::array<T, 7> enters, leaves;
    unsigned negative = 0;
    for (int plane = 0; plane < 7; ++plane) {
      const int axis = treelet.axis(plane);
      enters[plane] = padded_.enter(axis, treelet.planes[plane]);
      leaves[plane] = padded_.leave(axis, treelet.planes[plane]);
      negative |= static_cast<unsigned>(padded_.is_negative[axis]) << plane;
    }
    for (unsigned lane = 0; lane < 8; ++lane) {
      const unsigned child = kd_orders[negative][lane];
      T lo = enter, hi = leave;
      for (int level = 0; level < 3; ++level) {
        const unsigned plane = (1u << level) - 1 + (child >> (3 - level));
        if ((lane >> (2 - level) & 1) == 0) {
          lo = enters[plane] > lo ? enters[plane] : lo;
        } else {
          hi = leaves[plane] < hi ? leaves[plane] : hi;
        }
      }
      if (treelet.children[child].is_empty() || lo > hi) continue;  // NaN keeps the child
      stack.children[stack.size] = treelet.children[child];
      stack.enters[stack.size] = lo;
      stack.leaves[stack.size] = hi;
      ++stack.size;
    }
  }

 private:
  PaddedRay<T> padded_;
  Interval<T> range_;
};

#if HWY_TARGET != HWY_SCALAR

/// The same with eight lanes, one a child. A template, so that it need not compile where there are fewer.
template <class T>
class KdVectorRay {
  using D = hn::CappedTag<T, KdTreelet::width>;
  using I = hn::RebindToUnsigned<D>;
  using V = hn::Vec<D>;
  using N = hn::Vec<I>;
  static constexpr D d{};
  static constexpr I i{};
  using Axes = hn::CappedTag<T, 4>;
  using F = hn::Vec<Axes>;
  static constexpr Axes f{};

 public:
  /// PaddedRay and its clip with four lanes, one an axis, of which the last is spare.
  KdVectorRay(const Ray<float>& ray, const Aabb& bounds) {
    const auto is_axis = hn::FirstN(f, 3);
    const F origin = hn::IfThenElseZero(is_axis, hn::LoadU(f, &ray.origin.x));  // reads into the direction, and so on
    const F direction = hn::IfThenElseZero(is_axis, hn::LoadU(f, &ray.direction.x));
    const F lows = hn::LoadU(f, &bounds.lo.x), highs = hn::Shuffle0321(hn::LoadU(f, &bounds.lo.z));
    const F size = hn::MaxOfLanes(f, hn::Abs(direction));
    const F largest = hn::Set(f, std::numeric_limits<float>::max()), zero = hn::Zero(f);
    const auto is_finite = hn::And(hn::Le(hn::Abs(origin), largest), hn::Le(hn::Abs(direction), largest));
    const bool is_broken = !hn::AllTrue(f, hn::And(is_finite, hn::Gt(size, zero))) || !(ray.t_min <= ray.t_max);

    const F to_bounds = hn::Max(hn::Abs(hn::Sub(lows, origin)), hn::Abs(hn::Sub(highs, origin)));
    const F reach = hn::MaxOfLanes(f, hn::IfThenElseZero(is_axis, to_bounds));
    const F pad = hn::Set(f, pad_of(hn::GetLane(reach), hn::GetLane(size)));
    const F inverse = hn::Div(hn::Set(f, 1.0f), direction);
    // A direction too small to invert moves the ray all the same: no plane bounds it.
    const auto is_unbounded = hn::And(hn::Gt(hn::Abs(inverse), largest), hn::Ne(direction, zero));
    const F infinity = hn::Set(f, std::numeric_limits<float>::infinity());
    const F wide = hn::IfThenElse(is_unbounded, infinity, pad);
    const F rounding = hn::Mul(hn::Set(f, 2 * std::numeric_limits<float>::epsilon()), hn::Add(hn::Abs(origin), wide));
    const F shift = hn::CopySign(hn::Add(wide, rounding), inverse);
    const F enter = hn::Add(origin, shift), leave = hn::Sub(origin, shift);

    const auto is_negative = hn::Lt(inverse, zero);
    const F t_min = hn::Set(f, ray.t_min), t_max = hn::Set(f, ray.t_max);
    const F enters = hn::Mul(hn::Sub(hn::IfThenElse(is_negative, highs, lows), enter), inverse);
    const F leaves = hn::Mul(hn::Sub(hn::IfThenElse(is_negative, lows, highs), leave), inverse);
    range_.lo = hn::GetLane(hn::MaxOfLanes(f, hn::IfThenElse(is_axis, larger(enters, t_min), t_min)));
    range_.hi = hn::GetLane(hn::MinOfLanes(f, hn::IfThenElse(is_axis, smaller(leaves, t_max), t_max)));
    if (is_broken) range_ = {1, 0};

    enter_ = hn::Combine(d, enter, enter);
    leave_ = hn::Combine(d, leave, leave);
    inverse_ = hn::Combine(d, inverse, inverse);
    std::uint8_t negative[8] = {};
    hn::StoreMaskBits(f, is_negative, negative);
    const auto bits = [](bool is_set) { return is_set ? 127u : 0u; };
    x_ = bits(negative[0] & 1);
    xy_ = bits((negative[0] ^ negative[0] >> 1) & 1);
    xz_ = bits((negative[0] ^ negative[0] >> 2) & 1);
  }

  Interval<float> range() const { return range_; }

  [[gnu::always_inline]] void step(const KdTreelet& treelet, float enter, float leave, KdStack<float>& stack) const {
    const std::uint32_t negative = (x_ ^ (treelet.axes >> 16 & xy_) ^ (treelet.axes >> 24 & xz_)) & 127;
    const N order = hn::PromoteTo(i, hn::Load(hn::Rebind<std::uint8_t, I>(), kd_orders[negative].data()));

    const V planes = hn::Load(d, treelet.planes.data());  // the last lane is of no plane
    const N lane = hn::Iota(i, 0u);
    const auto by_axis =
        hn::IndicesFromVec(d, hn::And(hn::Set(i, treelet.axes) >> hn::Add(lane, lane), hn::Set(i, 3u)));
    const V inverse = hn::TableLookupLanes(inverse_, by_axis);
    const V enters = hn::Mul(hn::Sub(planes, hn::TableLookupLanes(enter_, by_axis)), inverse);
    const V leaves = hn::Mul(hn::Sub(planes, hn::TableLookupLanes(leave_, by_axis)), inverse);

    // Of each level a lane takes one number: where it is in a far half when that is entered, else where the near half
    // is left. NaN keeps the child.
    const V infinity = hn::Set(d, std::numeric_limits<float>::infinity());
    const auto bounds = [&](N plane, std::uint32_t near_bit, V& lo, V& hi) {
      const auto at = hn::IndicesFromVec(d, plane);
      const auto is_near = hn::RebindMask(d, hn::Ne(hn::And(lane, hn::Set(i, near_bit)), hn::Zero(i)));
      lo = hn::IfThenElse(is_near, hn::Neg(infinity), hn::TableLookupLanes(enters, at));
      hi = hn::IfThenElse(is_near, hn::TableLookupLanes(leaves, at), infinity);
    };
    V lo0, lo1, lo2, hi0, hi1, hi2;
    bounds(hn::Zero(i), 4, lo0, hi0);
    bounds(hn::Add(hn::ShiftRight<2>(order), hn::Set(i, 1u)), 2, lo1, hi1);
    bounds(hn::Add(hn::ShiftRight<1>(order), hn::Set(i, 3u)), 1, lo2, hi2);
    const V lo = larger(lo1, larger(lo2, larger(lo0, hn::Set(d, enter))));
    const V hi = smaller(hi1, smaller(hi2, smaller(hi0, hn::Set(d, leave))));

    const N children = hn::TableLookupLanes(
        hn::Load(i, reinterpret_cast<const std::uint32_t*>(treelet.children.data())), hn::IndicesFromVec(i, order));
    const auto is_met = hn::AndNot(hn::Gt(lo, hi), hn::RebindMask(d, hn::Ne(children, hn::Zero(i))));
    hn::StoreU(hn::Compress(children, hn::RebindMask(i, is_met)), i,
               reinterpret_cast<std::uint32_t*>(stack.children.data() + stack.size));
    hn::StoreU(hn::Compress(lo, is_met), d, stack.enters.data() + stack.size);
    hn::StoreU(hn::Compress(hi, is_met), d, stack.leaves.data() + stack.size);
    stack.size += hn::CountTrue(d, is_met);
  }

 private:
  Interval<float> range_;
  V enter_, leave_, inverse_;  ///< By axis, and again from the fifth lane on.
  std::uint32_t x_, xy_, xz_;  ///< Seven bits of sign x, and of whether y's and z's differ from it.
};

inline constexpr bool kd_has_vectors = hn::MaxLanes(hn::CappedTag<float, KdTreelet::width>()) == KdTreelet::width;

template <class T>
using KdRayOf = std::conditional_t<std::is_same_v<T, float> && kd_has_vectors, KdVectorRay<T>, KdRay<T>>;

#else

template <class T>
using KdRayOf = KdRay<T>;

#endif

}  // namespace sightline::detail
