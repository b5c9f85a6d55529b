#pragma once
/// Dividing many references in two by the surface area heuristic.
///
/// Goldsmith and Salmon, "Automatic Creation of Object Hierarchies for Ray Tracing", 1987 (the cost); MacDonald and
/// Booth, "Heuristics for ray tracing using space subdivision", 1990; Wald, "On fast Construction of SAH-based Bounding
/// Volume Hierarchies", 2007 (the bins).

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "sightline/accel/bounds_reference.h"
#include "sightline/accel/object_cut.h"
#include "sightline/accel/reference_partition.h"

namespace sightline {

inline constexpr int max_split_bins = 64;

/// Of the options that structures divided so have in common.
inline constexpr std::string_view object_quality_help = "fast: bins along the widest axis; best: every cut";
inline constexpr std::string_view object_bins_help =
    "intervals of each axis between which a large node is divided; best tries every cut instead";

/// Divides references in place. See ScaledArea for `Area`.
///   S1  Both parts hold at least one reference; `median` parts differ by at most one.
///   S2  The result depends on the references and their order only, not on how many threads there are.
template <class Area>
class ObjectSplitter {
 public:
  struct Halves {
    ReferenceSet below, above;
  };

  explicit ObjectSplitter(const ObjectSplitCosts& costs) : costs_(costs) {
    assert(costs.bins >= 2 && costs.bins <= max_split_bins);
  }

  /// Reorders the references of the set so that the parts stand side by side; none for a leaf. The quality `fast`
  /// weighs cuts along the axis on which the centers spread most.
  std::optional<Halves> cheapest(const ReferenceSet& set) const {
    if (set.count() < 2 || costs_.is_leaf_at_once(set.count())) return {};
    const bool is_fast = costs_.quality == Quality::fast;
    const int bin_count = set.count() < many ? std::min(costs_.bins, few_bins) : costs_.bins;
    const Binning binning(set.bounds.centers, bin_count);
    const int widest = set.bounds.centers.longest_axis();
    const Bins bins =
        is_fast
            ? fill(set.items, bin_count, widest, widest + 1,
                   [&](const BoundsReference& item, Bins& to) { to.add_along(widest, item, binning); })
            : fill(set.items, bin_count, 0, 3, [&](const BoundsReference& item, Bins& to) { to.add(item, binning); });
    const ScaledArea<Area> area(set.box());
    RowCutter<Area, max_split_bins> cutter;
    ObjectCut best;
    for (int axis = bins.first_axis; axis < bins.end_axis; ++axis) {
      cutter.cut(
          bin_count, [&](int i) -> const GrowingBox& { return bins.boxes[axis][i]; },
          [&](int i) { return bins.counts[axis][i]; }, area, axis, best);
    }
    if (best.place == 0) return median(set);  // every axis has all centers in one bin
    if (best.is_worse_than_leaf(set.count(), costs_, area)) return {};
    ReferenceBounds below, above;
    const std::size_t middle = partition_references(
        set.items, [&](const BoundsReference& item) { return binning.is_below(item, best.axis, best.place); },
        below.centers, above.centers);
    for (int i = 0; i < bin_count; ++i) {
      (i < best.place ? below : above).box.extend(bins.boxes[best.axis][i]);
    }
    return Halves{{set.items.first(middle), below}, {set.items.subspan(middle), above}};
  }

  /// Halves the references at the median of their centers, along the axis on which these spread most; none for a leaf.
  std::optional<Halves> median(const ReferenceSet& set) const {
    if (set.count() <= static_cast<std::uint32_t>(costs_.max_leaf_size)) return {};
    const int axis = set.bounds.centers.longest_axis();
    const std::uint32_t half = set.count() / 2;
    std::nth_element(set.items.begin(), set.items.begin() + half, set.items.end(),
                     [axis](const BoundsReference& a, const BoundsReference& b) {
                       const float at_a = ReferenceCenter::on(a, axis), at_b = ReferenceCenter::on(b, axis);
                       return at_a < at_b || (at_a == at_b && a.id < b.id);
                     });
    const std::span below = set.items.first(half), above = set.items.subspan(half);
    return Halves{{below, bounds_of(below)}, {above, bounds_of(above)}};
  }

 private:
  static constexpr std::uint32_t many = 1024;  ///< Fewer references are divided between few_bins at most.
  static constexpr int few_bins = 16;

  /// Which bins a reference's center falls into, on all axes at once. NaN, from an extent that is no finite float,
  /// falls into the first.
  class Binning {
   public:
    Binning(const CenterBounds& centers, int count) : lowest_(centers.lo()), last_(static_cast<float>(count - 1)) {
      for (int axis = 0; axis < 3; ++axis) {
        scale_[axis] = static_cast<float>(count) / (centers.hi()[axis] - centers.lo()[axis]);
      }
    }

    /// Of the axes; the fourth number means nothing.
    std::array<std::int32_t, 4> operator()(const BoundsReference& item) const {
      constexpr ReferenceCenter::D d{};
      constexpr hn::RebindToSigned<decltype(d)> to_int{};
      const ReferenceCenter center(item);
      alignas(16) std::array<std::int32_t, 4> bins;
      for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
        const auto offset = hn::Sub(hn::Load(d, center.at() + i), hn::Load(d, lowest_.data() + i));
        const auto place = hn::Mul(offset, hn::Load(d, scale_.data() + i));
        const auto above = hn::IfThenElseZero(hn::Gt(place, hn::Zero(d)), place);
        hn::Store(hn::ConvertTo(to_int, hn::Min(above, hn::Set(d, last_))), to_int, bins.data() + i);
      }
      return bins;
    }

    /// Of one axis.
    std::size_t along(int axis, const BoundsReference& item) const {
      const float place = (ReferenceCenter::on(item, axis) - lowest_[axis]) * scale_[axis];
      return static_cast<std::size_t>(std::min(place > 0 ? place : 0.0f, last_));
    }

    /// Whether the bin on the axis is one before `place`, which is above 0.
    bool is_below(const BoundsReference& item, int axis, int place) const {
      const float at = (ReferenceCenter::on(item, axis) - lowest_[axis]) * scale_[axis];
      return !(at >= static_cast<float>(place));
    }

   private:
    alignas(16) std::array<float, 4> lowest_;
    alignas(16) std::array<float, 4> scale_{};
    float last_;
  };

  struct Bins {
    int count, first_axis, end_axis;
    std::array<std::array<GrowingBox, max_split_bins>, 3> boxes;
    std::array<std::array<std::uint32_t, max_split_bins>, 3> counts;

    Bins(int bin_count, int first, int end) : count(bin_count), first_axis(first), end_axis(end) {
      for (int axis = first_axis; axis < end_axis; ++axis) {
        std::fill_n(boxes[axis].begin(), count, GrowingBox::empty());
        std::fill_n(counts[axis].begin(), count, 0u);
      }
    }
    void add(const BoundsReference& item, const Binning& binning) {
      const auto into = binning(item);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(into[axis]);
        boxes[axis][i].extend(item);
        ++counts[axis][i];
      }
    }
    void add_along(int axis, const BoundsReference& item, const Binning& binning) {
      const std::size_t i = binning.along(axis, item);
      boxes[axis][i].extend(item);
      ++counts[axis][i];
    }
    void extend(const Bins& other) {
      for (int axis = first_axis; axis < end_axis; ++axis) {
        for (int i = 0; i < count; ++i) {
          boxes[axis][i].extend(other.boxes[axis][i]);
          counts[axis][i] += other.counts[axis][i];
        }
      }
    }
  };

  /// By add(item, bins).
  template <class Add>
  static Bins fill(std::span<const BoundsReference> items, int bin_count, int first_axis, int end_axis, Add&& add) {
    const auto add_item = [&](std::size_t i, Bins& bins) { add(items[i], bins); };
    if (items.size() >= parallel_size) {
      return reduce_references(items.size(), Bins(bin_count, first_axis, end_axis), add_item);
    }
    Bins bins(bin_count, first_axis, end_axis);
    std::size_t i = 0;
    if (items.size() >= many) {
      // Neighbours often fall into one bin; two sets of bins need not wait for each other.
      Bins odd(bin_count, first_axis, end_axis);
      for (; i + 1 < items.size(); i += 2) {
        add_item(i, bins);
        add_item(i + 1, odd);
      }
      bins.extend(odd);
    }
    for (; i < items.size(); ++i) add_item(i, bins);
    return bins;
  }

  ObjectSplitCosts costs_;
};

}  // namespace sightline
