#pragma once
/// The search for the plane that splits a convex cell best, by the surface area heuristic.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "sightline/accel/fragments.h"
#include "sightline/math/convex_cell.h"
#include "sightline/math/rounding.h"

namespace sightline {

/// A plane as a tree stores it: below is normal . x <= offset.
struct SplitPlane {
  static constexpr int general = 3;

  Vec3f normal{0};
  float offset = 0;
  int axis = general;  ///< Whose unit vector the normal is, or `general`.

  Plane plane() const { return {Vec3d(normal), offset}; }

  static SplitPlane across(int axis, float offset) {
    SplitPlane split{Vec3f(0), offset, axis};
    split.normal[axis] = 1;
    return split;
  }
};

/// Holds the scratch of many searches. Candidates are axis planes at the fragments' bounds, the polygons' own planes
/// and the planes through their edges. Few fragments have all of theirs tried. Of many, bins along the axes are tried,
/// and bins along the normals of a few of them, counted on a bounded sample: a bounded effort a fragment in either
/// case.
class SplitSearch {
 public:
  struct Costs {
    double axis_plane, general_plane, primitive;
  };
  struct Choice {
    SplitPlane split;
    bool keeps_on_below;  ///< On which side polygons belong that lie on the plane: that of less area.
  };

  /// Coordinates are relative to `center`; fragments within `thickness` of a plane lie on it.
  SplitSearch(const Primitives& primitives, const Vec3d& center, double thickness, const Costs& costs,
              bool allow_general)
      : primitives_(primitives), center_(center), thickness_(thickness), costs_(costs), allow_general_(allow_general) {}

  /// None where no plane makes the cell cheaper than testing all it holds.
  std::optional<Choice> best(const ConvexCell& cell, const Fragments& fragments) {
    best_.reset();
    best_cost_ = costs_.primitive * fragments.size();
    if (!(cell.area() > 0)) return best_;
    fragments.size() > exhaustive_size ? try_bins(cell, fragments) : try_all(cell, fragments);
    return best_;
  }

 private:
  static constexpr std::uint32_t exhaustive_size = 48;   ///< So many fragments still have all their planes tried.
  static constexpr std::uint32_t sampled_normals = 8;    ///< Fragments whose normals are tried above that.
  static constexpr std::uint32_t sampled_counts = 2048;  ///< Fragments counted, at least, for a general plane.
  static constexpr int bin_count = 32;

  struct Counts {
    double below = 0, above = 0, on = 0;  ///< Those that cross count below and above.
  };

  /// The plane as stored; none for axis planes, which the fragments' bounds offer, and for what float cannot hold.
  std::optional<SplitPlane> stored(const Plane& plane) const {
    const double length = glm::length(plane.normal);
    const Vec3f normal(plane.normal / length);
    const auto offset = static_cast<float>((plane.offset - glm::dot(plane.normal, center_)) / length);
    if (!is_finite(normal) || !std::isfinite(offset)) return std::nullopt;
    if ((normal.x == 0) + (normal.y == 0) + (normal.z == 0) >= 2) return std::nullopt;
    return SplitPlane{normal, offset, SplitPlane::general};
  }

  double plane_cost(const SplitPlane& split) const {
    return split.axis == SplitPlane::general ? costs_.general_plane : costs_.axis_plane;
  }

  /// A lower bound of the cost before any area is computed. With the plane at the share x of the cell's extent along
  /// its normal, the part below contains the cell shrunk by x about its lowest point, so its area is at least x^2 of
  /// the whole; likewise (1 - x)^2 above; and both together are at least the whole.
  double least_cost(const SplitPlane& split, double x, double below, double above) const {
    const double y = 1 - x;
    return plane_cost(split) + costs_.primitive * (x * x * below + y * y * above + 2 * x * y * std::min(below, above));
  }

  /// `lowest` and `highest` are the cell's heights over the plane.
  void weigh(const SplitPlane& split, const ConvexCell& cell, double lowest, double highest, const Counts& counts) {
    if (!(lowest < 0 && highest > 0)) return;
    if (least_cost(split, -lowest / (highest - lowest), counts.below, counts.above) >= best_cost_) return;
    ConvexCell::Heights heights;
    cell.measure(split.plane(), heights);
    const ConvexCell::Areas areas = cell.areas(heights);
    const double tests =
        areas.below * counts.below + areas.above * counts.above + std::min(areas.below, areas.above) * counts.on;
    const double cost = plane_cost(split) + costs_.primitive * tests / cell.area();
    if (!(cost < best_cost_)) return;
    best_cost_ = cost;
    best_ = Choice{split, areas.below <= areas.above};
  }

  // Many fragments: bins.

  void try_bins(const ConvexCell& cell, const Fragments& fragments) {
    for (int axis = 0; axis < 3; ++axis) try_normal(SplitPlane::across(axis, 0), cell, fragments, 1);
    if (!allow_general_) return;
    const std::uint32_t step = std::max(1u, fragments.size() / sampled_counts);
    for (std::uint64_t sample = 0; sample < sampled_normals; ++sample) {
      const std::uint64_t i = (2 * sample + 1) * fragments.size() / (2 * sampled_normals);
      for (const Plane& plane : primitives_.planes(fragments[static_cast<std::uint32_t>(i)].id)) {
        if (const auto split = stored(plane)) try_normal(*split, cell, fragments, step);
      }
    }
  }

  /// Planes parallel to the split, between bins; a general plane itself, too. Every step-th fragment is counted.
  void try_normal(const SplitPlane& split, const ConvexCell& cell, const Fragments& fragments, std::uint32_t step) {
    const Vec3d normal(split.normal);
    extents_.clear();
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (std::uint32_t i = 0; i < fragments.size(); i += step) {
      const Interval<double> extent = extent_of(fragments.points(fragments[i]), normal);
      extents_.push_back(extent);
      lowest = std::min(lowest, extent.lo);
      highest = std::max(highest, extent.hi);
    }
    const double weight = static_cast<double>(fragments.size()) / static_cast<double>(extents_.size());
    const Interval<double> cell_extent = cell.extent(normal);
    if (split.axis == SplitPlane::general) {
      const double offset = split.offset;
      std::uint32_t below = 0, above = 0, on = 0;
      for (const auto& [lo, hi] : extents_) {
        below += lo < offset - thickness_;
        above += hi > offset + thickness_;
        on += !(lo < offset - thickness_) && !(hi > offset + thickness_);
      }
      weigh(split, cell, cell_extent.lo - offset, cell_extent.hi - offset,
            {weight * below, weight * above, weight * on});
    }
    std::array<std::uint32_t, bin_count> starts{}, ends{};
    const double scale = bin_count / (highest - lowest);
    for (const auto& [lo, hi] : extents_) {
      ++starts[clamp_to_index((lo - lowest) * scale, bin_count)];
      ++ends[clamp_to_index((hi - lowest) * scale, bin_count)];
    }
    double below = 0, above = static_cast<double>(extents_.size());
    for (int bin = 0; bin <= bin_count; ++bin) {
      const double offset = bin == bin_count ? highest : lowest + (highest - lowest) * bin / bin_count;
      SplitPlane parallel = split;
      parallel.offset = static_cast<float>(offset);
      weigh(parallel, cell, cell_extent.lo - offset, cell_extent.hi - offset, {weight * below, weight * above, 0});
      if (bin == bin_count) break;
      below += starts[bin];
      above -= ends[bin];
    }
  }

  static Interval<double> extent_of(std::span<const Vec3d> points, const Vec3d& normal) {
    Interval<double> extent;
    for (const Vec3d& p : points) {
      const double height = glm::dot(normal, p);
      extent.lo = height < extent.lo ? height : extent.lo;
      extent.hi = height > extent.hi ? height : extent.hi;
    }
    return extent;
  }

  // Few fragments: every candidate.

  /// Corners transposed, eight fragments side by side, so that one plane meets eight at a time.
  struct Octet {
    std::array<double, 8> x, y, z;
  };

  void try_all(const ConvexCell& cell, const Fragments& fragments) {
    pack(fragments);
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3d normal(SplitPlane::across(axis, 0).normal);
      offsets_.clear();
      for (std::uint32_t i = 0; i < fragments.size(); ++i) {
        const Interval<double> extent = extent_of(fragments.points(fragments[i]), normal);
        offsets_.push_back(static_cast<float>(extent.lo));
        offsets_.push_back(static_cast<float>(extent.hi));
      }
      std::sort(offsets_.begin(), offsets_.end());
      offsets_.erase(std::unique(offsets_.begin(), offsets_.end()), offsets_.end());
      for (const float offset : offsets_) try_plane(SplitPlane::across(axis, offset), cell);
    }
    if (!allow_general_) return;
    for (std::uint32_t i = 0; i < fragments.size(); ++i) {
      for (const Plane& plane : primitives_.planes(fragments[i].id)) {
        const auto split = stored(plane);
        if (!split) continue;
        const auto [lo, hi] = extent_of(fragments.points(fragments[i]), Vec3d(split->normal));
        const bool is_clipped_away = lo > split->offset + thickness_ || hi < split->offset - thickness_;
        if (!is_clipped_away) try_plane(*split, cell);
      }
    }
  }

  void pack(const Fragments& fragments) {
    octets_.clear();
    octet_ends_.clear();
    packed_count_ = fragments.size();
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

  void try_plane(const SplitPlane& split, const ConvexCell& cell) {
    const Plane plane = split.plane();
    const Interval<double> cell_extent = cell.extent(plane.normal);
    const double lowest = cell_extent.lo - plane.offset, highest = cell_extent.hi - plane.offset;
    if (!(lowest < 0 && highest > 0)) return;
    const double share = -lowest / (highest - lowest);
    std::uint32_t below = 0, above = 0, decided = 0;
    std::size_t octet = 0;
    for (std::size_t group = 0; group < octet_ends_.size(); ++group) {
      std::array<double, 8> lows, highs;
      lows.fill(std::numeric_limits<double>::infinity());
      highs.fill(-std::numeric_limits<double>::infinity());
      for (; octet < octet_ends_[group]; ++octet) {
        const auto& [x, y, z] = octets_[octet];
        for (int lane = 0; lane < 8; ++lane) {
          const double height =
              plane.normal.x * x[lane] + plane.normal.y * y[lane] + plane.normal.z * z[lane] - plane.offset;
          lows[lane] = height < lows[lane] ? height : lows[lane];
          highs[lane] = height > highs[lane] ? height : highs[lane];
        }
      }
      const std::uint32_t lanes = std::min<std::uint32_t>(8, packed_count_ - static_cast<std::uint32_t>(group) * 8);
      for (std::uint32_t lane = 0; lane < lanes; ++lane) {
        const bool is_below = lows[lane]<-thickness_, is_above = highs[lane]> thickness_;
        below += is_below;
        above += is_above;
        decided += is_below || is_above;
      }
      if (least_cost(split, share, below, above) >= best_cost_) return;
    }
    weigh(split, cell, lowest, highest, {double(below), double(above), double(packed_count_ - decided)});
  }

  const Primitives& primitives_;
  Vec3d center_;
  double thickness_;
  Costs costs_;
  bool allow_general_;
  std::optional<Choice> best_;
  double best_cost_ = 0;
  std::vector<Interval<double>> extents_;
  std::vector<float> offsets_;
  std::vector<Octet> octets_;
  std::vector<std::size_t> octet_ends_;
  std::uint32_t packed_count_ = 0;
};

}  // namespace sightline
