#pragma once
/// Where a ray is inside all the lanes of a solid, found at once.

#include "sightline/csg/convex_lanes.h"
#include "sightline/csg/lane_roots.h"
#include "sightline/math/interval.h"
#include "sightline/math/rounding.h"

namespace sightline {

/// The spans of lanes along a ray, as far as they are clear.
/// What is known of a t is an interval that holds it.
///   S1  Roots are those of quick_span (lane_roots.h). Where that does not find two or none, surely, the lane is
///   unclear. S2  Intervals reach twice as far as the radius, which pays for their own rounding: radii are at least
///   2^-51 of t.
template <Level level>
class LaneSpans {
 public:
  using Real = typename QuickRay<level>::Real;

  LaneSpans(const ConvexLanes& lanes, const QuickRay<level>& ray) : lanes_(lanes) {
    for (std::uint32_t lane = 0; lane < lanes.count(); lane += step) find(lane, ray);
  }

  std::uint32_t empty() const { return empty_; }
  std::uint32_t unclear() const { return unclear_; }

  /// Of lanes that are neither empty nor unclear.
  Interval<double> enter(std::uint32_t lane) const { return enclosure(enter_lo_, enter_hi_, lane); }
  Interval<double> leave(std::uint32_t lane) const { return enclosure(leave_lo_, leave_hi_, lane); }

  /// Of a round lane, alone.
  Root root(std::uint32_t lane, std::uint32_t index) const {
    return {static_cast<double>(t_[index][lane]), level == Level::fast ? 0 : static_cast<double>(radius_[index][lane]),
            1};
  }
  static Interval<double> around(double t, double radius) {
    if constexpr (level == Level::fast) return {t, t};
    return {t - 2 * radius, t + 2 * radius};  // S2
  }

  /// Lanes that surely hold a place, and those that surely do not. Bits of others than clear ones mean nothing.
  struct Places {
    std::uint32_t inside = 0, outside = 0;
  };
  Places places(const Interval<double>& at) const {
    const V lo = hn::Set(d, rounded_down(at.lo)), hi = hn::Set(d, rounded_up(at.hi));
    Places places;
    for (std::uint32_t lane = 0; lane < lanes_.count(); lane += step) {
      const auto load = [&](const Row& row) { return hn::Load(d, row.data() + lane); };
      places.inside |= bits_of(d, hn::And(hn::Lt(load(enter_hi_), lo), hn::Gt(load(leave_lo_), hi))) << lane;
      places.outside |= bits_of(d, hn::Or(hn::Gt(load(enter_lo_), hi), hn::Lt(load(leave_hi_), lo))) << lane;
    }
    return places;
  }

 private:
  using Row = typename LaneRows<Real>::Row;
  static constexpr hn::CappedTag<Real, 32 / sizeof(Real)> d{};
  using V = hn::Vec<decltype(d)>;
  using M = hn::Mask<decltype(d)>;
  static constexpr std::uint32_t step = static_cast<std::uint32_t>(hn::MaxLanes(d));

  using Roots = LaneRoots<level, std::remove_const_t<decltype(d)>>;
  using Passings = LanePassings<level, std::remove_const_t<decltype(d)>>;

  static Real rounded_down(double x) {
    if constexpr (level == Level::fast) return round_down(x);
    return x;
  }
  static Real rounded_up(double x) {
    if constexpr (level == Level::fast) return round_up(x);
    return x;
  }

  static Interval<double> enclosure(const Row& lo, const Row& hi, std::uint32_t lane) {
    return {static_cast<double>(lo[lane]), static_cast<double>(hi[lane])};
  }

  [[gnu::always_inline]] void find(std::uint32_t lane, const QuickRay<level>& ray) {
    const LaneRows<Real>& rows = lanes_.rows<Real>();
    const std::uint32_t bits = ((1u << step) - 1) << lane, round = lanes_.round_bits() & bits;
    const V afar = hn::Set(d, LaneRows<Real>::afar);
    V enter_lo = hn::Neg(afar), enter_hi = enter_lo, leave_lo = afar, leave_hi = afar;
    std::uint32_t unclear = 0;
    if (round != 0) {
      const Roots roots = roots_of(rows, lane, ray);
      for (std::size_t i = 0; i < 2; ++i) {
        hn::Store(roots.t[i], d, t_[i].data() + lane);
        if constexpr (level != Level::fast) hn::Store(roots.radius[i], d, radius_[i].data() + lane);
      }
      const std::uint32_t two = bits_of(d, roots.are_two) << lane;
      empty_ |= (bits_of(d, roots.are_none) << lane) & round;
      unclear = round & ~two & ~empty_;
      const M is_round = hn::Ne(hn::Load(d, rows.is_round.data() + lane), hn::Zero(d));
      const auto kept = [&](V of_root, V other) { return hn::IfThenElse(is_round, of_root, other); };
      if constexpr (level == Level::fast) {
        enter_lo = enter_hi = kept(roots.t[0], enter_lo);
        leave_lo = leave_hi = kept(roots.t[1], leave_lo);
      } else {
        const V first = hn::Add(roots.radius[0], roots.radius[0]), second = hn::Add(roots.radius[1], roots.radius[1]);
        enter_lo = kept(hn::Sub(roots.t[0], first), enter_lo), enter_hi = kept(hn::Add(roots.t[0], first), enter_hi);
        leave_lo = kept(hn::Sub(roots.t[1], second), leave_lo), leave_hi = kept(hn::Add(roots.t[1], second), leave_hi);
      }
    }
    if (lanes_.has_slabs()) {
      V in, out;
      slabs(rows, lane, ray, in, out);
      enter_lo = hn::Max(enter_lo, Passings::lower(in)), enter_hi = hn::Max(enter_hi, Passings::upper(in));
      leave_lo = hn::Min(leave_lo, Passings::lower(out)), leave_hi = hn::Min(leave_hi, Passings::upper(out));
    }
    const std::uint32_t over = bits_of(d, hn::Gt(enter_lo, leave_hi)) << lane;
    const std::uint32_t open = bits_of(d, hn::Lt(enter_hi, leave_lo)) << lane;
    empty_ |= over & bits & ~unclear;
    unclear_ |= unclear | (bits & ~(empty_ | open));
    hn::Store(enter_lo, d, enter_lo_.data() + lane), hn::Store(enter_hi, d, enter_hi_.data() + lane);
    hn::Store(leave_lo, d, leave_lo_.data() + lane), hn::Store(leave_hi, d, leave_hi_.data() + lane);
  }

  /// QuickRay::passing of the planes, the last one in and the first one out.
  [[gnu::always_inline]] static void slabs(const LaneRows<Real>& rows, std::uint32_t lane, const QuickRay<level>& ray,
                                           V& in, V& out) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool is_up = ray.inverse()[static_cast<int>(axis)] > 0;
      const V origin = hn::Set(d, static_cast<Real>(ray.ray().origin[static_cast<int>(axis)]));
      const V inverse = hn::Set(d, ray.inverse()[static_cast<int>(axis)]);
      const auto passing = [&](const Row& row) {
        return hn::Mul(hn::Sub(hn::Load(d, row.data() + lane), origin), inverse);
      };
      const V near = passing((is_up ? rows.lo : rows.hi)[axis]), far = passing((is_up ? rows.hi : rows.lo)[axis]);
      in = axis == 0 ? near : hn::Max(in, near);
      out = axis == 0 ? far : hn::Min(out, far);
    }
  }

  [[gnu::always_inline]] static Roots roots_of(const LaneRows<Real>& rows, std::uint32_t lane,
                                               const QuickRay<level>& ray) {
    const auto load = [&](const Row& row) { return hn::Load(d, row.data() + lane); };
    V along[3], away[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto real = [&](const Vec3d& v) { return hn::Set(d, static_cast<Real>(v[static_cast<int>(axis)])); };
      const V weight = load(rows.weight[axis]);
      along[axis] = hn::Mul(real(ray.ray().direction), weight);
      away[axis] = hn::Mul(hn::Sub(real(ray.ray().origin), load(rows.center[axis])), weight);
    }
    return Roots(along, away, {load(rows.square), load(rows.error_a), load(rows.error_b), load(rows.error_c)});
  }

  const ConvexLanes& lanes_;
  std::uint32_t empty_ = 0, unclear_ = 0;
  alignas(32) Row enter_lo_, enter_hi_, leave_lo_, leave_hi_;
  alignas(32) std::array<Row, 2> t_, radius_;
};

}  // namespace sightline
