#pragma once
/// Dividing a set of primitives in two by the surface area heuristic.
///
/// Goldsmith and Salmon, "Automatic Creation of Object Hierarchies for Ray Tracing", 1987 (the cost); MacDonald and
/// Booth, "Heuristics for ray tracing using space subdivision", 1990; Wald, "On fast Construction of SAH-based Bounding
/// Volume Hierarchies", 2007 (the bins).

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "sightline/math/aabb.h"
#include "sightline/math/rounding.h"

namespace sightline {

/// A primitive while building: its bounds, moved about in place of it.
struct BoundsReference {
  Aabb box;
  std::uint32_t id;
};

inline constexpr int max_split_bins = 64;

/// What the heuristic weighs. All costs are relative to each other.
struct ObjectSplitCosts {
  double inner_node;  ///< Opening an inner node.
  double primitive;   ///< One primitive test.
  int max_leaf_size;
  int bins;
};

/// Divides references in place.
/// `Area` tells, up to a constant factor, the surface area of the bounding volume that circumscribes a box.
///   S1  Both parts hold at least one reference; `median` parts differ by at most one.
///   S2  The result depends on the references and their order only.
template <class Area>
class ObjectSplitter {
 public:
  ObjectSplitter(const ObjectSplitCosts& costs, Area area) : costs_(costs), area_(area) {
    assert(costs.bins >= 2 && costs.bins <= max_split_bins);
  }

  /// Reorders `items`, which lie in `box`, so that the returned number of them come first; 0 for a leaf.
  std::size_t cheapest(std::span<BoundsReference> items, const Aabb& box) const {
    if (items.size() < 2) return 0;
    // Binning sees few of the ways to divide a small set; trying all costs little there.
    return items.size() <= sweep_size ? sweep(items, box) : bin(items, box);
  }

  /// Halves the references at the median of their centers, along the axis on which these spread most; 0 for a leaf.
  std::size_t median(std::span<BoundsReference> items) const {
    if (items.size() <= static_cast<std::size_t>(costs_.max_leaf_size)) return 0;
    const int axis = centers_of(items).longest_axis();
    const std::size_t half = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     [axis](const BoundsReference& a, const BoundsReference& b) {
                       const float at_a = center(a, axis), at_b = center(b, axis);
                       return at_a < at_b || (at_a == at_b && a.id < b.id);
                     });
    return half;
  }

 private:
  static constexpr std::size_t sweep_size = 32;

  /// Area times count of both parts. Equal costs (points, lines, copies) go to the more balanced parts.
  struct Choice {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t imbalance = 0;
    int axis = 0;
    int place = 0;  ///< The first bin, or the first reference, of the second part.
    std::size_t below = 0;

    bool is_better_than(const Choice& other) const {
      return cost < other.cost || (cost == other.cost && imbalance < other.imbalance);
    }
  };

  static float center(const BoundsReference& item, int axis) {
    return 0.5f * item.box.lo[axis] + 0.5f * item.box.hi[axis];
  }

  static Aabb centers_of(std::span<const BoundsReference> items) {
    Aabb centers;
    for (const BoundsReference& item : items) centers.extend(item.box.center());
    return centers;
  }

  static Choice weigh(double area_below, std::size_t below, double area_above, std::size_t above) {
    return {area_below * static_cast<double>(below) + area_above * static_cast<double>(above),
            below > above ? below - above : above - below, 0, 0, below};
  }

  bool is_leaf_cheaper(const Choice& best, std::size_t count, const Aabb& box) const {
    if (count > static_cast<std::size_t>(costs_.max_leaf_size)) return false;
    const double area = area_(box);
    return costs_.primitive * area * static_cast<double>(count) <=
           costs_.inner_node * area + costs_.primitive * best.cost;
  }

  struct Bin {
    Aabb box;
    std::size_t count = 0;

    void extend(const Bin& other) {
      box.extend(other.box);
      count += other.count;
    }
  };
  using Bins = std::array<Bin, max_split_bins>;

  /// Which bin a center falls into. NaN, from an extent that is no finite float, falls into the first.
  struct Binning {
    float lowest = 0, scale = 0;
    int count = 0;

    int operator()(float at) const { return clamp_to_index((at - lowest) * scale, count); }
  };

  std::size_t bin(std::span<BoundsReference> items, const Aabb& box) const {
    const Aabb centers = centers_of(items);
    std::array<Binning, 3> binning;
    std::array<Bins, 3> bins;
    for (int axis = 0; axis < 3; ++axis) {
      const float extent = centers.hi[axis] - centers.lo[axis];
      binning[axis] = {centers.lo[axis], static_cast<float>(costs_.bins) / extent, costs_.bins};
    }
    for (const BoundsReference& item : items) {
      for (int axis = 0; axis < 3; ++axis) {
        Bin& into = bins[axis][binning[axis](center(item, axis))];
        into.box.extend(item.box);
        ++into.count;
      }
    }
    Choice best;
    for (int axis = 0; axis < 3; ++axis) choose(bins[axis], axis, best);
    if (best.below == 0) return median(items);  // every axis has all centers in one bin
    if (is_leaf_cheaper(best, items.size(), box)) return 0;
    const Binning& chosen = binning[best.axis];
    const auto middle = std::partition(items.begin(), items.end(), [&](const BoundsReference& item) {
      return chosen(center(item, best.axis)) < best.place;
    });
    return static_cast<std::size_t>(middle - items.begin());
  }

  void choose(const Bins& bins, int axis, Choice& best) const {
    std::array<double, max_split_bins> area_above;
    std::array<std::size_t, max_split_bins> count_above;
    Bin above;
    for (int place = costs_.bins - 1; place > 0; --place) {
      above.extend(bins[place]);
      area_above[place] = area_(above.box);
      count_above[place] = above.count;
    }
    Bin below;
    for (int place = 1; place < costs_.bins; ++place) {
      below.extend(bins[place - 1]);
      if (below.count == 0 || count_above[place] == 0) continue;
      consider(weigh(area_(below.box), below.count, area_above[place], count_above[place]), axis, place, best);
    }
  }

  static void consider(Choice choice, int axis, int place, Choice& best) {
    if (!choice.is_better_than(best)) return;
    choice.axis = axis;
    choice.place = place;
    best = choice;
  }

  /// Tries every way to cut the references in order of their centers.
  std::size_t sweep(std::span<BoundsReference> items, const Aabb& box) const {
    const std::size_t count = items.size();
    std::array<std::array<std::uint64_t, sweep_size>, 3> order;
    std::array<double, sweep_size> area_above;
    Choice best;
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < count; ++i) order[axis][i] = sort_key(center(items[i], axis), i);
      std::sort(order[axis].begin(), order[axis].begin() + static_cast<std::ptrdiff_t>(count));
      Aabb above;
      for (std::size_t place = count - 1; place > 0; --place) {
        above.extend(items[index_of(order[axis][place])].box);
        area_above[place] = area_(above);
      }
      Aabb below;
      for (std::size_t place = 1; place < count; ++place) {
        below.extend(items[index_of(order[axis][place - 1])].box);
        consider(weigh(area_(below), place, area_above[place], count - place), axis, static_cast<int>(place), best);
      }
    }
    if (is_leaf_cheaper(best, count, box)) return 0;
    std::array<BoundsReference, sweep_size> sorted;
    for (std::size_t i = 0; i < count; ++i) sorted[i] = items[index_of(order[best.axis][i])];
    std::copy_n(sorted.begin(), count, items.begin());
    return best.below;
  }

  /// Sorts as (at, index): floats in the order of their bits as unsigned numbers, once negative ones are turned about.
  static std::uint64_t sort_key(float at, std::size_t index) {
    const auto bits = std::bit_cast<std::uint32_t>(at + 0.0f);  // -0 becomes 0
    const std::uint32_t ordered = bits & 0x8000'0000u ? ~bits : bits | 0x8000'0000u;
    return std::uint64_t{ordered} << 32 | index;
  }
  static std::size_t index_of(std::uint64_t key) { return key & 0xffff'ffffu; }

  ObjectSplitCosts costs_;
  Area area_;
};

}  // namespace sightline
