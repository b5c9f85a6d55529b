#pragma once
/// Roots of a round face as accurate as level watertight asks for, a ray in each lane.

#include "sightline/csg/convex_lanes.h"
#include "sightline/csg/solid_packet.h"

namespace sightline {

/// One step of Newton's: refine_round of refined_root.h (N1, N2), by the same operations in the same order, so that the
/// bits are the same.
class LaneRefinement {
 public:
  using D = hn::CappedTag<double, SolidPacket<Level::watertight>::size>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  V t, radius;
  M is_lower, is_upper;  ///< Whether that is now surely the lower root, or the upper one, and accurate.

  /// Of the face in `lane`, for rays from `first` on, with roots near `near`.
  LaneRefinement(const ConvexLanes& lanes, std::uint32_t lane, const SolidPacket<Level::watertight>& rays,
                 std::size_t first, V near) {
    const LaneRows<double>& rows = lanes.rows<double>();
    const V zero = hn::Zero(d), slack = set(1 + 0x1p-40), least = set(SizedDouble::step);
    V squares = zero, slope = zero, speed = zero, error_c = zero, error_b = zero;
    for (std::size_t i = 0; i < 3; ++i) {
      if (rows.weight[i][lane] == 0) continue;  // a cylinder's own axis
      const auto axis = static_cast<int>(i);
      const V direction = hn::Load(d, rays.direction(axis) + first), way = hn::Mul(near, direction);
      const V at = hn::Add(hn::Load(d, rays.origin(axis) + first), way);
      const V p = hn::Sub(at, set(rows.center[i][lane])), size = hn::Abs(p);
      const V error = hn::Mul(hn::Add(hn::Add(hn::Abs(way), hn::Abs(at)), size), set(unit));
      squares = hn::Add(squares, hn::Mul(p, p)), slope = hn::Add(slope, hn::Mul(p, direction));
      speed = hn::Add(speed, hn::Mul(direction, direction));
      error_c = hn::Add(error_c, hn::Mul(error, hn::Add(hn::Add(size, size), error)));
      error_b = hn::Add(error_b, hn::Mul(hn::Abs(direction), hn::Add(error, hn::Mul(size, set(4 * unit)))));
    }
    const V square = set(rows.radius_square[lane]), c = hn::Sub(squares, square), least_slope = set(0x1p-21);
    error_c = hn::Add(hn::Mul(hn::Add(error_c, hn::Mul(hn::Add(squares, square), set(6 * unit))), slack), least);
    const M is_flat = hn::Le(hn::Mul(speed, hn::Abs(c)), hn::Mul(least_slope, hn::Mul(slope, slope)));
    const M is_steep = hn::Le(hn::Add(error_b, least), hn::Mul(least_slope, hn::Abs(slope)));
    const V half = hn::Div(set(0.5), slope), offset = hn::Mul(hn::Neg(c), half);
    t = hn::Add(near, offset);
    radius = hn::Add(
        hn::Add(hn::Mul(hn::Mul(error_c, hn::Abs(half)), set(1 + 0x1p-18)), hn::Mul(hn::Abs(offset), set(0x1p-18))),
        hn::Mul(hn::Abs(t), set(unit)));
    radius = hn::Mul(radius, slack);
    const M is_near = hn::Le(hn::Abs(near), set(SizedDouble::largest));
    const M is_accurate = hn::Le(radius, hn::Mul(set(0x1p-46), hn::Abs(t)));
    const M is_sure = hn::And(hn::And(is_near, is_accurate), hn::And(is_flat, is_steep));
    is_upper = hn::And(is_sure, hn::Gt(slope, zero));
    is_lower = hn::AndNot(hn::Gt(slope, zero), is_sure);
  }

 private:
  static constexpr D d{};
  static constexpr double unit = 0x1p-53;
  static V set(double x) { return hn::Set(d, x); }
};

}  // namespace sightline
