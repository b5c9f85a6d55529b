#pragma once
/// The search for the plane that splits a convex cell best, by the surface area heuristic.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "sightline/accel/bsp_tree_nodes.h"
#include "sightline/accel/fragments.h"
#include "sightline/accel/options.h"
#include "sightline/math/convex_cell.h"
#include "sightline/math/rounding.h"
#include "sightline/math/simd.h"

namespace sightline {

/// What examining nodes is taken to cost.
struct BspCosts {
  double axis_plane, general_plane;  ///< One node's test.
  double primitive;                  ///< One candidate of a leaf; several are tested at once, ...
  double leaf;                       ///< ... so that a leaf with any candidates costs this beforehand.

  double plane(const SplitPlane& split) const { return split.is_general ? general_plane : axis_plane; }
  double tests(double count) const { return count > 0 ? leaf + primitive * count : 0; }
};

/// How thoroughly planes are sought.
struct BspEffort {
  std::uint32_t general_size;       ///< So few primitives are divided by planes of any orientation.
  std::uint32_t exhaustive_size;    ///< So few have all the axis planes at their bounds tried.
  std::uint32_t sampled_fragments;  ///< Those whose own and edge planes are tried.
  int bins;                         ///< Along each axis, for more.
  std::ptrdiff_t exact_costs;       ///< Candidates that have their areas computed; the others' are only estimated.

  static BspEffort of(Quality quality) {
    if (quality == Quality::fast) return {0, 0, 0, 16, 16};
    if (quality == Quality::balanced) return {64, 48, 8, 32, 8};
    return {256, 128, 128, 64, 1 << 30};
  }
};

/// Holds the scratch of many searches. Candidates are axis planes at the fragments' bounds, the polygons' own planes
/// and the planes through their edges, and those parallel to them that touch what the cell holds from outside. Of many
/// fragments, bins along the axes and along the normals of a few of them are tried instead, counted on a bounded
/// sample: a bounded effort a fragment in either case.
class SplitSearch {
 public:
  struct Choice {
    SplitPlane split;
    double cost;
    bool keeps_on_below;  ///< On which side polygons belong that lie on the plane: that of less area.
  };

  /// Fragments are relative to `center`; those within `thickness` of a plane lie on it.
  SplitSearch(const Primitives& primitives, const Vec3d& center, double thickness, const BspCosts& costs,
              const BspEffort& effort)
      : primitives_(primitives), center_(center), thickness_(thickness), costs_(costs), effort_(effort) {}

  /// Of whom nothing is told.
  struct NoWatcher {
    void operator()(const SplitPlane&, double, const auto&) const {}
  };

  /// None where no plane makes the cell cheaper than `limit`. The fragments stand for `weight` times as many.
  /// watch(split, cost, counts) is told of each candidate that has its cost computed, with `below`, `above` and `on`.
  template <class Watch = NoWatcher>
  std::optional<Choice> best(const ConvexCell& cell, const Fragments& fragments, double limit, bool allow_general,
                             double weight = 1, Watch&& watch = {}) {
    limit_ = limit;
    threshold_ = loose * limit;
    weight_ = weight;
    candidates_.clear();
    if (!(cell.area() > 0)) return std::nullopt;
    const bool is_exhaustive = fragments.size() <= effort_.exhaustive_size;
    for (int axis = 0; axis < 3; ++axis) {
      const SplitPlane split = SplitPlane::across(axis, 0);
      measure_each(split, fragments, 1);
      is_exhaustive ? sweep(split, cell) : try_bins(split, cell);
    }
    if (!allow_general) return best_of_candidates(cell, watch);
    if (is_exhaustive) pack(fragments);
    const std::uint32_t step = std::max(1u, fragments.size() / sampled_counts);
    const std::uint64_t samples = std::min(effort_.sampled_fragments, fragments.size());
    for (std::uint64_t sample = 0; sample < samples; ++sample) {
      const auto i = static_cast<std::uint32_t>((2 * sample + 1) * fragments.size() / (2 * samples));
      for (const Plane& plane : primitives_.planes(fragments[i].id)) {
        const std::optional<SplitPlane> split = SplitPlane::general(plane, center_);
        if (!split) continue;
        if (is_exhaustive) {
          measure_packed(*split, fragments.size());
        } else {
          measure_each(*split, fragments, step);
          try_bins(*split, cell);
        }
        try_general(*split, cell);
      }
    }
    return best_of_candidates(cell, watch);
  }

 private:
  static constexpr std::uint32_t sampled_counts = 2048;  ///< Fragments counted, at least, for a general plane.
  static constexpr std::uint32_t group_size = 8;
  static constexpr int most_bins = 64;
  static constexpr double loose = 1.5;  ///< Estimates may exceed the limit by this factor.

  struct Counts {
    double below = 0, above = 0, on = 0;  ///< Those that cross count below and above.
  };
  struct Candidate {
    double estimate;  ///< Of the cost.
    double offset;    ///< Of the plane, relative to the center.
    SplitPlane split;
    Counts counts;
  };

  /// Takes the plane, moved to `offset` from the center, for a candidate, with an estimate of its cost. At the share x
  /// of the cell's extent, some x of the surface lies below; the section is as large as the cell's projection along the
  /// normal where the cell is a prism, and 4 x (1 - x) of that where it is a ball; the estimate lies between.
  void consider(const SplitPlane& split, double offset, const Counts& counts) {
    if (!(cell_extent_.lo < offset && offset < cell_extent_.hi)) return;
    const double x = (offset - cell_extent_.lo) / (cell_extent_.hi - cell_extent_.lo);
    const double section = section_ * std::sqrt(4 * x * (1 - x));
    const double estimate = costs_.plane(split) + std::min(1.0, x + section) * costs_.tests(weight_ * counts.below) +
                            std::min(1.0, 1 - x + section) * costs_.tests(weight_ * counts.above);
    if (!(estimate < threshold_)) return;
    candidates_.push_back({estimate, offset, split, counts});
    if (std::ssize(candidates_) >= 4 * effort_.exact_costs) keep_promising();
  }

  void keep_promising() {
    if (std::ssize(candidates_) <= effort_.exact_costs) return;
    const auto last = candidates_.begin() + effort_.exact_costs;
    std::nth_element(candidates_.begin(), last, candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.estimate < b.estimate; });
    threshold_ = last->estimate;
    candidates_.erase(last, candidates_.end());
  }

  /// Areas are what takes time, so that they are computed for the most promising candidates only.
  template <class Watch>
  std::optional<Choice> best_of_candidates(const ConvexCell& cell, Watch& watch) {
    std::optional<Choice> best;
    double best_cost = limit_;
    keep_promising();
    for (const Candidate& candidate : candidates_) {
      const SplitPlane split = moved(candidate.split, candidate.offset);
      const double on = weight_ * candidate.counts.on;
      const double below = weight_ * candidate.counts.below, above = weight_ * candidate.counts.above;
      ConvexCell::Heights heights;
      cell.measure(split.plane(center_), heights);
      if (!(heights.lo < 0 && heights.hi > 0)) continue;
      const ConvexCell::Areas areas = cell.areas(heights);
      const bool on_below = areas.below <= areas.above;
      const double tests = areas.below * costs_.tests(below + (on_below ? on : 0)) +
                           areas.above * costs_.tests(above + (on_below ? 0 : on));
      const double cost = costs_.plane(split) + tests / cell.area();
      watch(split, cost, candidate.counts);
      if (cost < best_cost) {
        best_cost = cost;
        best = Choice{split, cost, on_below};
      }
    }
    return best;
  }

  void measure_cell(const SplitPlane& split, const ConvexCell& cell) {
    const Vec3d normal(split.normal);
    cell_extent_ = cell.extent(normal);
    section_ = cell.shadow(normal) / cell.area();
  }

  // Extents of the fragments along a normal.

  /// Of every step-th fragment.
  void measure_each(const SplitPlane& split, const Fragments& fragments, std::uint32_t step) {
    const Vec3d normal(split.normal);
    lows_.clear();
    highs_.clear();
    for (std::uint32_t i = 0; i < fragments.size(); i += step) {
      const Interval<double> extent = extent_along(fragments.points(fragments[i]), normal);
      lows_.push_back(extent.lo);
      highs_.push_back(extent.hi);
    }
    share_ = static_cast<double>(fragments.size()) / static_cast<double>(lows_.size());
    finish_measuring(lows_.size());
  }

  /// Corners transposed, eight fragments side by side, so that one plane meets several at a time. A group's corners
  /// are as many as those of the fragment that has most; others repeat their last.
  void pack(const Fragments& fragments) {
    octets_.clear();
    octet_ends_.clear();
    for (std::uint32_t first = 0; first < fragments.size(); first += group_size) {
      std::array<std::span<const Vec3d>, group_size> corners;
      std::size_t most = 0;
      for (std::uint32_t lane = 0; lane < group_size; ++lane) {
        // Lanes without a fragment repeat the first; they are not counted.
        corners[lane] = fragments.points(fragments[first + lane < fragments.size() ? first + lane : first]);
        most = std::max(most, corners[lane].size());
      }
      for (std::size_t corner = 0; corner < most; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
          for (const auto& points : corners) octets_.push_back(points[std::min(corner, points.size() - 1)][axis]);
        }
      }
      octet_ends_.push_back(octets_.size());
    }
  }

  void measure_packed(const SplitPlane& split, std::uint32_t count) {
    constexpr hn::CappedTag<double, group_size> d;
    const auto x = hn::Set(d, double(split.normal.x)), y = hn::Set(d, double(split.normal.y)),
               z = hn::Set(d, double(split.normal.z));
    lows_.resize(group_size * octet_ends_.size());
    highs_.resize(lows_.size());
    for (std::size_t group = 0; group < octet_ends_.size(); ++group) {
      const double* const end = octets_.data() + octet_ends_[group];
      for (std::size_t lane = 0; lane < group_size; lane += hn::Lanes(d)) {
        auto low = hn::Set(d, std::numeric_limits<double>::infinity()), high = hn::Neg(low);
        for (const double* at = octets_.data() + (group == 0 ? 0 : octet_ends_[group - 1]); at != end;
             at += 3 * group_size) {
          const auto height =
              hn::MulAdd(z, hn::LoadU(d, at + 2 * group_size + lane),
                         hn::MulAdd(y, hn::LoadU(d, at + group_size + lane), hn::Mul(x, hn::LoadU(d, at + lane))));
          low = hn::Min(low, height);
          high = hn::Max(high, height);
        }
        hn::StoreU(low, d, lows_.data() + group_size * group + lane);
        hn::StoreU(high, d, highs_.data() + group_size * group + lane);
      }
    }
    share_ = 1;
    finish_measuring(count);
  }

  void finish_measuring(std::size_t count) {
    lows_.resize(count);
    highs_.resize(count);
    content_ = {};
    for (std::size_t i = 0; i < count; ++i) {
      content_.lo = lows_[i] < content_.lo ? lows_[i] : content_.lo;
      content_.hi = highs_[i] > content_.hi ? highs_[i] : content_.hi;
    }
  }

  // Planes along a normal that has been measured.

  /// The split moved, relative to the center.
  SplitPlane moved(SplitPlane split, double offset) const {
    split.offset = static_cast<float>(split.is_general ? offset : offset + center_[split.axis]);
    return split;
  }

  Counts counts_at(double offset) const {
    std::uint32_t below = 0, above = 0, on = 0;
    for (std::size_t i = 0; i < lows_.size(); ++i) {
      const bool is_below = lows_[i]<offset - thickness_, is_above = highs_[i]> offset + thickness_;
      below += is_below;
      above += is_above;
      on += !is_below && !is_above;
    }
    return {share_ * below, share_ * above, share_ * on};
  }

  /// The plane itself, and those parallel to it that touch all from above and below.
  void try_general(const SplitPlane& split, const ConvexCell& cell) {
    measure_cell(split, cell);
    const double offset = split.offset, count = share_ * static_cast<double>(lows_.size());
    if (content_.lo < offset - thickness_ && content_.hi > offset + thickness_)
      consider(split, offset, counts_at(offset));
    consider(split, content_.hi, {count, 0, 0});
    consider(split, content_.lo, {0, count, 0});
  }

  /// All planes at which fragments begin or end.
  void sweep(const SplitPlane& split, const ConvexCell& cell) {
    measure_cell(split, cell);
    flats_.clear();
    for (std::size_t i = 0; i < lows_.size(); ++i) {
      if (highs_[i] - lows_[i] <= 2 * thickness_) flats_.push_back({lows_[i], highs_[i]});
    }
    std::sort(lows_.begin(), lows_.end());
    std::sort(highs_.begin(), highs_.end());
    std::size_t started = 0, ended = 0, low = 0, high = 0;
    while (low < lows_.size() || high < highs_.size()) {
      const bool is_low = low < lows_.size() && lows_[low] <= highs_[high];
      const double offset = is_low ? lows_[low++] : highs_[high++];
      while (started < lows_.size() && lows_[started] < offset - thickness_) ++started;
      while (ended < highs_.size() && highs_[ended] <= offset + thickness_) ++ended;
      double on = 0;
      for (const auto& [lo, hi] : flats_) on += lo >= offset - thickness_ && hi <= offset + thickness_;
      consider(split, offset, {double(started), double(highs_.size() - ended), on});
    }
  }

  /// Planes between bins.
  void try_bins(const SplitPlane& split, const ConvexCell& cell) {
    measure_cell(split, cell);
    std::array<std::uint32_t, most_bins> starts{}, ends{};
    const int bins = effort_.bins;
    const double lowest = content_.lo, size = content_.hi - content_.lo, scale = bins / size;
    for (std::size_t i = 0; i < lows_.size(); ++i) {
      ++starts[clamp_to_index((lows_[i] - lowest) * scale, bins)];
      ++ends[clamp_to_index((highs_[i] - lowest) * scale, bins)];
    }
    double below = 0, above = static_cast<double>(lows_.size());
    for (int bin = 0; bin <= bins; ++bin) {
      const double offset = bin == bins ? content_.hi : lowest + size * bin / bins;
      consider(split, offset, {share_ * below, share_ * above, 0});
      if (bin == bins) break;
      below += starts[bin];
      above -= ends[bin];
    }
  }

  const Primitives& primitives_;
  const Vec3d center_;
  const double thickness_;
  const BspCosts costs_;
  const BspEffort effort_;
  double limit_ = 0, threshold_ = 0, weight_ = 1;
  std::vector<Candidate> candidates_;
  std::vector<double> lows_, highs_;  ///< Of the fragments measured, each for `share_` of all.
  std::vector<Interval<double>> flats_;
  double share_ = 1;
  Interval<double> content_, cell_extent_;  ///< Along the normal measured.
  double section_ = 0;                      ///< The cell's projection along it, as a share of its area.
  std::vector<double> octets_;              ///< Eight x, y and z by turns.
  std::vector<std::size_t> octet_ends_;
};

}  // namespace sightline
