#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

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
  PolygonOverlap(const Hull& polygon, const Vec3d& lo, const Vec3d& size, double margin) {
    const int count = polygon.points.size();
    const Vec3d per_margin = Vec3d(1 / margin);
    std::array<Vec3f, 8> points;  // relative to `lo`; lengths are in units of the margin
    float reach = 0;
    for (int i = 0; i < count; ++i) {
      points[i] = Vec3f((Vec3d(polygon.points[i]) - lo) * per_margin);
      reach = std::max({reach, std::fabs(points[i].x), std::fabs(points[i].y), std::fabs(points[i].z)});
    }
    set(0, glm::cross(points[1] - points[0], points[count - 1] - points[0]));
    for (int i = 0; i < count; ++i) {
      const Vec3f edge = points[i + 1 == count ? 0 : i + 1] - points[i];
      set(1 + i, {0, -edge.z, edge.y});
      set(1 + count + i, {edge.z, 0, -edge.x});
      set(1 + 2 * count + i, {-edge.y, edge.x, 0});
    }
    edges_ = count;
    place({points.data(), static_cast<std::size_t>(count)}, Vec3f(size * per_margin), reach);
  }

  /// Bit x + 4 y + 16 z is set where the polygon meets the box of that place. What the edges separate does not depend
  /// on the place along the axis that they were crossed with.
  std::uint64_t boxes_met() const {
    const std::uint64_t y_and_z = faces_met(1, y_, z_), x_and_z = faces_met(1 + edges_, x_, z_),
                        x_and_y = faces_met(1 + 2 * edges_, x_, y_);
    std::uint64_t rows = 0, columns = 0;
    for (int z = 0; z < 4; ++z) {
      columns |= (x_and_z >> 4 * z & 0xf) * 0x1111 << 16 * z;
      rows |= row_bits(y_and_z >> 4 * z & 0xf) << 16 * z;
    }
    return planes_met() & rows & columns & x_and_y * 0x0001'0001'0001'0001;
  }

 private:
  static constexpr std::size_t lanes = 16, most_axes = 32;
  static constexpr hn::CappedTag<float, lanes> d{};
  alignas(64) static constexpr float places[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
  alignas(64) static constexpr float rows_of_places[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

  /// Four bits, each four times.
  static std::uint64_t row_bits(std::uint64_t bits) {
    return ((bits & 1) | (bits & 2) << 3 | (bits & 4) << 6 | (bits & 8) << 9) * 0xf;
  }

  /// Bit i + 4 j is set where no edge's axis from `first` on separates the boxes that have place i along the first axis
  /// of space, and j along the second.
  std::uint64_t faces_met(int first, const float* steps_i, const float* steps_j) const {
    std::uint64_t bits = 0;
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(d)) {
      const auto i = hn::Load(d, places + lane), j = hn::Load(d, rows_of_places + lane);
      auto worst = hn::Zero(d);
      for (int axis = first; axis < first + edges_; ++axis) {
        const auto at = hn::MulAdd(i, hn::Set(d, steps_i[axis]),
                                   hn::MulAdd(j, hn::Set(d, steps_j[axis]), hn::Set(d, start_[axis])));
        worst = hn::Max(worst, hn::Sub(hn::Abs(at), hn::Set(d, limit_[axis])));
      }
      bits |= met_bits(worst) << lane;
    }
    return bits;
  }

  /// Where the polygon's normal does not separate the boxes.
  std::uint64_t planes_met() const {
    std::uint64_t bits = 0;
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(d)) {
      const auto x = hn::Load(d, places + lane), y = hn::Load(d, rows_of_places + lane);
      const auto step = hn::Set(d, z_[0]), limit = hn::Set(d, limit_[0]);
      auto at = hn::MulAdd(x, hn::Set(d, x_[0]), hn::MulAdd(y, hn::Set(d, y_[0]), hn::Set(d, start_[0])));
      for (int z = 0; z < 4; ++z) {
        bits |= met_bits(hn::Max(hn::Sub(hn::Abs(at), limit), hn::Zero(d))) << (16 * z + static_cast<int>(lane));
        at = hn::Add(at, step);
      }
    }
    return bits;
  }

  template <class V>
  static std::uint64_t met_bits(V worst) {
    return bits_of(hn::Eq(worst, hn::Zero(d)));
  }

  void set(int axis, const Vec3f& normal) { x_[axis] = normal.x, y_[axis] = normal.y, z_[axis] = normal.z; }

  /// From the normals of the axes to the places of the boxes on them, several axes at once.
  void place(std::span<const Vec3f> points, const Vec3f& size, float reach) {
    const auto size_x = hn::Set(d, size.x), size_y = hn::Set(d, size.y), size_z = hn::Set(d, size.z);
    const auto half = hn::Set(d, 0.5f), margin = hn::Set(d, 1);
    // Twelve roundings at most, none of more than 2^-24 times the largest number that they meet; twice that.
    const auto slack = hn::Set(d, 0x1p-19f * (reach + 4 * std::max({size.x, size.y, size.z})));
    for (std::size_t first = 0; first < static_cast<std::size_t>(1 + 3 * edges_); first += hn::Lanes(d)) {
      const auto x = hn::Load(d, x_ + first), y = hn::Load(d, y_ + first), z = hn::Load(d, z_ + first);
      const auto along = [&](const Vec3f& p) {
        return hn::MulAdd(x, hn::Set(d, p.x), hn::MulAdd(y, hn::Set(d, p.y), hn::Mul(z, hn::Set(d, p.z))));
      };
      auto lowest = along(points[0]), highest = lowest;
      for (const Vec3f& p : points.subspan(1)) {
        const auto at = along(p);
        lowest = hn::Min(lowest, at);
        highest = hn::Max(highest, at);
      }
      const auto step_x = hn::Mul(x, size_x), step_y = hn::Mul(y, size_y), step_z = hn::Mul(z, size_z);
      const auto steps = hn::Add(step_x, hn::Add(step_y, step_z));
      const auto widths = hn::Add(hn::Abs(step_x), hn::Add(hn::Abs(step_y), hn::Abs(step_z)));
      const auto normals = hn::Add(hn::Abs(x), hn::Add(hn::Abs(y), hn::Abs(z)));
      const auto reached = hn::Mul(half, hn::Add(hn::Sub(highest, lowest), widths));
      hn::Store(step_x, d, x_ + first);
      hn::Store(step_y, d, y_ + first);
      hn::Store(step_z, d, z_ + first);
      hn::Store(hn::Mul(half, hn::Sub(steps, hn::Add(lowest, highest))), d, start_ + first);
      hn::Store(hn::MulAdd(normals, hn::Add(margin, slack), reached), d, limit_ + first);
    }
  }

  template <class M>
  static std::uint64_t bits_of(M mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0] | std::uint64_t(bytes[1]) << 8;
  }

  int edges_;  ///< Axis 0 is the normal; then come the edges crossed with x, with y and with z.
  // Normals of the axes and then, on each, the steps between boxes, the first box's center relative to the polygon's
  // middle, and how far from that boxes are met.
  alignas(64) float x_[most_axes]{}, y_[most_axes]{}, z_[most_axes]{}, start_[most_axes], limit_[most_axes];
};

}  // namespace sightline
