#pragma once
/// The first boundary of convex parts, all of which are met at once.

#include <bit>

#include "sightline/csg/lane_spans.h"
#include "sightline/csg/solid.h"

namespace sightline {

/// ConvexWalk by lanes: in at the last face of what is kept, then, as long as that is within a lane that is taken away,
/// on to where that ends.
///   W1  Every comparison is of enclosures that do not overlap, or the walk gives up.
///   W2  Which face it is that a lane, or what is kept, begins or ends with is asked at the end, and only of the one
///       that is found.
template <Level level, class Probe>
class LaneWalk {
 public:
  LaneWalk(const ConvexLanes& lanes, const QuickRay<level>& ray, Probe& probe)
      : lanes_(lanes), ray_(ray), probe_(probe) {}

  /// The first boundary with lo < t, as far as it is not surely beyond `hi`. No component of the direction is 0.
  [[gnu::always_inline]] WalkOutcome run(double lo, double hi, Boundary& first) {
    if (!ray_.is_moderate()) return WalkOutcome::unclear;
    double in[3], out[3];
    for (int axis = 0; axis < 3; ++axis) in[axis] = passing(axis, true), out[axis] = passing(axis, false);
    Interval<double> enter = around(larger(in[0], larger(in[1], in[2]))),
                     leave = around(smaller(out[0], smaller(out[1], out[2])));
    if ((enter.lo > leave.hi) | (leave.hi < lo) | (enter.lo > hi)) return WalkOutcome::none;
    return within(enter, leave, lo, hi, first);
  }

 private:
  using Spans = LaneSpans<level>;
  using Real = typename QuickRay<level>::Real;

  static double larger(double a, double b) { return a > b ? a : b; }
  static double smaller(double a, double b) { return a < b ? a : b; }

  /// Of the plane of what is kept through which the ray enters along an axis, or leaves.
  [[gnu::always_inline]] double passing(int axis, bool enters) const {
    const LaneRows<Real>& rows = lanes_.template rows<Real>();
    const bool is_upper = (ray_.inverse()[axis] > 0) != enters;
    return ray_.passing(axis, (is_upper ? rows.upper : rows.lower)[static_cast<std::size_t>(axis)]);
  }
  static Interval<double> around(double t) { return Spans::around(t, QuickRay<level>::radius_of(t)); }

  WalkOutcome within(Interval<double> enter, Interval<double> leave, double lo, double hi, Boundary& first) const {
    const Spans spans(lanes_, ray_);
    for (std::uint32_t lane = 0; lane < lanes_.count(); ++lane) probe_.primitive(lanes_[lane].primitive);
    const std::uint32_t kept = (1u << lanes_.kept_count()) - 1;
    if (spans.unclear() & kept) return WalkOutcome::unclear;
    if (spans.empty() & kept) return WalkOutcome::none;
    for (std::uint32_t lane = 0; lane < lanes_.kept_count(); ++lane) {
      const Interval<double> in = spans.enter(lane), out = spans.leave(lane);
      enter = {larger(enter.lo, in.lo), larger(enter.hi, in.hi)};
      leave = {smaller(leave.lo, out.lo), smaller(leave.hi, out.hi)};
    }
    if ((enter.lo > leave.hi) | (leave.hi < lo) | (enter.lo > hi)) return WalkOutcome::none;
    if (!(enter.hi < leave.lo) || !(leave.lo > lo)) return WalkOutcome::unclear;
    const bool is_ahead = enter.lo > lo;
    if (!is_ahead && !(enter.hi < lo)) return WalkOutcome::unclear;

    // On to where no lane that is taken away holds the place.
    constexpr std::uint32_t none = ConvexLanes::capacity;
    Interval<double> at = is_ahead ? enter : Interval<double>{lo, lo};
    std::uint32_t last = none, open = lanes_.taken_bits() & ~spans.empty();
    while (open != 0) {
      const auto places = spans.places(at);
      const std::uint32_t inside = places.inside & open;
      if (open & (spans.unclear() | ~(places.inside | places.outside))) return WalkOutcome::unclear;
      if (inside == 0) break;
      last = static_cast<std::uint32_t>(std::countr_zero(inside));
      at = spans.leave(last);
      if ((at.lo > leave.hi) | (at.lo > hi)) return WalkOutcome::none;
      if (!(at.hi < leave.lo)) return WalkOutcome::unclear;
      open &= ~(1u << last);
    }
    if (last != none) return end_of(spans, last, false, at, first);
    if (is_ahead) return end_of_kept(spans, true, enter, first);

    // From inside of the solid: the nearest way out. Lanes that are still open are ahead, or behind.
    for (; open != 0; open &= open - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(open));
      const Interval<double> in = spans.enter(lane);
      if ((in.hi < lo) | (in.lo > leave.hi)) continue;
      if (!(in.hi < leave.lo)) return WalkOutcome::unclear;
      leave = in, last = lane;
    }
    if (leave.lo > hi) return WalkOutcome::none;
    return last != none ? end_of(spans, last, true, leave, first) : end_of_kept(spans, false, leave, first);
  }

  /// Which one of faces passed at about the same t it is: the only one that may be there.
  struct Choice {
    const Interval<double>& end;
    Boundary& boundary;
    int count = 0;

    void add(const Boundary& face) {
      const Interval<double> known = Spans::around(face.t, face.radius);
      if ((known.hi < end.lo) | (known.lo > end.hi)) return;
      boundary = face;
      ++count;
    }
    WalkOutcome outcome() const { return count == 1 ? WalkOutcome::found : WalkOutcome::unclear; }
  };

  static Boundary crossing(const ConvexLanes::Face& face, double t) {
    return {t, QuickRay<level>::radius_of(t), face.primitive, face.face, 0};
  }
  Boundary round(const Spans& spans, std::uint32_t lane, bool enters) const {
    const Root root = spans.root(lane, enters ? 0 : 1);
    return {root.t, root.radius, lanes_[lane].primitive, 0, enters ? 0u : 1u};
  }

  WalkOutcome end_of_kept(const Spans& spans, bool enters, const Interval<double>& end, Boundary& first) const {
    Choice choice{end, first};
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_upper = (ray_.inverse()[axis] > 0) != enters;
      choice.add(crossing(lanes_.face_of_plane(axis, is_upper), passing(axis, enters)));
    }
    for (std::uint32_t lane = 0; lane < lanes_.kept_count(); ++lane) choice.add(round(spans, lane, enters));
    first.is_flipped = false;
    return choice.outcome();
  }

  WalkOutcome end_of(const Spans& spans, std::uint32_t index, bool enters, const Interval<double>& end,
                     Boundary& first) const {
    const ConvexLanes::Lane& lane = lanes_[index];
    const LaneRows<Real>& rows = lanes_.template rows<Real>();
    Choice choice{end, first};
    if (lane.is_round) choice.add(round(spans, index, enters));
    const auto slab = [&](int axis, std::uint32_t lower, std::uint32_t upper) {
      const bool is_upper = (ray_.inverse()[axis] > 0) != enters;
      const auto i = static_cast<std::size_t>(axis);
      choice.add(crossing({lane.primitive, is_upper ? upper : lower},
                          ray_.passing(axis, (is_upper ? rows.hi : rows.lo)[i][index])));
    };
    if (lane.cap_axis >= 0) slab(lane.cap_axis, lane.goes_up ? 1 : 2, lane.goes_up ? 2 : 1);
    for (int axis = 0; axis < 3 && lane.is_box; ++axis) {
      slab(axis, static_cast<std::uint32_t>(2 * axis), static_cast<std::uint32_t>(2 * axis + 1));
    }
    first.is_flipped = true;
    return choice.outcome();
  }

  const ConvexLanes& lanes_;
  const QuickRay<level>& ray_;
  Probe& probe_;
};

}  // namespace sightline
