#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "sightline/math/hull.h"
#include "sightline/math/simd.h"

namespace sightline {

/// Which of 4 x 4 x 4 equal boxes a convex polygon meets, all tested at once, in float.
///   O1  A box is left out only if an axis separates it from the polygon. Whatever axis that is, rounded or not, the
///       polygon's interval on it is computed from all its points.
///   O2  Of the boxes that meet the polygon's bounds none that it is clear of is kept, but for rounding: those bounds,
///       the polygon's normal and the cross products of its edges with the axes are all that could separate them.
/// Gottschalk, Lin and Manocha, "OBBTree: a hierarchical structure for rapid interference detection", 1996.
class PolygonOverlap {
 public:
  /// The first box has the corner `lo`; boxes are enlarged by `margin` (above 0) on every side.
  PolygonOverlap(const Hull& polygon, const Vec3d& lo, const Vec3d& size, double margin)
      : count_(polygon.points.size()), size_(size / margin), half_(0.5f * size_ + 1.0f) {
    for (int i = 0; i < count_; ++i) {
      points_[i] = Vec3f((Vec3d(polygon.points[i]) - lo) / margin);
      reach_ = std::max(reach_, max_norm(points_[i]));
    }
    reach_ += 4 * max_norm(size_);
    add(glm::cross(points_[1] - points_[0], points_[count_ - 1] - points_[0]));
    for (int i = 0; i < count_; ++i) {
      const Vec3f edge = points_[i + 1 == count_ ? 0 : i + 1] - points_[i];
      add({0, -edge.z, edge.y});
      add({edge.z, 0, -edge.x});
      add({-edge.y, edge.x, 0});
    }
  }

  /// Bit x + 4 y + 16 z is set where the polygon meets the box of that place.
  std::uint64_t boxes_met() const {
    alignas(64) static constexpr float columns[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    alignas(64) static constexpr float rows[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    const hn::CappedTag<float, 16> d;
    std::uint64_t bits = 0;
    for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(d)) {
      const auto x = hn::Load(d, columns + lane), y = hn::Load(d, rows + lane);
      auto worst0 = hn::Zero(d), worst1 = worst0, worst2 = worst0, worst3 = worst0;
      for (int i = 0; i < axis_count_; ++i) {
        const Axis& axis = axes_[i];
        const auto step = hn::Set(d, axis.step.z), limit = hn::Set(d, axis.limit);
        const auto at0 =
            hn::MulAdd(x, hn::Set(d, axis.step.x), hn::MulAdd(y, hn::Set(d, axis.step.y), hn::Set(d, axis.start)));
        const auto at1 = hn::Add(at0, step), at2 = hn::Add(at1, step), at3 = hn::Add(at2, step);
        worst0 = hn::Max(worst0, hn::Sub(hn::Abs(at0), limit));
        worst1 = hn::Max(worst1, hn::Sub(hn::Abs(at1), limit));
        worst2 = hn::Max(worst2, hn::Sub(hn::Abs(at2), limit));
        worst3 = hn::Max(worst3, hn::Sub(hn::Abs(at3), limit));
      }
      const auto is_met = [&](auto worst) { return hn::Eq(worst, hn::Zero(d)); };
      bits |= bits_of(d, is_met(worst0)) << lane | bits_of(d, is_met(worst1)) << (lane + 16) |
              bits_of(d, is_met(worst2)) << (lane + 32) | bits_of(d, is_met(worst3)) << (lane + 48);
    }
    return bits;
  }

 private:
  /// Centers of boxes are start + x step.x + y step.y + z step.z from the polygon's middle on this axis, and apart from
  /// it beyond the limit.
  struct Axis {
    Vec3f step;
    float start, limit;
  };

  void add(const Vec3f& normal) {
    float lo = glm::dot(normal, points_[0]), hi = lo;
    for (int i = 1; i < count_; ++i) {
      const float at = glm::dot(normal, points_[i]);
      lo = std::min(lo, at);
      hi = std::max(hi, at);
    }
    const Vec3f width = glm::abs(normal), step = normal * size_;
    // Twelve roundings at most, none of more than 2^-24 times the largest number that they meet; twice that.
    const float slack = 0x1p-19f * (width.x + width.y + width.z) * reach_;
    const float start = 0.5f * (step.x + step.y + step.z) - 0.5f * (lo + hi);
    axes_[axis_count_++] = {step, start, 0.5f * (hi - lo) + glm::dot(width, half_) + slack};
  }

  template <class D, class M>
  static std::uint64_t bits_of(D d, M mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0] | std::uint64_t(bytes[1]) << 8;
  }

  std::array<Vec3f, 8> points_;  ///< Relative to `lo`; lengths are in units of the margin.
  int count_;
  Vec3f size_, half_;
  float reach_ = 0;  ///< Above all coordinates.
  std::array<Axis, 25> axes_;
  int axis_count_ = 0;
};

}  // namespace sightline
