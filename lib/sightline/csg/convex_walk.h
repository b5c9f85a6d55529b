#pragma once
/// The first boundary of what convex primitives have in common, less others: without lists, where all is clear.

#include <array>
#include <cmath>

#include "sightline/accel/padded_ray.h"
#include "sightline/csg/quick_spans.h"
#include "sightline/csg/solid.h"

namespace sightline {

/// Walks along a ray: in at the last face of the common part, then, as long as that is within a part that is taken
/// away, on to where that ends.
///   W1  Every comparison is certain, or the walk gives up and leaves the ray to the evaluation by lists. So both find
///       the same.
template <Level level, class Probe>
class ConvexWalk {
 public:
  ConvexWalk(const Solid& solid, const ConvexParts& parts, const QuickRay<level>& ray, Probe& probe, OperandList& found)
      : solid_(solid), parts_(parts), ray_(ray), probe_(probe), found_(found) {}

  /// The first boundary with lo < t, as far as it is not surely beyond `hi`.
  WalkOutcome run(double lo, double hi, Boundary& first) {
    Place enter, leave;
    const WalkOutcome common = common_part(lo, hi, enter, leave);
    if (common != WalkOutcome::found) return common;
    const int is_ahead = order(enter, lo);
    if (is_ahead == 0) return WalkOutcome::unclear;
    is_flipped_ = false;
    at_ = is_ahead > 0 ? enter : Place{lo, 0, no_primitive, 0, 0};
    WalkOutcome rest = advance(leave);
    if (rest == WalkOutcome::found && at_.primitive == no_primitive) rest = way_out(leave);
    if (rest != WalkOutcome::found) return rest;
    if (at_.t - 3 * at_.radius > hi) return WalkOutcome::none;
    first = Boundary(at_.t, at_.radius, at_.primitive, at_.face, at_.root);
    first.is_flipped = is_flipped_;
    return WalkOutcome::found;
  }

 private:
  struct Place {
    double t, radius;
    std::uint32_t primitive, face, root;
  };
  using Kind = detail::QuickSpan::Kind;

  static Place place(std::uint32_t primitive, const detail::QuickSpan::End& end) {
    return {end.t, end.radius, primitive, end.face, end.root};
  }

  /// -1 or 1 as a is before or behind b, 0 where that is not clear.
  static int order(const Place& a, const Place& b) { return order(a.t - b.t, a.radius + b.radius); }
  static int order(const Place& a, double t) { return order(a.t - t, 3 * a.radius); }
  static int order(double difference, double known) {
    if (level == Level::fast) return (difference > 0) - (difference < 0);
    return std::fabs(difference) * (1 - 0x1p-40) > known ? (difference > 0 ? 1 : -1) : 0;
  }

  /// With the place where the walk is: a limit, as long as that is on no face.
  int order_here(const Place& a) const { return at_.primitive == no_primitive ? order(a, at_.t) : order(a, at_); }

  detail::QuickSpan span_of(std::uint32_t primitive) {
    probe_.primitive(primitive);
    return quick_span(solid_.primitives()[primitive], nullptr, ray_);
  }

  WalkOutcome common_part(double lo, double hi, Place& enter, Place& leave) {
    for (std::size_t i = 0; i < parts_.kept.size(); ++i) {
      const detail::QuickSpan span = span_of(parts_.kept[i]);
      if (span.kind == Kind::unclear) return WalkOutcome::unclear;
      if (span.kind == Kind::empty || order(place(0, span.leave), lo) < 0 || order(place(0, span.enter), hi) > 0)
        return WalkOutcome::none;
      const Place in = place(parts_.kept[i], span.enter), out = place(parts_.kept[i], span.leave);
      const int later = i == 0 ? 1 : order(in, enter), earlier = i == 0 ? -1 : order(out, leave);
      if (later == 0 || earlier == 0) return WalkOutcome::unclear;
      if (later > 0) enter = in;
      if (earlier < 0) leave = out;
    }
    const int way = order(enter, leave);
    if (way == 0 || order(leave, lo) == 0) return WalkOutcome::unclear;
    return way < 0 ? WalkOutcome::found : WalkOutcome::none;
  }

  struct Point {
    Vec3d position;
    double pad;  ///< W2  More than the position is off by, and than the spans of what it is in may be.
  };

  Point point_at(double t) const {
    const Ray<double>& ray = ray_.ray();
    using Real = typename QuickRay<level>::Real;
    return {ray.at(t), double(margin<Real>) * (max_norm(ray.origin) + std::fabs(t) * max_norm(ray.direction))};
  }

  /// Whether the box of two points meets another.
  static bool may_meet(const Aabb& bounds, const Point& a, const Point& b) {
    const double pad = a.pad > b.pad ? a.pad : b.pad;
    const Vec3d lo = glm::min(a.position, b.position) - pad, hi = glm::max(a.position, b.position) + pad;
    return (lo.x <= bounds.hi.x) & (lo.y <= bounds.hi.y) & (lo.z <= bounds.hi.z) & (hi.x >= bounds.lo.x) &
           (hi.y >= bounds.lo.y) & (hi.z >= bounds.lo.z);
  }

  /// Calls see(primitive) for the parts taken away that may have anything in a window, until it returns false.
  template <class See>
  bool for_each_taken(double lo, double hi, See&& see) {
    if (!parts_.index) {
      const Point from = point_at(lo), to = point_at(hi);
      for (const ConvexParts::Taken& taken : parts_.taken) {
        if (may_meet(taken.bounds, from, to) && !see(taken.primitive)) return false;
      }
      return true;
    }
    found_.truncate(0);
    Ray<double> part = ray_.ray();
    part.t_min = lo, part.t_max = hi;
    parts_.index->find(part, found_);
    for (const std::uint32_t i : found_) {
      if (!see(parts_.taken[i].primitive)) return false;
    }
    return true;
  }

  /// Moves on until no part that is taken away holds the place. None where that is behind `leave`.
  WalkOutcome advance(const Place& leave) {
    for (bool is_moved = true; is_moved;) {
      is_moved = false;
      const bool is_clear = for_each_taken(at_.t - at_.radius, at_.t + at_.radius, [&](std::uint32_t primitive) {
        if (primitive == at_.primitive) return true;
        const detail::QuickSpan span = span_of(primitive);
        if (span.kind != Kind::span) return span.kind == Kind::empty;
        const Place out = place(primitive, span.leave);
        const int begins = order_here(place(primitive, span.enter)), ends = order_here(out);
        if (begins > 0 || ends < 0) return true;
        if (begins == 0 || ends == 0) return false;
        at_ = out;
        return is_flipped_ = is_moved = true;
      });
      if (!is_clear) return WalkOutcome::unclear;
      if (is_moved) {
        const int ends = order(at_, leave);
        if (ends >= 0) return ends == 0 ? WalkOutcome::unclear : WalkOutcome::none;
      }
    }
    return WalkOutcome::found;
  }

  /// From inside of the solid, the nearest way out.
  WalkOutcome way_out(const Place& leave) {
    const double lo = at_.t;
    at_ = leave;
    const bool is_clear = for_each_taken(lo, leave.t + leave.radius, [&](std::uint32_t primitive) {
      const detail::QuickSpan span = span_of(primitive);
      if (span.kind != Kind::span) return span.kind == Kind::empty;
      const Place in = place(primitive, span.enter);
      const int begins = order(in, lo), earlier = order(in, at_);
      if (begins < 0 || earlier > 0) return true;  // it ends before lo, or it would hold that
      if (begins == 0 || earlier == 0) return false;
      at_ = in;
      return is_flipped_ = true;
    });
    return is_clear ? WalkOutcome::found : WalkOutcome::unclear;
  }

  const Solid& solid_;
  const ConvexParts& parts_;
  const QuickRay<level>& ray_;
  Probe& probe_;
  OperandList& found_;
  Place at_;
  bool is_flipped_ = false;
};

}  // namespace sightline
