#pragma once
/// Where to cut a row of boxes in two by the surface area heuristic.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "sightline/accel/bounds_reference.h"
#include "sightline/accel/options.h"

namespace sightline {

/// What the heuristic weighs. All costs are relative to each other.
struct ObjectSplitCosts {
  double inner_node;  ///< Opening an inner node.
  double primitive;   ///< One primitive test.
  int max_leaf_size;
  int bins;
  /// `fast` weighs cuts along one axis, and takes every set for a leaf that may be one.
  Quality quality = Quality::balanced;

  bool is_leaf_at_once(std::uint32_t count) const {
    return quality == Quality::fast && count <= static_cast<std::uint32_t>(max_leaf_size);
  }
};

/// The area of a box, as ScaledArea asks for it.
struct HalfArea {
  float operator()(float x, float y, float z) const { return x * y + y * z + z * x; }
};

/// Areas of bounding volumes in float, in units in which the largest extent of what is divided is 1, so that none
/// overflows. `Area` tells, up to a constant factor, the surface area of the volume that circumscribes a box of an
/// extent: area(x, y, z), of floats.
template <class Area>
class ScaledArea {
 public:
  explicit ScaledArea(const Aabb& whole) {
    const float extent = max_norm(whole.extent());
    scale_ = extent > 0 ? std::min(1 / extent, std::numeric_limits<float>::max()) : 0;
    whole_ = of(whole.extent());
  }

  float of(const Vec3f& extent) const { return Area()(scale_ * extent.x, scale_ * extent.y, scale_ * extent.z); }
  float whole() const { return whole_; }
  float scale() const { return scale_; }

 private:
  float scale_, whole_;
};

/// Where a row of boxes is cut: area times count, of both parts. Equal costs (points, lines, copies) go to the more
/// balanced parts.
struct ObjectCut {
  float cost = std::numeric_limits<float>::max();
  float imbalance = std::numeric_limits<float>::infinity();
  int axis = 0;
  int place = 0;  ///< The first box of the second part; 0 where there is no way to cut.

  void improve(const ObjectCut& other) {
    if (other.cost < cost || (other.cost == cost && other.imbalance < imbalance)) *this = other;
  }
  template <class Area>
  bool is_worse_than_leaf(std::uint32_t count, const ObjectSplitCosts& costs, const ScaledArea<Area>& area) const {
    if (count > static_cast<std::uint32_t>(costs.max_leaf_size)) return false;
    return costs.primitive * area.whole() * count <= costs.inner_node * area.whole() + costs.primitive * cost;
  }
};

/// At most `Most` boxes and their areas.
template <class Area, std::size_t Most>
class MeasuredBoxes {
 public:
  static constexpr std::size_t size = Most + 4;

  GrowingBox& operator[](std::size_t i) { return boxes_[i]; }

  /// From boxes to extents, four at once.
  void measure(int end, float scale) {
    constexpr hn::CappedTag<float, 4> d{};
    const auto factor = hn::Set(d, -scale);
    alignas(16) std::array<float, 16> extents;
    for (int first = 0; first < end; first += 4) {
      for (int i = 0; i < 4; ++i) {
        const float* lows = boxes_[static_cast<std::size_t>(first + i)].lows();
        for (std::size_t lane = 0; lane < 4; lane += hn::Lanes(d)) {
          const auto sum = hn::Add(hn::LoadU(d, lows + lane), hn::LoadU(d, lows + 3 + lane));
          hn::Store(hn::Mul(sum, factor), d, extents.data() + 4 * i + lane);
        }
      }
      for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
        auto along_x = hn::Zero(d), along_y = along_x, along_z = along_x, unused = along_x;
        hn::LoadInterleaved4(d, extents.data() + 4 * i, along_x, along_y, along_z, unused);
        hn::StoreU(along_x, d, x_.data() + first + i);
        hn::StoreU(along_y, d, y_.data() + first + i);
        hn::StoreU(along_z, d, z_.data() + first + i);
      }
    }
  }
  /// Of a measured box.
  float area(std::size_t i) const { return Area()(x_[i], y_[i], z_[i]); }

 private:
  std::array<GrowingBox, size> boxes_;
  std::array<float, size> x_, y_, z_;
};

/// Weighs all ways to cut a row of at most `Most` boxes.
template <class Area, std::size_t Most>
class RowCutter {
 public:
  /// `box(i)` is box i of the row, `count_of(i)` how many references are in it. Improves `best`.
  template <class Box, class Count>
  void cut(int size, Box&& box, Count&& count_of, const ScaledArea<Area>& area, int axis, ObjectCut& best) {
    GrowingBox grown = GrowingBox::empty();
    std::uint32_t total = 0;
    for (int place = 1; place < size; ++place) {
      grown.extend(box(place - 1));
      total += count_of(place - 1);
      below_.boxes[place] = grown;
      below_.counts[place] = static_cast<float>(total);
    }
    total += count_of(size - 1);
    grown = GrowingBox::empty();
    for (int place = size - 1; place > 0; --place) {
      grown.extend(box(place));
      above_.boxes[place] = grown;
    }
    below_.boxes[0] = above_.boxes[0] = grown;
    below_.counts[0] = 0;
    const auto all = static_cast<float>(total);
    for (int place = 0; place < size; ++place) above_.counts[place] = all - below_.counts[place];
    below_.boxes.measure(size, area.scale());
    above_.boxes.measure(size, area.scale());

    for (int place = 0; place < size; ++place) {
      const float cost = below_.cost(place) + above_.cost(place);
      costs_[place] = below_.counts[place] * above_.counts[place] > 0 ? cost : std::numeric_limits<float>::infinity();
    }
    for (int place = 1; place < size; ++place) {
      if (!(costs_[place] <= best.cost)) continue;
      const float imbalance = std::fabs(below_.counts[place] - above_.counts[place]);
      if (costs_[place] == best.cost && !(imbalance < best.imbalance)) continue;
      best = {costs_[place], imbalance, axis, place};
    }
  }

 private:
  /// The parts on one side of each place.
  struct Side {
    MeasuredBoxes<Area, Most> boxes;
    std::array<float, Most> counts;  ///< Rounded above 2^24.

    float cost(int place) const {
      const auto i = static_cast<std::size_t>(place);
      return boxes.area(i) * counts[i];
    }
  };

  Side below_, above_;
  std::array<float, Most> costs_;
};

}  // namespace sightline
