#pragma once
/// Rays that look the same way, to be traced together.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sightline/accel/padded_ray.h"
#include "sightline/math/simd.h"

namespace sightline {

/// Up to sixteen rays, padded as PaddedRay pads one, and what holds them all: an interval of origins and one of inverse
/// directions on each axis, which a structure takes for a single ray.
///   P1  Coherent rays are of one octant, and ordinary: no number is so large or so small, nor a component of the
///       direction 0, that anything overflows, or underflows by more than 2^-29 of reach (float; 2^-74 double). That is
///       less than a rounding, of which M2 has some to spare.
///   P2  Rounding keeps the order of numbers. So the packet enters a half-space no later than any of its rays as
///       computed, and leaves it no earlier: a region that the packet skips is one that each ray skips.
/// Boulos, Wald and Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006; Reshetov,
/// Soupikov and Hurley, "Multi-Level Ray Tracing Algorithm", 2005 (intervals instead of rays).
template <class T>
class RayPacket {
 public:
  static constexpr std::size_t size = 16;
  struct alignas(64) Lanes : std::array<T, size> {};

  /// What of a packet concerns one axis.
  struct Axis {
    T enter_origin, leave_origin;
    T slow, fast;  ///< The ends of the interval of inverse directions.

    T enter(float plane) const { return std::min((plane - enter_origin) * slow, (plane - enter_origin) * fast); }
    T leave(float plane) const { return std::max((plane - leave_origin) * slow, (plane - leave_origin) * fast); }
  };

  /// Of 1 to `size` rays. `bounds` holds all that they are to be tested with.
  RayPacket(std::span<const Ray<T>> rays, const Aabb& bounds) {
    take(rays);
    is_coherent_ = prepare(bounds);
    if (is_coherent_) join();
  }

  /// Whether the rays can go together. If not, nothing else is to be asked.
  bool is_coherent() const { return is_coherent_; }

  /// As of a PaddedRay.
  bool is_negative[3];
  T t_min, t_max;
  const Axis& along(int axis) const { return axes_[axis]; }
  /// Of each ray, not padded; places beyond the last one repeat that.
  const Lanes& origins(int axis) const { return origin_[axis]; }
  const Lanes& directions(int axis) const { return direction_[axis]; }
  const Lanes& inverses(int axis) const { return inverse_[axis]; }
  const Lanes& nearest() const { return t_min_; }   ///< Each t_min.
  const Lanes& farthest() const { return t_max_; }  ///< Each t_max.
  Interval<T> clip(const Aabb& box, T far) const {
    Interval<T> range{t_min, far};
    for (int axis = 0; axis < 3; ++axis) {
      range.lo = std::max(range.lo, along(axis).enter(is_negative[axis] ? box.hi[axis] : box.lo[axis]));
      range.hi = std::min(range.hi, along(axis).leave(is_negative[axis] ? box.lo[axis] : box.hi[axis]));
    }
    return range;
  }

  /// A bit for each ray that meets the box no later than its own limit.
  std::uint32_t meeting(const Aabb& box, const Lanes& limits) const {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < size; i += step) {
      V lo = at(t_min_, i), hi = at(limits, i);
      for (int axis = 0; axis < 3; ++axis) {
        const V near_plane = set((is_negative[axis] ? box.hi : box.lo)[axis]);
        const V far_plane = set((is_negative[axis] ? box.lo : box.hi)[axis]);
        const V inverse = at(inverse_[axis], i);
        lo = hn::Max(lo, hn::Mul(hn::Sub(near_plane, at(enter_origin_[axis], i)), inverse));
        hi = hn::Min(hi, hn::Mul(hn::Sub(far_plane, at(leave_origin_[axis], i)), inverse));
      }
      bits |= bits_of(d, hn::Le(lo, hi)) << i;
    }
    return bits;
  }

  static T least(const Lanes& lanes) {
    V v = at(lanes, 0);
    for (std::size_t i = step; i < size; i += step) v = hn::Min(v, at(lanes, i));
    return hn::GetLane(hn::MinOfLanes(d, v));
  }
  static T greatest(const Lanes& lanes) {
    V v = at(lanes, 0);
    for (std::size_t i = step; i < size; i += step) v = hn::Max(v, at(lanes, i));
    return hn::GetLane(hn::MaxOfLanes(d, v));
  }

 private:
  static constexpr hn::CappedTag<T, size> d{};
  using V = hn::Vec<decltype(d)>;
  static constexpr std::size_t step = hn::MaxLanes(d);
  static constexpr T largest = sizeof(T) == sizeof(float) ? T(0x1p+60) : T(0x1p+500);  // P1

  static V set(T x) { return hn::Set(d, x); }
  static V at(const Lanes& lanes, std::size_t i) { return hn::Load(d, lanes.data() + i); }

  /// Lanes beyond the last ray repeat that one.
  void take(std::span<const Ray<T>> rays) {
    for (std::size_t i = 0; i < size; ++i) {
      const Ray<T>& ray = rays[std::min(i, rays.size() - 1)];
      for (int axis = 0; axis < 3; ++axis) {
        origin_[axis][i] = ray.origin[axis];
        direction_[axis][i] = ray.direction[axis];
      }
      t_min_[i] = ray.t_min;
      t_max_[i] = ray.t_max;
    }
  }

  /// False where P1 does not hold.
  bool prepare(const Aabb& bounds) {
    const V most = set(largest), fewest = set(1 / largest);
    const auto is_size = [&](V x) { return hn::And(hn::Ge(x, fewest), hn::Le(x, most)); };
    std::uint32_t ordinary = 0, negative[3] = {};
    for (std::size_t i = 0; i < size; i += step) {
      V reach = hn::Zero(d);
      auto is_ordinary = hn::Le(at(t_min_, i), at(t_max_, i));
      for (int axis = 0; axis < 3; ++axis) {
        const V origin = at(origin_[axis], i);
        const V to_lo = hn::Abs(hn::Sub(set(bounds.lo[axis]), origin));
        const V to_hi = hn::Abs(hn::Sub(set(bounds.hi[axis]), origin));
        reach = hn::Max(reach, hn::Max(to_lo, to_hi));
        is_ordinary = hn::And(is_ordinary, hn::Le(hn::Abs(origin), most));
      }
      is_ordinary = hn::And(is_ordinary, is_size(reach));
      const V pad = hn::Mul(reach, set(margin<T>));
      for (int axis = 0; axis < 3; ++axis) {
        const V origin = at(origin_[axis], i), direction = at(direction_[axis], i);
        constexpr T rounding = 2 * std::numeric_limits<T>::epsilon();  // as of PaddedRay
        const V away = hn::CopySign(hn::Add(pad, hn::Mul(set(rounding), hn::Add(hn::Abs(origin), pad))), direction);
        hn::Store(hn::Add(origin, away), d, enter_origin_[axis].data() + i);
        hn::Store(hn::Sub(origin, away), d, leave_origin_[axis].data() + i);
        hn::Store(hn::Div(set(1), direction), d, inverse_[axis].data() + i);
        is_ordinary = hn::And(is_ordinary, is_size(hn::Abs(direction)));
        negative[axis] |= bits_of(d, hn::Lt(direction, hn::Zero(d))) << i;
      }
      ordinary |= bits_of(d, is_ordinary) << i;
    }
    constexpr std::uint32_t all = (1u << size) - 1;
    bool is_one_octant = true;
    for (int axis = 0; axis < 3; ++axis) {
      is_negative[axis] = negative[axis] != 0;
      is_one_octant &= negative[axis] == 0 || negative[axis] == all;
    }
    return is_one_octant && ordinary == all;
  }

  /// P2: of the origins the one from which planes are entered first, or left last.
  void join() {
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes &enters = enter_origin_[axis], &leaves = leave_origin_[axis], &inverses = inverse_[axis];
      axes_[axis] = {is_negative[axis] ? least(enters) : greatest(enters),
                     is_negative[axis] ? greatest(leaves) : least(leaves), least(inverses), greatest(inverses)};
    }
    t_min = least(t_min_);
    t_max = greatest(t_max_);
  }

  Lanes origin_[3], direction_[3], enter_origin_[3], leave_origin_[3], inverse_[3], t_min_, t_max_;
  Axis axes_[3];
  bool is_coherent_;
};

}  // namespace sightline
