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
#include "sightline/math/simd.h"

namespace sightline {

/// A primitive while building: its bounds, moved about in place of it. Padded, so that one register reads it.
struct alignas(32) BoundsReference {
  Aabb box;
  std::uint32_t id;
};
static_assert(sizeof(BoundsReference) == 32 && sizeof(Aabb) == 24);

/// A box that grows by one instruction a reference, where registers are wide enough.
class GrowingBox {
 public:
  GrowingBox() { lows_.fill(std::numeric_limits<float>::infinity()); }

  void extend(const BoundsReference& item) {
    for (std::size_t i = 0; i < 8; i += hn::Lanes(d)) {
      const auto old = hn::Load(d, lows_.data() + i);
      const auto added = hn::Load(d, reinterpret_cast<const float*>(&item) + i);
      hn::Store(hn::Min(old, hn::Xor(added, hn::Load(d, signs.data() + i))), d, lows_.data() + i);
    }
  }
  void extend(const GrowingBox& other) {
    for (std::size_t i = 0; i < 8; i += hn::Lanes(d)) {
      hn::Store(hn::Min(hn::Load(d, lows_.data() + i), hn::Load(d, other.lows_.data() + i)), d, lows_.data() + i);
    }
  }
  Aabb box() const { return {{lows_[0], lows_[1], lows_[2]}, {-lows_[3], -lows_[4], -lows_[5]}}; }

 private:
  using D = hn::CappedTag<float, 8>;
  static constexpr D d{};
  alignas(32) static constexpr std::array<float, 8> signs{0, 0, 0, -0.0f, -0.0f, -0.0f, 0, 0};

  alignas(32) std::array<float, 8> lows_;  ///< Low ends, high ones negated; the last two mean nothing.
};

inline Aabb bounds_of(std::span<const BoundsReference> items) {
  GrowingBox all;
  for (const BoundsReference& item : items) all.extend(item);
  return all.box();
}

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
  static constexpr std::size_t many = 1024;  ///< Fewer references are divided between few_bins at most.
  static constexpr int few_bins = 16;

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

  struct Bins {
    std::array<GrowingBox, max_split_bins> boxes;
    std::array<std::uint32_t, max_split_bins> counts{};
  };

  /// Which bins a reference's center falls into, on all axes at once. NaN, from an extent that is no finite float,
  /// falls into the first.
  class Binning {
   public:
    Binning(const Aabb& centers, int count) : last_(static_cast<float>(count - 1)) {
      for (int axis = 0; axis < 3; ++axis) {
        lowest_[axis] = centers.lo[axis];
        scale_[axis] = static_cast<float>(count) / (centers.hi[axis] - centers.lo[axis]);
      }
    }

    /// Of the axes; the fourth number means nothing.
    std::array<std::int32_t, 4> operator()(const BoundsReference& item) const {
      constexpr hn::CappedTag<float, 4> d{};
      constexpr hn::RebindToSigned<decltype(d)> to_int{};
      alignas(16) std::array<std::int32_t, 4> bins;
      for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
        const auto half = hn::Set(d, 0.5f);
        const auto center =
            hn::Add(hn::Mul(half, hn::LoadU(d, &item.box.lo.x + i)), hn::Mul(half, hn::LoadU(d, &item.box.hi.x + i)));
        const auto place = hn::Mul(hn::Sub(center, hn::Load(d, lowest_.data() + i)), hn::Load(d, scale_.data() + i));
        const auto above = hn::IfThenElseZero(hn::Gt(place, hn::Zero(d)), place);
        hn::Store(hn::ConvertTo(to_int, hn::Min(above, hn::Set(d, last_))), to_int, bins.data() + i);
      }
      return bins;
    }

   private:
    alignas(16) std::array<float, 4> lowest_{}, scale_{};
    float last_;
  };

  std::size_t bin(std::span<BoundsReference> items, const Aabb& box) const {
    const int count = items.size() < many ? std::min(costs_.bins, few_bins) : costs_.bins;
    const Binning binning(centers_of(items), count);
    std::array<Bins, 3> bins;
    for (const BoundsReference& item : items) {
      const auto into = binning(item);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(into[axis]);
        bins[axis].boxes[i].extend(item);
        ++bins[axis].counts[i];
      }
    }
    Choice best;
    for (int axis = 0; axis < 3; ++axis) choose(bins[axis], count, axis, best);
    if (best.below == 0) return median(items);  // every axis has all centers in one bin
    if (is_leaf_cheaper(best, items.size(), box)) return 0;
    const auto middle = std::partition(
        items.begin(), items.end(), [&](const BoundsReference& item) { return binning(item)[best.axis] < best.place; });
    return static_cast<std::size_t>(middle - items.begin());
  }

  void choose(const Bins& bins, int count, int axis, Choice& best) const {
    std::array<double, max_split_bins> area_above;
    std::array<std::size_t, max_split_bins> count_above;
    GrowingBox above, below;
    std::size_t in_above = 0, in_below = 0;
    for (int place = count - 1; place > 0; --place) {
      above.extend(bins.boxes[place]);
      area_above[place] = area_(above.box());
      count_above[place] = in_above += bins.counts[place];
    }
    for (int place = 1; place < count; ++place) {
      below.extend(bins.boxes[place - 1]);
      in_below += bins.counts[place - 1];
      if (in_below == 0 || count_above[place] == 0) continue;
      consider(weigh(area_(below.box()), in_below, area_above[place], count_above[place]), axis, place, best);
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
