#pragma once
/// Dividing many references in two at the cheapest of all cuts, again and again.
///
/// Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007 (the sweep, sorted once); MacDonald and
/// Booth, "Heuristics for ray tracing using space subdivision", 1990.

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "sightline/accel/bounds_reference.h"
#include "sightline/accel/large_pages.h"
#include "sightline/accel/object_cut.h"
#include "sightline/accel/reference_partition.h"

namespace sightline {

/// The references are sorted along each axis once; parts inherit the orders, so all divisions together take
/// O(n log n) where they are balanced. Parts that do not overlap may be divided at the same time.
///   P1  The three orders of a part hold the same references, and stand at the same places of their arrays.
///   P2  The result depends on the references and their order only, not on how many threads there are.
template <class Area>
class ReferenceSweep {
  using Orders = std::array<std::span<BoundsReference>, 3>;

 public:
  struct Part {
    Orders orders;        ///< By axis: sorted by center.
    Orders rooms;         ///< As many places, to move the orders to.
    std::uint32_t first;  ///< Where the part begins.
    Aabb bounds;

    std::uint32_t count() const { return static_cast<std::uint32_t>(orders[0].size()); }
    const Aabb& box() const { return bounds; }
    std::uint32_t id(std::uint32_t i) const { return orders[0][i].id; }
    std::span<const BoundsReference> references() const { return orders[0]; }
  };
  struct Halves {
    Part below, above;
  };

  ReferenceSweep(LargeBuffer<BoundsReference> references, const ObjectSplitCosts& costs)
      : costs_(costs), count_(references.size()), is_below_(count_) {
    bounds_ = whole_of(references.part(0, count_)).box();
    for (int axis = 0; axis < 3; ++axis) {
      sorted_[axis] = LargeBuffer<BoundsReference>(count_);
      rooms_[axis] = LargeBuffer<BoundsReference>(count_);
      costs_below_[axis] = LargeBuffer<float>(count_);
      sort(references, axis);
    }
  }

  Part whole() {
    Part all{{}, {}, 0, bounds_};
    for (int axis = 0; axis < 3; ++axis) {
      all.orders[axis] = sorted_[axis].part(0, count_);
      all.rooms[axis] = rooms_[axis].part(0, count_);
    }
    return all;
  }

  /// Moves the references of the part; none for a leaf.
  std::optional<Halves> cheapest(const Part& part) {
    if (part.count() < 2) return {};
    const ScaledArea<Area> area(part.bounds);
    std::array<ObjectCut, 3> cuts;
    for_each_axis(part, [&](int axis) { cuts[axis] = cheapest_along(part, axis, area); });
    ObjectCut best;
    for (const ObjectCut& cut : cuts) best.improve(cut);
    if (best.place == 0) return median(part);
    if (best.is_worse_than_leaf(part.count(), costs_, area)) return {};
    return cut(part, best.axis, static_cast<std::uint32_t>(best.place));
  }

  /// Halves the references in the order along the longest axis of their bounds; none for a leaf.
  std::optional<Halves> median(const Part& part) {
    if (part.count() <= static_cast<std::uint32_t>(costs_.max_leaf_size)) return {};
    return cut(part, part.bounds.longest_axis(), part.count() / 2);
  }

 private:
  static constexpr std::uint32_t block_size = 64;  ///< Boxes that are measured together.

  /// By center, then by place, which becomes the reference's number.
  void sort(const LargeBuffer<BoundsReference>& references, int axis) {
    LargeBuffer<std::uint64_t> keys(count_);
    tbb::parallel_for(std::size_t{0}, count_, [&](std::size_t i) {
      const auto bits = std::bit_cast<std::uint32_t>(ReferenceCenter::on(references[i], axis) + 0.0f);  // no -0
      const std::uint32_t rank = bits >> 31 ? ~bits : bits | 0x8000'0000u;  // in the order of floats
      keys[i] = std::uint64_t(rank) << 32 | i;
    });
    tbb::parallel_sort(keys.data(), keys.data() + count_);
    tbb::parallel_for(std::size_t{0}, count_, [&](std::size_t i) {
      const auto number = static_cast<std::uint32_t>(keys[i]);
      sorted_[axis][i] = references[number];
      sorted_[axis][i].number = number;
    });
  }

  template <class Use>
  static void for_each_axis(const Part& part, Use&& use) {
    if (part.count() >= parallel_size) {
      tbb::parallel_for(0, 3, use);
    } else {
      for (int axis = 0; axis < 3; ++axis) use(axis);
    }
  }

  ObjectCut cheapest_along(const Part& part, int axis, const ScaledArea<Area>& area) {
    const std::span<const BoundsReference> row = part.orders[axis];
    const std::uint32_t count = part.count();
    float* const costs_below = costs_below_[axis].data() + part.first;
    MeasuredBoxes<Area, block_size> boxes;
    GrowingBox grown = GrowingBox::empty();
    for (std::uint32_t begin = 0; begin < count; begin += block_size) {
      const std::uint32_t size = std::min(block_size, count - begin);
      for (std::uint32_t i = 0; i < size; ++i) {
        boxes[i] = grown;
        grown.extend(row[begin + i]);
      }
      boxes.measure(static_cast<int>(size), area.scale());
      for (std::uint32_t i = 0; i < size; ++i) costs_below[begin + i] = boxes.area(i) * static_cast<float>(begin + i);
    }

    ObjectCut best;
    grown = GrowingBox::empty();
    for (std::uint32_t end = count; end > 0;) {
      const std::uint32_t begin = (end - 1) / block_size * block_size, size = end - begin;
      for (std::uint32_t i = size; i-- > 0;) {
        grown.extend(row[begin + i]);
        boxes[i] = grown;
      }
      boxes.measure(static_cast<int>(size), area.scale());
      std::array<float, block_size> costs;
      for (std::uint32_t i = 0; i < size; ++i) {
        costs[i] = costs_below[begin + i] + boxes.area(i) * static_cast<float>(count - begin - i);
      }
      for (std::uint32_t i = begin == 0; i < size; ++i) {
        if (!(costs[i] <= best.cost)) continue;
        const auto place = static_cast<int>(begin + i);
        best.improve({costs[i], std::fabs(static_cast<float>(count) - 2 * static_cast<float>(place)), axis, place});
      }
      end = begin;
    }
    return best;
  }

  /// Gives the first `below` on the axis to one part, and the others to the other.
  Halves cut(const Part& part, int axis, std::uint32_t below) {
    const std::array<std::span<BoundsReference>, 2> sides{part.orders[axis].first(below),
                                                          part.orders[axis].subspan(below)};
    std::array<GrowingBox, 2> boxes;
    for (std::size_t side = 0; side < 2; ++side) {
      GrowingBox box = GrowingBox::empty();
      for (const BoundsReference& item : sides[side]) {
        box.extend(item);
        is_below_[item.number] = side == 0;
      }
      boxes[side] = box;
    }
    Orders orders = part.orders, rooms = part.rooms;
    for_each_axis(part, [&](int other) {
      if (other == axis) return;
      BoundsReference *to_below = rooms[other].data(), *to_above = to_below + below;
      for (const BoundsReference& item : part.orders[other]) {
        const bool goes_below = is_below_[item.number];
        *(goes_below ? to_below : to_above) = item;
        to_below += goes_below;
        to_above += !goes_below;
      }
      std::swap(orders[other], rooms[other]);
    });
    Halves halves{{{}, {}, part.first, boxes[0].box()}, {{}, {}, part.first + below, boxes[1].box()}};
    for (int i = 0; i < 3; ++i) {
      halves.below.orders[i] = orders[i].first(below);
      halves.below.rooms[i] = rooms[i].first(below);
      halves.above.orders[i] = orders[i].subspan(below);
      halves.above.rooms[i] = rooms[i].subspan(below);
    }
    return halves;
  }

  const ObjectSplitCosts& costs_;
  std::size_t count_;
  Aabb bounds_;
  std::array<LargeBuffer<BoundsReference>, 3> sorted_, rooms_;
  std::array<LargeBuffer<float>, 3> costs_below_;  ///< Area times count of what is before each place.
  LargeBuffer<std::uint8_t> is_below_;             ///< By number.
};

}  // namespace sightline
