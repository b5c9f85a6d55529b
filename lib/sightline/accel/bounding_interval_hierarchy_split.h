#pragma once
/// How a node of a bounding interval hierarchy divides: by halving, or by the surface area heuristic over bins.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "sightline/accel/candidate_box.h"
#include "sightline/accel/options.h"
#include "sightline/math/aabb.h"
#include "sightline/math/simd.h"

namespace sightline::detail {

/// A box as two vectors: x, y, z and nothing. One register takes them, or several where registers are narrower.
struct BihBox {
  using D = hn::CappedTag<float, 4>;
  using V = hn::Vec<D>;
  static constexpr D d{};

  alignas(16) float lo[4];
  alignas(16) float hi[4];

  /// Both zeros become one, so that the least of several does not depend on their order.
  static BihBox of(const Aabb& box) {
    const Vec3f lo = box.lo + 0.0f, hi = box.hi + 0.0f;
    return {{lo.x, lo.y, lo.z, 0}, {hi.x, hi.y, hi.z, 0}};
  }
  Aabb box() const { return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}}; }
  float center(int axis) const { return 0.5f * lo[axis] + 0.5f * hi[axis]; }

  /// Calls see(i) for the first number of each register.
  template <class See>
  static void for_each_register(See&& see) {
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) see(i);
  }
  V centers(std::size_t i) const {
    const V half = hn::Set(d, 0.5f);
    return hn::Add(hn::Mul(half, hn::Load(d, lo + i)), hn::Mul(half, hn::Load(d, hi + i)));
  }
  void extend(std::size_t i, V other_lo, V other_hi) {
    hn::Store(hn::Min(hn::Load(d, lo + i), other_lo), d, lo + i);
    hn::Store(hn::Max(hn::Load(d, hi + i), other_hi), d, hi + i);
  }
  void extend(const BihBox& other) {
    for_each_register([&](std::size_t i) { extend(i, hn::Load(d, other.lo + i), hn::Load(d, other.hi + i)); });
  }
};

/// Bounds of primitives and of their centers.
struct BihExtent {
  BihBox bounds = BihBox::of(Aabb()), centers = bounds;

  void extend(const BihBox& box) {
    bounds.extend(box);
    BihBox::for_each_register([&](std::size_t i) { centers.extend(i, box.centers(i), box.centers(i)); });
  }
  void extend(const BihExtent& other) {
    bounds.extend(other.bounds);
    centers.extend(other.centers);
  }
};

/// Divides primitives by their centers: below are those whose (center - lowest) * scale is less than the limit.
struct BihSplit {
  int axis = -1;  ///< None where the primitives form a leaf.
  float lowest = 0;
  float scale = 1;
  float limit = 0;

  bool is_below(const BihBox& box) const { return (box.center(axis) - lowest) * scale < limit; }
};

/// Chooses splits. One at least on either side, and the same for the same boxes in whatever order.
class BihSplitter {
 public:
  BihSplitter(Quality quality, int max_leaf_size)
      : bin_count_(quality == Quality::best ? most_bins : 16),
        max_leaf_size_(static_cast<std::uint32_t>(max_leaf_size)),
        halves_(quality == Quality::fast) {}

  std::uint32_t max_leaf_size() const { return max_leaf_size_; }

  /// Whether nodes divide by halving their candidate boxes.
  bool halves() const { return halves_; }

  /// `extent` is that of the boxes; the candidate box loses halves in which there is nothing.
  /// Tight boxes weigh the parts, although rays do not see them: slabs bring what rays see close to these, and cost by
  /// the region cut with two planes alone led to more work.
  BihSplit split(std::span<const BihBox> boxes, const BihExtent& extent, Aabb& candidate) const {
    const bool may_be_leaf = boxes.size() <= max_leaf_size_;
    if (boxes.size() < 2 || (halves_ && may_be_leaf)) return {};
    if (halves_) return halve(candidate, extent);
    const Choice best = cheapest(boxes, extent);
    if (best.split.axis < 0) {  // all centers in one bin, on every axis
      Aabb centers = extent.centers.box();
      return halve(centers, extent);
    }
    const double inner_cost = node_cost + best.tests / half_area(extent.bounds.box());
    if (may_be_leaf && !(inner_cost < tests(boxes.size()))) return {};
    return best.split;
  }

 private:
  static constexpr int most_bins = 64;
  static constexpr double node_cost = 0.5;  ///< Of opening a node, relative to testing a block of primitives.
  static constexpr std::size_t block = 8;   ///< So many primitives are tested at the cost of one.

  static double tests(std::size_t count) { return static_cast<double>((count + block - 1) / block); }

  /// Left uninitialized on purpose: most nodes are small and use few of the bins.
  struct Bin {
    BihBox box;
    std::uint32_t count;

    static Bin empty() { return {BihBox::of(Aabb()), 0}; }
    void extend(const Bin& other) {
      box.extend(other.box);
      count += other.count;
    }
    double tests() const { return half_area(box.box()) * BihSplitter::tests(count); }
  };
  using Bins = std::array<Bin, most_bins>;

  struct Choice {
    BihSplit split;
    double tests = std::numeric_limits<double>::infinity();  ///< Times half the area.
  };

  static BihSplit halve(Aabb& candidate, const BihExtent& extent) {
    const auto [axis, middle] = halve_until_parted(candidate, extent.centers.box());
    return {axis, 0, 1, middle};
  }

  Choice cheapest(std::span<const BihBox> boxes, const BihExtent& extent) const {
    // Few primitives need few bins, which cost as much as the primitives do.
    const auto count = static_cast<int>(std::min(boxes.size() / 4 + 6, std::size_t(bin_count_)));
    alignas(16) float lowest[4] = {},
                      scale[4] = {};  // Axes whose extent is 0, or no number, keep all in the first bin.
    for (int axis = 0; axis < 3; ++axis) {
      const float length = extent.centers.hi[axis] - extent.centers.lo[axis];
      const float bins_per_unit = static_cast<float>(count) / length;
      if (!std::isfinite(length) || !std::isfinite(bins_per_unit)) continue;
      lowest[axis] = extent.centers.lo[axis];
      scale[axis] = bins_per_unit;
    }
    std::array<Bins, 3> bins_of;
    for (Bins& bins : bins_of) std::fill_n(bins.begin(), count, Bin::empty());
    fill(bins_of, count, boxes, lowest, scale);
    Choice best;
    for (int axis = 0; axis < 3; ++axis) {
      const auto [place, cost] = cheapest_place(bins_of[axis], count);
      if (cost < best.tests) best = {{axis, lowest[axis], scale[axis], static_cast<float>(place)}, cost};
    }
    return best;
  }

  static void fill(std::array<Bins, 3>& bins_of, int count, std::span<const BihBox> boxes, const float* lowest,
                   const float* scale) {
    constexpr BihBox::D d;
    constexpr hn::RebindToSigned<BihBox::D> to_int;
    const auto first = hn::Zero(to_int), last = hn::Set(to_int, count - 1);
    for (const BihBox& box : boxes) {
      alignas(16) std::int32_t at[4];
      BihBox::for_each_register([&](std::size_t i) {
        const auto above = hn::Sub(box.centers(i), hn::Load(d, lowest + i));
        const auto place = hn::ConvertTo(to_int, hn::Mul(above, hn::Load(d, scale + i)));
        hn::Store(hn::Min(hn::Max(place, first), last), to_int, at + i);
      });
      for (int axis = 0; axis < 3; ++axis) {
        Bin& bin = bins_of[axis][at[axis]];
        bin.box.extend(box);
        ++bin.count;
      }
    }
  }

  /// The first bin above the split, and its tests; infinity where one side would be empty wherever it is.
  static std::pair<int, double> cheapest_place(const Bins& bins, int count) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, most_bins> tests_above;
    Bin above = Bin::empty(), below = above;
    for (int place = count - 1; place > 0; --place) {
      above.extend(bins[place]);
      tests_above[place] = above.count > 0 ? above.tests() : infinity;
    }
    std::pair<int, double> best{0, infinity};
    for (int place = 1; place < count; ++place) {
      below.extend(bins[place - 1]);
      if (below.count == 0) continue;
      const double tests = below.tests() + tests_above[place];
      if (tests < best.second) best = {place, tests};
    }
    return best;
  }

  int bin_count_;
  std::uint32_t max_leaf_size_;
  bool halves_;
};

}  // namespace sightline::detail
