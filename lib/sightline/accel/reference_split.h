#pragma once
/// Long primitives as several references, each with the bounds of its part alone: boxes around slanted sticks are
/// nearly empty, those around their pieces are less so.
///
/// Ernst and Greiner, "Early Split Clipping for Bounding Volume Hierarchies", 2007; Karras and Aila, "Fast Parallel
/// Construction of High-Quality Bounding Volume Hierarchies", 2013 (splitting before building, each primitive with a
/// share of one budget).

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/bounds_reference.h"
#include "sightline/accel/large_pages.h"
#include "sightline/accel/options.h"
#include "sightline/accel/primitives.h"
#include "sightline/math/aabb.h"
#include "sightline/math/rounding.h"

namespace sightline {

/// Divides primitives into pieces of equal length along the longest side of their boxes.
///   R1  Every point of a primitive lies in the box of one of its references.
///   R2  There are no more references than the budget allows. Those of a primitive stand side by side, in the order of
///       ids.
///   R3  The references depend on the primitives only, not on how many threads there are.
/// Cut into k pieces, a slanted line of box area A has boxes of area A / k together; the sum over all lines is least
/// when k grows with the square root of A. So one scale, the largest that the budget allows, gives each primitive its
/// number. Primitives that are alike get the same one, though some of the budget may stay unused: pieces of two sizes
/// on top of each other make a worse tree than whole primitives do. Primitives that are no such lines, because a cut
/// saves too little (most triangles of scans, boxes, spheres), stay whole.
class ReferenceSplitter {
 public:
  explicit ReferenceSplitter(const Primitives& primitives)
      : primitives_(primitives), whole_(references_of(primitives)) {
    const Aabb bounds = whole_of(whole_.part(0, whole_.size())).box();
    slack_ = whole_.empty() ? 0 : 0x1p-48 * max_norm(Vec3d(bounds.hi) - Vec3d(bounds.lo));
  }

  /// What part of the area of all boxes is around lines, from a sample.
  double share_of_lines() const {
    constexpr std::size_t sample_size = 4096;
    const std::size_t step = 1 + whole_.size() / sample_size;
    double lines = 0, all = 0;
    for (std::size_t i = 0; i < whole_.size(); i += step) {
      const double area = half_area(whole_[i].box);
      all += area;
      if (size_of(whole_[i]) > 0) lines += area;
    }
    return all > 0 ? lines / all : 0;
  }

  /// `most`: references, no fewer than primitives.
  LargeBuffer<BoundsReference> split(std::uint64_t most) {
    const std::size_t count = whole_.size();
    std::vector<double> sizes(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { sizes[i] = size_of(whole_[i]); });
    const double scale = largest_scale(sizes, most - count);
    if (scale == 0) return std::move(whole_);

    std::vector<std::size_t> places(count + 1);
    for (std::size_t i = 0; i < count; ++i) places[i + 1] = places[i] + pieces_of(sizes[i], scale);
    LargeBuffer<BoundsReference> pieces(places[count]);
    std::vector<std::uint32_t> made(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      BoundsReference* const first = pieces.data() + places[i];
      made[i] = static_cast<std::uint32_t>(divide(whole_[i], pieces_of(sizes[i], scale), first) - first);
    });
    return without_gaps(std::move(pieces), places, made);
  }

 private:
  struct Halves {
    BoundsReference below, above;
  };

  /// Share of what a cut would save of a line's box.
  static constexpr double least_saving = 0.9;

  /// Square root of the area of a primitive worth cutting, rounded to a fourth of an octave, so that those that are
  /// alike have one size; 0 for others.
  double size_of(const BoundsReference& item) const {
    return cut(item, 0.5) ? std::exp2(std::round(2 * std::log2(half_area(item.box))) / 4) : 0;
  }

  static std::uint32_t pieces_of(double size, double scale) {
    return std::max(1u, static_cast<std::uint32_t>(size * scale + 0.5));
  }

  /// 0 when nothing can be cut.
  static double largest_scale(const std::vector<double>& sizes, std::uint64_t budget) {
    std::vector<double> cuttable;
    std::copy_if(sizes.begin(), sizes.end(), std::back_inserter(cuttable), [](double size) { return size > 0; });
    if (cuttable.empty()) return 0;
    using Range = tbb::blocked_range<std::size_t>;
    const auto is_within_budget = [&](double scale) {
      const auto added_in = [&](const Range& range, std::uint64_t sum) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) sum += pieces_of(cuttable[i], scale) - 1;
        return sum;
      };
      return tbb::parallel_reduce(Range(0, cuttable.size(), 4096), std::uint64_t{0}, added_in, std::plus<>()) <= budget;
    };
    const double longest = *std::max_element(cuttable.begin(), cuttable.end());
    double low = 0, high = static_cast<double>(budget + 2) / longest;  // the longest alone is then beyond the budget
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (low + high);
      (is_within_budget(middle) ? low : high) = middle;
    }
    return low;
  }

  /// Writes at most so many pieces; returns the end of what it wrote.
  BoundsReference* divide(const BoundsReference& item, std::uint32_t pieces, BoundsReference* to) const {
    if (pieces > 1) {
      const std::uint32_t below = pieces / 2;
      if (const auto halves = cut(item, static_cast<double>(below) / pieces)) {
        to = divide(halves->below, below, to);
        return divide(halves->above, pieces - below, to);
      }
    }
    *to = item;
    return to + 1;
  }

  /// Cuts a reference across its longest side at this share of it; nothing where that does not pay.
  std::optional<Halves> cut(const BoundsReference& item, double share) const {
    const int axis = item.box.longest_axis();
    const double lo = item.box.lo[axis], hi = item.box.hi[axis];
    const auto place = static_cast<float>(lo + share * (hi - lo));
    if (!(lo < place && place < hi)) return {};
    Aabb below = item.box, above = item.box;
    below.hi[axis] = above.lo[axis] = place;
    const Halves halves{{part_within(below, item.id), item.id}, {part_within(above, item.id), item.id}};
    if (halves.below.box.is_empty() || halves.above.box.is_empty()) return {};
    const double area = half_area(item.box);
    const double saved = area - half_area(halves.below.box) - half_area(halves.above.box);
    const double saved_of_line = 2 * share * (1 - share) * area;
    if (!(saved >= least_saving * saved_of_line)) return {};
    return halves;
  }

  /// Bounds of a primitive's part in a cell. Clipping works in double; its six cuts misplace planes and points by less
  /// than 32 u of the scene's extent, which the slack outweighs (R1).
  Aabb part_within(const Aabb& cell, std::uint32_t id) const {
    const Aabb part = primitives_.clip(id, widened(cell));
    return part.is_empty() ? part : intersection(widened(part), cell);
  }

  Aabb widened(const Aabb& box) const {
    Aabb wide;
    for (int axis = 0; axis < 3; ++axis) {
      wide.lo[axis] = round_down(box.lo[axis] - slack_);
      wide.hi[axis] = round_up(box.hi[axis] + slack_);
    }
    return wide;
  }

  static LargeBuffer<BoundsReference> without_gaps(LargeBuffer<BoundsReference> pieces,
                                                   const std::vector<std::size_t>& places,
                                                   const std::vector<std::uint32_t>& made) {
    std::vector<std::size_t> targets(made.size() + 1);
    for (std::size_t i = 0; i < made.size(); ++i) targets[i + 1] = targets[i] + made[i];
    if (targets.back() == pieces.size()) return pieces;
    LargeBuffer<BoundsReference> dense(targets.back());
    tbb::parallel_for(std::size_t{0}, made.size(), [&](std::size_t i) {
      std::copy_n(pieces.data() + places[i], made[i], dense.data() + targets[i]);
    });
    return dense;
  }

  const Primitives& primitives_;
  LargeBuffer<BoundsReference> whole_;
  double slack_;
};

inline constexpr std::string_view reference_splits_help =
    "most references added for long primitives, in percent of all; -1: 200 for scenes of lines at best, else 0";

/// What the option `splits` means: so many percent, or, below 0, what pays at this quality: none but for scenes of
/// lines at `best`.
inline int splits_of(const Primitives& primitives, int splits, Quality quality) {
  constexpr int of_lines = 200;
  if (splits >= 0) return splits;
  return quality == Quality::best && ReferenceSplitter(primitives).share_of_lines() > 0.5 ? of_lines : 0;
}

/// References to build with: one for each primitive and at most `percent` of their number more, `limit` together.
inline LargeBuffer<BoundsReference> references_of(const Primitives& primitives, int percent,
                                                  std::uint32_t limit = std::numeric_limits<std::uint32_t>::max()) {
  const std::uint64_t count = primitives.size();
  const std::uint64_t most = std::min<std::uint64_t>(count + count * static_cast<std::uint64_t>(percent) / 100, limit);
  return most <= count ? references_of(primitives) : ReferenceSplitter(primitives).split(most);
}

/// Leaves of a leaf order without the ids that repeat within one.
class LeafMerger {
 public:
  explicit LeafMerger(std::vector<std::uint32_t>& order) : order_(order) {}

  /// The leaf's place once it and those before it are merged. Leaves come in order of position.
  LeafRange merge(LeafRange leaf) {
    const std::uint32_t first = end_;
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const std::uint32_t id = order_[i];
      const auto kept = order_.begin() + end_;
      if (std::find(order_.begin() + first, kept, id) == kept) order_[end_++] = id;
    }
    return {first, end_ - first};
  }

  /// When all leaves are merged.
  void finish() {
    order_.resize(end_);
    order_.shrink_to_fit();
  }

 private:
  std::vector<std::uint32_t>& order_;
  std::uint32_t end_ = 0;
};

}  // namespace sightline
