#pragma once
/// The first boundary of convex parts along many rays at once.

#include <bit>
#include <limits>
#include <type_traits>

#include "sightline/csg/convex_lanes.h"
#include "sightline/csg/lane_refinement.h"
#include "sightline/csg/lane_roots.h"
#include "sightline/csg/solid_packet.h"
#include "sightline/csg/span_list.h"

namespace sightline {

/// LaneWalk with a ray in each lane, and one part of the solid after the other.
///   W1, W2 as of LaneWalk: every comparison is of enclosures that do not overlap, or the ray is left as unclear, and
///   which face it is that is passed is asked at the end. Rays from inside of a solid are unclear, too.
template <Level level>
class PacketWalk {
 public:
  static constexpr std::size_t size = SolidPacket<level>::size;
  using Real = typename SolidPacket<level>::Real;
  using Row = typename SolidPacket<level>::Row;

  /// Of the rays asked for those that find a boundary, and unclear ones; the others meet nothing. `reached` are those
  /// for which faces were solved.
  std::uint32_t found = 0, unclear = 0, reached = 0;

  PacketWalk(const ConvexLanes& lanes, const SolidPacket<level>& rays) : lanes_(lanes), rays_(rays) {}

  /// The first boundary with t_min < t, as far as it is not surely beyond each ray's limit. With `refines` most are as
  /// accurate as level watertight asks for.
  template <bool refines>
  void run(std::uint32_t asked, const typename RayPacket<double>::Lanes& limits) {
    unclear = asked & ~rays_.moderate();
    asked &= rays_.moderate();
    for (std::uint32_t i = 0; i < size; i += step) {
      const std::uint32_t part = asked >> i & ((1u << step) - 1);
      if (part == 0) continue;
      const Limits range = range_of(i, limits);
      Chunk chunk(lanes_, rays_, i, part);
      chunk.template run<refines>(range);
      found |= bits_of(d, chunk.is_found) << i;
      unclear |= bits_of(d, chunk.is_unclear) << i;
      reached |= bits_of(d, chunk.is_reached) << i;
      hn::Store(chunk.t, d, t_.data() + i), hn::Store(chunk.radius, d, radius_.data() + i);
      hn::Store(chunk.face, d, face_.data() + i);
    }
  }

  /// Of rays that have found one those whose one is surely in their range, however it is refined.
  std::uint32_t surely_within(const typename RayPacket<double>::Lanes& limits) const {
    std::uint32_t sure = 0;
    for (std::uint32_t rest = found; rest != 0; rest &= rest - 1) {
      const auto ray = static_cast<std::size_t>(std::countr_zero(rest));
      const double t = static_cast<double>(t_[ray]), known = 3 * static_cast<double>(radius_[ray]);
      // Rounding keeps the order.
      const bool is_sure = t - known > rays_.rays().nearest()[ray] && t + known <= limits[ray] &&
                           t + known < std::numeric_limits<double>::infinity();
      sure |= std::uint32_t{is_sure} << ray;
    }
    return sure;
  }

  /// Of a ray that has found one.
  Boundary boundary(std::size_t ray) const {
    Boundary boundary(static_cast<double>(t_[ray]), static_cast<double>(radius_[ray]), 0, 0, 0);
    const auto number = static_cast<std::uint32_t>(face_[ray]);
    const std::uint32_t lane = number / faces, face = number % faces;
    if (face == at_plane_of_kept) {
      const auto axis = static_cast<int>(lane);
      const ConvexLanes::Face& plane = lanes_.face_of_plane(axis, rays_.is_negative(axis));
      boundary.primitive = plane.primitive, boundary.face = plane.face;
      return boundary;
    }
    const ConvexLanes::Lane& part = lanes_[lane];
    boundary.primitive = part.primitive;
    boundary.is_flipped = lane >= lanes_.kept_count();
    if (face == at_round) {
      boundary.root = boundary.is_flipped ? 1 : 0;
    } else {
      const bool is_upper = !rays_.is_negative(static_cast<int>(face));
      boundary.face = part.is_box ? 2 * face + is_upper : (is_upper == part.goes_up ? 2 : 1);
    }
    return boundary;
  }

 private:
  static constexpr hn::CappedTag<Real, size> d{};
  using D = std::remove_const_t<decltype(d)>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  using Roots = LaneRoots<level, D>;
  using Passings = LanePassings<level, D>;
  static constexpr std::uint32_t step = static_cast<std::uint32_t>(hn::MaxLanes(d));

  /// Faces of a lane: the slabs across the axes, 0 to 2, and these.
  enum : std::uint32_t { at_round = 3, at_plane_of_kept = 4, faces = 8 };

  /// Where rays begin and end; in floats what those lie between.
  struct Limits {
    V lo_below, lo_above, hi_above;
  };
  Limits range_of(std::size_t i, const typename RayPacket<double>::Lanes& limits) const {
    const auto& nearest = rays_.rays().nearest();
    if constexpr (level == Level::fast) {
      Row lo_below, lo_above, hi_above;
      for (std::size_t k = i; k < i + step; ++k) {
        lo_below[k] = round_down(nearest[k]), lo_above[k] = round_up(nearest[k]), hi_above[k] = round_up(limits[k]);
      }
      return {hn::Load(d, &lo_below[i]), hn::Load(d, &lo_above[i]), hn::Load(d, &hi_above[i])};
    } else {
      const V lo = hn::Load(d, &nearest[i]);
      return {lo, lo, hn::Load(d, &limits[i])};
    }
  }

  /// What is known of a t in each lane: it is in [lo, hi].
  struct Enclosures {
    V lo, hi;

    void raise_to(const Enclosures& other) { lo = hn::Max(lo, other.lo), hi = hn::Max(hi, other.hi); }
    void lower_to(const Enclosures& other) { lo = hn::Min(lo, other.lo), hi = hn::Min(hi, other.hi); }
  };
  static Enclosures around(V t, V radius) {
    if constexpr (level == Level::fast) return {t, t};
    const V twice = hn::Add(radius, radius);
    return {hn::Sub(t, twice), hn::Add(t, twice)};
  }
  static Enclosures around(V t) { return {Passings::lower(t), Passings::upper(t)}; }
  static Enclosures chosen(M first, const Enclosures& a, const Enclosures& b) {
    return {hn::IfThenElse(first, a.lo, b.lo), hn::IfThenElse(first, a.hi, b.hi)};
  }

  /// Where a part lies along the rays.
  struct Span {
    Enclosures enter, leave;
    M is_open;  ///< Not empty, and not left yet.
    V t[2], radius[2];
  };

  /// As many rays as there are lanes.
  class Chunk {
   public:
    M is_found, is_unclear, is_reached;
    V t, radius, face;

    Chunk(const ConvexLanes& lanes, const SolidPacket<level>& rays, std::size_t first, std::uint32_t asked)
        : lanes_(lanes), rows_(lanes.rows<Real>()), rays_(rays), first_(first) {
      const std::uint8_t bits[8] = {static_cast<std::uint8_t>(asked), static_cast<std::uint8_t>(asked >> 8)};
      is_open_ = hn::LoadMaskBits(d, bits);
      is_found = is_unclear = is_reached = no_lanes(d);
      t = radius = face = hn::Zero(d);
    }

    template <bool refines>
    [[gnu::always_inline]] void run(const Limits& range) {
      common(range);
      is_reached = is_open_;
      if (hn::AllFalse(d, is_open_)) return;
      for (std::uint32_t lane = 0; lane < lanes_.kept_count(); ++lane) {
        Span& span = spans_[lane];
        find_round(lane, span);
        enter_.raise_to(span.enter), leave_.lower_to(span.leave);
      }
      drop(beyond(range));
      give_up(hn::Not(hn::And(hn::Lt(enter_.hi, leave_.lo), hn::Gt(leave_.lo, range.lo_above))));
      const M is_ahead = hn::Gt(enter_.lo, range.lo_above);
      give_up(hn::AndNot(is_ahead, hn::Not(hn::Lt(enter_.hi, range.lo_below))));
      if (hn::AllFalse(d, is_open_)) return;
      at_ = chosen(is_ahead, enter_, {range.lo_below, range.lo_above});
      const std::uint32_t first_taken = lanes_.kept_count();
      M has_moved = no_lanes(d);
      if (lanes_.count() > first_taken) {
        for (std::uint32_t lane = first_taken; lane < lanes_.count(); ++lane) find_taken(lane, spans_[lane]);
        has_moved = advance(range);
      }
      give_up(hn::AndNot(has_moved, hn::Not(is_ahead)));
      if (!hn::AllFalse(d, hn::And(is_open_, has_moved))) end_of_taken(hn::And(is_open_, has_moved));
      const M stayed = hn::AndNot(has_moved, is_open_);
      if (!hn::AllFalse(d, stayed)) end_of_kept(stayed);
      if constexpr (refines && level == Level::watertight) refine();
    }

   private:
    void drop(M which) { is_open_ = hn::AndNot(which, is_open_); }
    void give_up(M which) {
      is_unclear = hn::Or(is_unclear, hn::And(which, is_open_));
      drop(which);
    }

    V passing(int axis, Real position) const {
      const V away = hn::Sub(hn::Set(d, position), hn::Load(d, rays_.origin(axis) + first_));
      return hn::Mul(away, hn::Load(d, rays_.inverse(axis) + first_));
    }
    /// Of the plane of what is kept through which rays enter along an axis, or leave.
    V passing_of_kept(int axis, bool enters) const {
      const bool is_upper = rays_.is_negative(axis) == enters;
      return passing(axis, (is_upper ? rows_.upper : rows_.lower)[static_cast<std::size_t>(axis)]);
    }
    V passing_of_slab(int axis, std::uint32_t lane, bool enters) const {
      const bool is_upper = rays_.is_negative(axis) == enters;
      return passing(axis, (is_upper ? rows_.hi : rows_.lo)[static_cast<std::size_t>(axis)][lane]);
    }
    M beyond(const Limits& range) const {
      return hn::Or(hn::Gt(enter_.lo, leave_.hi),
                    hn::Or(hn::Lt(leave_.hi, range.lo_below), hn::Gt(enter_.lo, range.hi_above)));
    }

    /// Between the planes of what is kept.
    void common(const Limits& range) {
      V in[3], out[3];
      for (int axis = 0; axis < 3; ++axis)
        in[axis] = passing_of_kept(axis, true), out[axis] = passing_of_kept(axis, false);
      enter_ = around(hn::Max(in[0], hn::Max(in[1], in[2])));
      leave_ = around(hn::Min(out[0], hn::Min(out[1], out[2])));
      drop(beyond(range));
    }

    Roots roots_of(std::uint32_t lane) const {
      V along[3], away[3];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        const V weight = hn::Set(d, rows_.weight[axis][lane]);
        along[axis] = hn::Mul(hn::Load(d, rays_.direction(i) + first_), weight);
        const V center = hn::Set(d, rows_.center[axis][lane]);
        away[axis] = hn::Mul(hn::Sub(hn::Load(d, rays_.origin(i) + first_), center), weight);
      }
      return Roots(along, away,
                   {hn::Set(d, rows_.square[lane]), hn::Set(d, rows_.error_a[lane]), hn::Set(d, rows_.error_b[lane]),
                    hn::Set(d, rows_.error_c[lane])});
    }

    /// Sets all but is_open.
    void take_roots(const Roots& roots, Span& span) const {
      for (std::size_t i = 0; i < 2; ++i) span.t[i] = roots.t[i], span.radius[i] = roots.radius[i];
      span.enter = around(roots.t[0], roots.radius[0]), span.leave = around(roots.t[1], roots.radius[1]);
    }

    /// Of a kept part: rays that miss it are out.
    void find_round(std::uint32_t lane, Span& span) {
      const Roots roots = roots_of(lane);
      take_roots(roots, span);
      drop(roots.are_none);
      give_up(hn::Not(roots.are_two));
    }

    void find_taken(std::uint32_t lane, Span& span) {
      const ConvexLanes::Lane& part = lanes_[lane];
      M is_empty = no_lanes(d), is_vague = is_empty;
      if (part.is_round) {
        const Roots roots = roots_of(lane);
        take_roots(roots, span);
        is_empty = roots.are_none;
        is_vague = hn::Not(hn::Or(roots.are_two, roots.are_none));
      } else {
        const V afar = hn::Set(d, LaneRows<Real>::afar);
        span.enter = {hn::Neg(afar), hn::Neg(afar)}, span.leave = {afar, afar};
      }
      for (int axis = 0; axis < 3; ++axis) {
        if (!part.is_box && part.cap_axis != axis) continue;
        span.enter.raise_to(around(passing_of_slab(axis, lane, true)));
        span.leave.lower_to(around(passing_of_slab(axis, lane, false)));
      }
      is_empty = hn::Or(is_empty, hn::AndNot(is_vague, hn::Gt(span.enter.lo, span.leave.hi)));
      is_vague = hn::Or(is_vague, hn::Not(hn::Lt(span.enter.hi, span.leave.lo)));
      span.is_open = hn::AndNot(is_empty, hn::Not(no_lanes(d)));
      give_up(hn::AndNot(is_empty, is_vague));
    }

    /// On to where no part that is taken away holds the place; returns for which rays that is another one.
    M advance(const Limits& range) {
      M has_moved = no_lanes(d), goes_on = is_open_;
      while (!hn::AllFalse(d, goes_on)) {
        M moved = no_lanes(d);
        for (std::uint32_t lane = lanes_.kept_count(); lane < lanes_.count(); ++lane) {
          Span& span = spans_[lane];
          const M is_inside = hn::And(hn::Lt(span.enter.hi, at_.lo), hn::Gt(span.leave.lo, at_.hi));
          const M is_outside = hn::Or(hn::Gt(span.enter.lo, at_.hi), hn::Lt(span.leave.hi, at_.lo));
          give_up(hn::AndNot(hn::Or(is_inside, is_outside), span.is_open));
          const M goes = hn::And(is_open_, hn::And(span.is_open, is_inside));
          at_ = chosen(goes, span.leave, at_);
          last_ = hn::IfThenElse(goes, hn::Set(d, static_cast<Real>(lane)), last_);
          span.is_open = hn::AndNot(goes, span.is_open);
          moved = hn::Or(moved, goes);
        }
        has_moved = hn::Or(has_moved, moved);
        drop(hn::And(moved, hn::Or(hn::Gt(at_.lo, leave_.hi), hn::Gt(at_.lo, range.hi_above))));
        give_up(hn::And(moved, hn::Not(hn::Lt(at_.hi, leave_.lo))));
        goes_on = hn::And(moved, is_open_);
      }
      return has_moved;
    }

    /// Which one of faces passed at about the same t it is: the only one that may be there.
    class Choice {
     public:
      Choice(M asked, const Enclosures& end)
          : end_(end), open_(asked), t_(hn::Zero(d)), radius_(t_), face_(t_), several_(no_lanes(d)), one_(several_) {}

      void add(const Enclosures& known, V t, V radius, std::uint32_t lane, std::uint32_t face) {
        const M is_apart = hn::Or(hn::Lt(known.hi, end_.lo), hn::Gt(known.lo, end_.hi));
        const M is_here = hn::AndNot(is_apart, open_);
        several_ = hn::Or(several_, hn::And(one_, is_here));
        one_ = hn::Or(one_, is_here);
        t_ = hn::IfThenElse(is_here, t, t_), radius_ = hn::IfThenElse(is_here, radius, radius_);
        face_ = hn::IfThenElse(is_here, hn::Set(d, static_cast<Real>(lane * faces + face)), face_);
      }
      void add_plane(V t, std::uint32_t lane, std::uint32_t face) {
        V radius = hn::Zero(d);
        if constexpr (level != Level::fast) {
          radius = hn::Add(hn::Mul(hn::Set(d, Real(QuickRay<level>::passing_share)), hn::Abs(t)),
                           hn::Set(d, Real(QuickRay<level>::passing_step)));
        }
        add(around(t), t, radius, lane, face);
      }
      void add_root(const Span& span, std::size_t index, std::uint32_t lane) {
        add(around(span.t[index], span.radius[index]), span.t[index], span.radius[index], lane, at_round);
      }
      void finish(Chunk& chunk) const {
        const M is_sure = hn::AndNot(several_, one_);
        chunk.is_found = hn::Or(chunk.is_found, is_sure);
        chunk.is_unclear = hn::Or(chunk.is_unclear, hn::AndNot(is_sure, open_));
        chunk.t = hn::IfThenElse(is_sure, t_, chunk.t), chunk.radius = hn::IfThenElse(is_sure, radius_, chunk.radius);
        chunk.face = hn::IfThenElse(is_sure, face_, chunk.face);
      }

     private:
      Enclosures end_;
      M open_;
      V t_, radius_, face_;
      M several_, one_;
    };

    void end_of_kept(M asked) {
      Choice choice(asked, enter_);
      for (int axis = 0; axis < 3; ++axis) {
        choice.add_plane(passing_of_kept(axis, true), static_cast<std::uint32_t>(axis), at_plane_of_kept);
      }
      for (std::uint32_t lane = 0; lane < lanes_.kept_count(); ++lane) choice.add_root(spans_[lane], 0, lane);
      choice.finish(*this);
    }

    void end_of_taken(M asked) {
      for (std::uint32_t lane = lanes_.kept_count(); lane < lanes_.count(); ++lane) {
        const M is_last = hn::And(asked, hn::Eq(last_, hn::Set(d, static_cast<Real>(lane))));
        if (hn::AllFalse(d, is_last)) continue;
        const ConvexLanes::Lane& part = lanes_[lane];
        Choice choice(is_last, at_);
        if (part.is_round) choice.add_root(spans_[lane], 1, lane);
        for (int axis = 0; axis < 3; ++axis) {
          if (!part.is_box && part.cap_axis != axis) continue;
          choice.add_plane(passing_of_slab(axis, lane, false), lane, static_cast<std::uint32_t>(axis));
        }
        choice.finish(*this);
      }
    }

    /// Roots that are not accurate by themselves.
    void refine() {
      const M is_accurate = hn::Le(radius, hn::Mul(hn::Set(d, 0x1p-46), hn::Abs(t)));
      const M is_rough = hn::AndNot(is_accurate, is_found);
      if (hn::AllFalse(d, is_rough)) return;
      for (std::uint32_t lane = 0; lane < lanes_.count(); ++lane) {
        if (!lanes_[lane].is_round) continue;
        const M is_here = hn::And(is_rough, hn::Eq(face, hn::Set(d, static_cast<Real>(lane * faces + at_round))));
        if (hn::AllFalse(d, is_here)) continue;
        const LaneRefinement refined(lanes_, lane, rays_, first_, t);
        const M is_refined = hn::And(is_here, lane < lanes_.kept_count() ? refined.is_lower : refined.is_upper);
        t = hn::IfThenElse(is_refined, refined.t, t), radius = hn::IfThenElse(is_refined, refined.radius, radius);
      }
    }

    const ConvexLanes& lanes_;
    const LaneRows<Real>& rows_;
    const SolidPacket<level>& rays_;
    std::size_t first_;
    M is_open_;
    Enclosures enter_, leave_, at_;
    V last_ = hn::Zero(d);
    Span spans_[ConvexLanes::capacity];
  };

  const ConvexLanes& lanes_;
  const SolidPacket<level>& rays_;
  Row t_, radius_, face_;
};

}  // namespace sightline
