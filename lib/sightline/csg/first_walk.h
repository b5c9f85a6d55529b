#pragma once
/// The first boundary without lists, where a walk along convex parts is clear.

#include <cmath>
#include <limits>

#include "sightline/csg/convex_walk.h"
#include "sightline/csg/lane_walk.h"
#include "sightline/csg/refined_root.h"
#include "sightline/csg/solid_probe.h"
#include "sightline/csg/solid_ray.h"
#include "sightline/math/rounding.h"

namespace sightline {

/// What is reported: as accurate as the level asks for.
template <Level level>
Boundary refined_boundary(const Solid& solid, const Boundary& boundary, const QuickRay<level>& ray) {
  if (is_accurate(boundary.t, boundary.radius, level)) [[likely]]
    return boundary;
  const Primitive& primitive = solid.primitives()[boundary.primitive];
  const Root root = refined_root(primitive, boundary.face, boundary.root, boundary.t, ray, solid.frame_of(primitive));
  Boundary refined = boundary;
  refined.t = root.t, refined.radius = root.radius;
  return refined;
}

/// More than reported boundaries of one true t may be apart: what is no farther beyond a limit is not left out.
template <Level level>
double limit_slack(double t) {
  return (level == Level::fast ? 0x1p-16 : 0x1p-44) * std::fabs(t);
}

/// No t beyond it becomes `far`, or less, when it is rounded to the precision of that.
inline double last_rounded_to(float far) { return next_up(far); }
inline double last_rounded_to(double far) { return far; }

/// Whether the boundary would be reported behind t.
template <Level level>
bool is_behind(const Solid& solid, const Boundary& boundary, double t, const QuickRay<level>& ray) {
  // The reported one is no farther from the true one than this one is.
  if (std::fabs(boundary.t - t) > 3 * boundary.radius) [[likely]]
    return boundary.t > t;
  return refined_boundary(solid, boundary, ray).t > t;
}

namespace detail {

template <Level level, class Probe>
[[gnu::noinline]] WalkOutcome walk_by_scalars(const Solid& solid, const ConvexParts& parts, const QuickRay<level>& ray,
                                              double t_min, double t_max, Probe& probe, Boundary& first) {
  OperandList found;
  return ConvexWalk<level, Probe>(solid, parts, ray, probe, found).run(t_min, t_max, first);
}

/// The first boundary with t_min < t, as far as it is not clearly beyond t_max; not refined.
template <Level level, class Probe>
[[gnu::always_inline]] inline WalkOutcome walk(const Solid& solid, const QuickRay<level>& ray, double t_min,
                                               double t_max, Probe& probe, Boundary& first) {
  const ConvexParts* parts = solid.convex_parts();
  t_max += limit_slack<level>(t_max);
  if (Probe::sees_transitions || !parts) return WalkOutcome::unclear;
  if (!ray.is_valid()) return WalkOutcome::none;
  if constexpr (has_lane_roots<level>) {
    if (parts->lanes && !ray.has_zero())
      return LaneWalk<level, Probe>(*parts->lanes, ray, probe).run(t_min, t_max, first);
  }
  return walk_by_scalars(solid, *parts, ray, t_min, t_max, probe, first);
}

}  // namespace detail

/// The first boundary with t_min < t <= t_max.
template <Level level, class Probe>
WalkOutcome walk_first(const Solid& solid, const SolidRay<level>& ray, double t_min, double t_max, Probe& probe,
                       Boundary& first) {
  const WalkOutcome outcome = detail::walk(solid, ray.quick(), t_min, t_max, probe, first);
  if (outcome != WalkOutcome::found) return outcome;
  if (is_behind(solid, first, t_max, ray.quick())) return WalkOutcome::none;
  first = refined_boundary(solid, first, ray.quick());
  return WalkOutcome::found;
}

/// Whether there is one, as a number of type T: found surely, without knowing well where.
template <class T, Level level, class Probe>
WalkOutcome walk_any(const Solid& solid, const SolidRay<level>& ray, T t_min, T t_max, Probe& probe) {
  Boundary first;
  const WalkOutcome outcome =
      detail::walk(solid, ray.quick(), static_cast<double>(t_min), last_rounded_to(t_max), probe, first);
  if (outcome != WalkOutcome::found) return outcome;
  // What is reported is no farther from the true one than this one is, and rounding keeps the order.
  const double known = 3 * first.radius;
  const T least = static_cast<T>(first.t - known), most = static_cast<T>(first.t + known);
  const bool is_sure = least > t_min && most <= t_max && most < std::numeric_limits<T>::infinity();
  return is_sure ? WalkOutcome::found : WalkOutcome::unclear;
}

}  // namespace sightline
