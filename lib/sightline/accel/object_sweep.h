#pragma once
/// Dividing few references in two, again and again, by the surface area heuristic.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>

#include "sightline/accel/bounds_reference.h"
#include "sightline/accel/object_cut.h"

namespace sightline {

/// Binning sees few of the ways to divide a small set; trying all costs little there. The set is sorted along each axis
/// once, and its parts inherit the order.
///   S3  The references of a part stand at the same positions of all three orders.
template <class Area>
class ObjectSweep {
 public:
  static constexpr std::uint32_t most = 32;  ///< References.

  struct Part {
    std::uint32_t begin, end;  ///< Positions in the orders.
    Aabb bounds;
    const ObjectSweep* sweep;

    std::uint32_t count() const { return end - begin; }
    const Aabb& box() const { return bounds; }
    std::uint32_t id(std::uint32_t i) const { return sweep->ids_[sweep->order_[0][begin + i]]; }
  };
  struct Halves {
    Part below, above;
  };

  ObjectSweep(std::span<const BoundsReference> items, const ObjectSplitCosts& costs)
      : costs_(costs), count_(static_cast<std::uint32_t>(items.size())) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      boxes_[i] = GrowingBox::empty();
      boxes_[i].extend(items[i]);
      ids_[i] = items[i].id;
    }
    for (int axis = 0; axis < 3; ++axis) sort(items, axis);
  }

  Part whole() const { return part(0, count_); }

  /// None for a leaf.
  std::optional<Halves> cheapest(const Part& from) {
    const std::uint32_t count = from.count();
    if (count < 2) return {};
    if (count == 2 && costs_.max_leaf_size == 1) return cut(from, 0, 1);
    const ScaledArea<Area> area(from.bounds);
    ObjectCut best;
    for (int axis = 0; axis < 3; ++axis) {
      cutter_.cut(
          static_cast<int>(count),
          [&](int i) -> const GrowingBox& { return boxes_[order_[axis][from.begin + static_cast<std::uint32_t>(i)]]; },
          [](int) { return 1u; }, area, axis, best);
    }
    if (best.place == 0) return median(from);
    if (best.is_worse_than_leaf(count, costs_, area)) return {};
    return cut(from, best.axis, static_cast<std::uint32_t>(best.place));
  }

  /// Halves the references in the order along the longest axis of their bounds; none for a leaf.
  std::optional<Halves> median(const Part& from) {
    if (from.count() <= static_cast<std::uint32_t>(costs_.max_leaf_size)) return {};
    return cut(from, from.bounds.longest_axis(), from.count() / 2);
  }

 private:
  using Order = std::array<std::uint8_t, most>;

  Part part(std::uint32_t begin, std::uint32_t end) const {
    GrowingBox box = GrowingBox::empty();
    for (std::uint32_t i = begin; i < end; ++i) box.extend(boxes_[order_[0][i]]);
    return {begin, end, box.box(), this};
  }

  /// By center, then by position. A reference's rank is the number of those before it.
  void sort(std::span<const BoundsReference> items, int axis) {
    alignas(64) std::array<std::int32_t, most> keys, ranks{};
    keys.fill(std::numeric_limits<std::int32_t>::max());
    for (std::uint32_t i = 0; i < count_; ++i) keys[i] = sort_key(ReferenceCenter::on(items[i], axis));
    for (std::int32_t other = 0; other < static_cast<std::int32_t>(count_); ++other) {
      const std::int32_t key = keys[other];
      for (std::int32_t i = 0; i < static_cast<std::int32_t>(most); ++i) ranks[i] += key - (other < i) < keys[i];
    }
    for (std::uint32_t i = 0; i < count_; ++i) order_[axis][ranks[i]] = static_cast<std::uint8_t>(i);
  }

  /// In the order of floats; never the least or the largest integer.
  static std::int32_t sort_key(float at) {
    const auto bits = std::bit_cast<std::int32_t>(at + 0.0f);  // -0 becomes 0
    return bits < 0 ? bits ^ 0x7fff'ffff : bits;
  }

  /// Gives the first `below` on the axis to one part, and the others to the other.
  Halves cut(const Part& from, int axis, std::uint32_t below) {
    const std::uint32_t middle = from.begin + below;
    std::uint32_t is_below = 0;
    for (std::uint32_t i = from.begin; i < middle; ++i) is_below |= 1u << order_[axis][i];
    for (int other = 0; other < 3; ++other) {
      if (other == axis) continue;
      Order& order = order_[other];
      Order above;
      std::uint32_t below_end = from.begin, above_end = 0;
      for (std::uint32_t i = from.begin; i < from.end; ++i) {
        const std::uint8_t index = order[i];
        const std::uint32_t goes_below = is_below >> index & 1;
        order[below_end] = index;
        above[above_end] = index;
        below_end += goes_below;
        above_end += 1 - goes_below;
      }
      std::copy_n(above.begin(), above_end, order.begin() + middle);
    }
    return {part(from.begin, middle), part(middle, from.end)};
  }

  const ObjectSplitCosts& costs_;
  std::uint32_t count_;
  std::array<GrowingBox, most> boxes_;
  std::array<std::uint32_t, most> ids_;
  std::array<Order, 3> order_;  ///< Indices, by axis.
  RowCutter<Area, most> cutter_;
};

}  // namespace sightline
