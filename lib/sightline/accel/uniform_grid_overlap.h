#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "sightline/math/hull.h"
#include "sightline/math/simd.h"

namespace sightline {

/// Which of 4 x 4 x 4 equal boxes a convex polygon meets, all tested at once.
///   O1  A box is left out only if some axis separates it from the polygon, so no box that the polygon meets is.
///   O2  None that it is clear of is kept, but for rounding: the faces' normals, the polygon's normal and the cross
///       products of its edges with the faces' normals are all the axes that could separate them.
/// Gottschalk, Lin and Manocha, "OBBTree: a hierarchical structure for rapid interference detection", 1996.
class PolygonOverlap {
 public:
  static constexpr int side = 4;

  /// Points relative to `center`. Boxes are enlarged on every side by `margin`, which must exceed 2^-45 times the
  /// coordinates.
  PolygonOverlap(const Hull& polygon, const Vec3d& center, double margin) : margin_(margin) {
    for (const Vec3f& p : polygon.points) points_.push_back(Vec3d(p) - center);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d normal(0);
      normal[axis] = 1;
      add(normal);
    }
    const int count = points_.size();
    add(glm::cross(points_[1] - points_[0], points_[count - 1] - points_[0]));
    for (int i = 0; i < count; ++i) {
      const Vec3d edge = points_[i + 1 == count ? 0 : i + 1] - points_[i];
      add({0, -edge.z, edge.y});
      add({edge.z, 0, -edge.x});
      add({-edge.y, edge.x, 0});
    }
  }

  /// Bit x + 4 y + 16 z is set where the polygon meets the box of that place; the first has the corner `lo`.
  std::uint64_t boxes_met(const Vec3d& lo, const Vec3d& size) const {
    std::uint64_t met = ~std::uint64_t(0);
    const Vec3d first = lo + 0.5 * size;
    for (const Axis& axis : axes_) {
      // In units of what a box and its margin reach on this axis, centers farther than 1 from the polygon are apart.
      const Vec3d extent = glm::abs(axis.normal) * (0.5 * size + margin_);
      const double unit = 1 / (axis.half + (extent.x + extent.y + extent.z));
      const Vec3d step = axis.normal * size * unit;
      const double start = (glm::dot(axis.normal, first) - axis.middle) * unit;
      met &= within(start, step);
    }
    return met;
  }

 private:
  struct Axis {
    Vec3d normal;
    double middle, half;  ///< Where the polygon lies on it.
  };

  void add(const Vec3d& normal) {
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    for (const Vec3d& p : points_) {
      const double at = glm::dot(normal, p);
      lo = std::min(lo, at);
      hi = std::max(hi, at);
    }
    // An edge or a polygon without extent has no normal; so has one whose numbers underflow.
    if (max_norm(normal) > 0x1p-900) axes_.push_back({normal, 0.5 * (lo + hi), 0.5 * (hi - lo)});
  }

  /// Bits of the places (x, y, z) with |start + x step.x + y step.y + z step.z| at most 1, and of some where rounding
  /// to float leaves that open: five roundings, each of at most 2^-24 of the sum of the sizes.
  static std::uint64_t within(double start, const Vec3d& step) {
    alignas(64) static constexpr float columns[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    alignas(64) static constexpr float rows[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    const hn::CappedTag<float, 16> d;
    const Vec3d sizes = 3.0 * glm::abs(step);
    const auto limit = hn::Set(d, static_cast<float>(1 + 0x1p-20 * (1 + std::fabs(start) + sizes.x + sizes.y + sizes.z)));
    const auto x = hn::Set(d, static_cast<float>(step.x)), y = hn::Set(d, static_cast<float>(step.y)),
               z = hn::Set(d, static_cast<float>(step.z));
    std::uint64_t bits = 0;
    for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(d)) {
      auto value = hn::MulAdd(x, hn::Load(d, columns + lane),
                              hn::MulAdd(y, hn::Load(d, rows + lane), hn::Set(d, static_cast<float>(start))));
      for (std::size_t layer = 0; layer < 4; ++layer) {
        bits |= bits_of(d, hn::Not(hn::Gt(hn::Abs(value), limit))) << (16 * layer + lane);
        value = hn::Add(value, z);
      }
    }
    return bits;
  }

  template <class D, class M>
  static std::uint64_t bits_of(D d, M mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0] | std::uint64_t(bytes[1]) << 8;
  }

  double margin_;
  SmallList<Vec3d, 8> points_;
  SmallList<Axis, 28> axes_;
};

}  // namespace sightline
