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

  /// None where no plane makes the cell cheaper than `limit`. The fragments stand for `weight` times as many.
  std::optional<Choice> best(const ConvexCell& cell, const Fragments& fragments, double limit, bool allow_general,
                             double weight = 1) {
    limit_ = limit;
    weight_ = weight;
    candidates_.clear();
    if (!(cell.area() > 0)) return std::nullopt;
    const bool is_exhaustive = fragments.size() <= effort_.exhaustive_size;
    for (int axis = 0; axis < 3; ++axis) {
      const SplitPlane split = SplitPlane::across(axis, 0);
      measure_each(split, fragments, 1);
      is_exhaustive ? sweep(split, cell) : try_bins(split, cell);
    }
    if (!allow_general) return best_of_candidates(cell);
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
    return best_of_candidates(cell);
  }

 private:
  static constexpr std::uint32_t sampled_counts = 2048;  ///< Fragments counted, at least, for a general plane.
  static constexpr int most_bins = 64;

  struct Counts {
    double below = 0, above = 0, on = 0;  ///< Those that cross count below and above.
  };
  struct Candidate {
    double estimate;  ///< Of the cost.
    SplitPlane split;
    Counts counts;
  };

  /// Takes the plane for a candidate, with an estimate of its cost. With the plane at the share x of the cell's extent,
  /// some x of the surface lies below, and the section is as large as the cell's projection along the normal where the
  /// cell is a prism, and 4 x (1 - x) of that where it is a ball; the estimate lies between.
  void consider(const SplitPlane& split, const Counts& counts) {
    const double offset = split.plane(center_).offset;
    const double lowest = cell_extent_.lo - offset, highest = cell_extent_.hi - offset;
    if (!(lowest < 0 && highest > 0)) return;
    const Counts all{weight_ * counts.below, weight_ * counts.above, weight_ * counts.on};
    const double x = -lowest / (highest - lowest), section = section_ * std::sqrt(4 * x * (1 - x));
    const double estimate = costs_.plane(split) + std::min(1.0, x + section) * costs_.tests(all.below) +
                            std::min(1.0, 1 - x + section) * costs_.tests(all.above);
    if (estimate < 1.5 * limit_) candidates_.push_back({estimate, split, all});
  }

  /// Areas are what takes time, so that they are computed for the most promising candidates only.
  std::optional<Choice> best_of_candidates(const ConvexCell& cell) {
    std::optional<Choice> best;
    double best_cost = limit_;
    const auto last = candidates_.begin() + std::min(std::ssize(candidates_), effort_.exact_costs);
    std::nth_element(candidates_.begin(), last, candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.estimate < b.estimate; });
    for (auto candidate = candidates_.begin(); candidate != last; ++candidate) {
      const auto& [estimate, split, counts] = *candidate;
      ConvexCell::Heights heights;
      cell.measure(split.plane(center_), heights);
      const ConvexCell::Areas areas = cell.areas(heights);
      const bool on_below = areas.below <= areas.above;
      const double tests = areas.below * costs_.tests(counts.below + (on_below ? counts.on : 0)) +
                           areas.above * costs_.tests(counts.above + (on_below ? 0 : counts.on));
      const double cost = costs_.plane(split) + tests / cell.area();
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

  static Interval<double> extent_of(std::span<const Vec3d> points, const Vec3d& normal) {
    Interval<double> extent;
    for (const Vec3d& p : points) {
      const double height = glm::dot(normal, p);
      extent.lo = height < extent.lo ? height : extent.lo;
      extent.hi = height > extent.hi ? height : extent.hi;
    }
    return extent;
  }

  /// Of every step-th fragment.
  void measure_each(const SplitPlane& split, const Fragments& fragments, std::uint32_t step) {
    const Vec3d normal(split.normal);
    lows_.clear();
    highs_.clear();
    for (std::uint32_t i = 0; i < fragments.size(); i += step) {
      const Interval<double> extent = extent_of(fragments.points(fragments[i]), normal);
      lows_.push_back(extent.lo);
      highs_.push_back(extent.hi);
    }
    share_ = static_cast<double>(fragments.size()) / static_cast<double>(lows_.size());
    finish_measuring(lows_.size());
  }

  /// Corners transposed, eight fragments side by side, so that one plane meets eight at a time.
  struct Octet {
    std::array<double, 8> x, y, z;
  };

  void pack(const Fragments& fragments) {
    octets_.clear();
    octet_ends_.clear();
    for (std::uint32_t first = 0; first < fragments.size(); first += 8) {
      const std::uint32_t lanes = std::min(8u, fragments.size() - first);
      std::size_t most = 0;
      for (std::uint32_t lane = 0; lane < lanes; ++lane) {
        most = std::max(most, fragments.points(fragments[first + lane]).size());
      }
      for (std::size_t corner = 0; corner < most; ++corner) {
        Octet& octet = octets_.emplace_back();
        for (std::uint32_t lane = 0; lane < 8; ++lane) {
          // Lanes without a fragment repeat the first; they are not counted.
          const auto points = fragments.points(fragments[first + (lane < lanes ? lane : 0)]);
          const Vec3d& p = points[std::min(corner, points.size() - 1)];
          octet.x[lane] = p.x;
          octet.y[lane] = p.y;
          octet.z[lane] = p.z;
        }
      }
      octet_ends_.push_back(octets_.size());
    }
  }

  void measure_packed(const SplitPlane& split, std::uint32_t count) {
    const Vec3d normal(split.normal);
    lows_.resize(8 * octet_ends_.size());
    highs_.resize(lows_.size());
    std::size_t octet = 0;
    for (std::size_t group = 0; group < octet_ends_.size(); ++group) {
      std::array<double, 8> lows, highs;
      lows.fill(std::numeric_limits<double>::infinity());
      highs.fill(-std::numeric_limits<double>::infinity());
      for (; octet < octet_ends_[group]; ++octet) {
        const auto& [x, y, z] = octets_[octet];
        for (int lane = 0; lane < 8; ++lane) {
          const double height = normal.x * x[lane] + normal.y * y[lane] + normal.z * z[lane];
          lows[lane] = height < lows[lane] ? height : lows[lane];
          highs[lane] = height > highs[lane] ? height : highs[lane];
        }
      }
      std::copy(lows.begin(), lows.end(), lows_.begin() + 8 * group);
      std::copy(highs.begin(), highs.end(), highs_.begin() + 8 * group);
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
    if (content_.lo < offset - thickness_ && content_.hi > offset + thickness_) consider(split, counts_at(offset));
    consider(moved(split, content_.hi), {count, 0, 0});
    consider(moved(split, content_.lo), {0, count, 0});
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
      consider(moved(split, offset), {double(started), double(highs_.size() - ended), on});
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
      consider(moved(split, offset), {share_ * below, share_ * above, 0});
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
  double limit_ = 0, weight_ = 1;
  std::vector<Candidate> candidates_;
  std::vector<double> lows_, highs_;  ///< Of the fragments measured, each for `share_` of all.
  std::vector<Interval<double>> flats_;
  double share_ = 1;
  Interval<double> content_, cell_extent_;  ///< Along the normal measured.
  double section_ = 0;                      ///< The cell's projection along it, as a share of its area.
  std::vector<Octet> octets_;
  std::vector<std::size_t> octet_ends_;
};

}  // namespace sightline
