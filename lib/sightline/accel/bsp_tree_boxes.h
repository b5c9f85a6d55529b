#pragma once
/// Dividing by axis planes alone, as a kd-tree does: the way to build the upper part of a BSP tree in little time.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sightline/accel/bsp_tree_nodes.h"
#include "sightline/accel/bsp_tree_search.h"
#include "sightline/accel/primitives.h"
#include "sightline/math/rounding.h"

namespace sightline {

/// Primitives of a cell that is a box, each with bounds of its part in the cell.
///   X1  Bounds contain the part within the cell, and lie within the cell but for flat primitives' roundings.
class BspBoxes {
 public:
  struct Reference {
    Aabb box;
    std::uint32_t id;
  };
  struct Choice {
    SplitPlane split;
    double cost;
  };

  std::vector<Reference> references;

  std::uint32_t size() const { return static_cast<std::uint32_t>(references.size()); }

  /// The cheapest of the planes between `bins` bins along each axis, and of those that touch all from outside.
  std::optional<Choice> best(const Aabb& cell, int bins, double thickness, double limit, const BspCosts& costs) const {
    std::optional<Choice> best;
    double best_cost = limit;
    Aabb content;
    for (const Reference& reference : references) content.extend(reference.box);
    std::array<std::array<std::uint32_t, most_bins>, 3> starts{}, ends{};
    const Vec3f size = content.hi - content.lo;
    const Vec3f scale = static_cast<float>(bins) / size;
    for (const auto& [box, id] : references) {
      for (int axis = 0; axis < 3; ++axis) {
        ++starts[axis][clamp_to_index((box.lo[axis] - content.lo[axis]) * scale[axis], bins)];
        ++ends[axis][clamp_to_index((box.hi[axis] - content.lo[axis]) * scale[axis], bins)];
      }
    }
    // As thick as planes are, so that flat cells have areas to weigh.
    const Vec3d extent = Vec3d(cell.hi) - Vec3d(cell.lo) + thickness;
    for (int axis = 0; axis < 3; ++axis) {
      const double cap = extent[(axis + 1) % 3] * extent[(axis + 2) % 3];
      const double rim = extent[(axis + 1) % 3] + extent[(axis + 2) % 3];
      const double whole = cap + extent[axis] * rim;
      std::uint32_t below = 0, above = this->size();
      for (int bin = 0; bin <= bins; ++bin) {
        const float place =
            bin == bins ? content.hi[axis] : content.lo[axis] + size[axis] * static_cast<float>(bin) / bins;
        if (place > cell.lo[axis] && place < cell.hi[axis]) {
          const double low = cap + (double(place) - cell.lo[axis] + thickness / 2) * rim;
          const double high = cap + (double(cell.hi[axis]) - place + thickness / 2) * rim;
          const double cost = costs.axis_plane + (low * costs.tests(below) + high * costs.tests(above)) / whole;
          if (cost < best_cost) {
            best_cost = cost;
            best = {SplitPlane::across(axis, place), cost};
          }
        }
        if (bin == bins) break;
        below += starts[axis][bin];
        above -= ends[axis][bin];
      }
    }
    return best;
  }

  /// Divides all into those with parts below the plane and those with parts above; flat ones on it go below. Parts are
  /// clipped to cells that are larger by the thickness, as clipping rounds.
  void split(const SplitPlane& split, double thickness, const Primitives& primitives,
             std::array<BspBoxes, 2>& sides) const {
    const int axis = split.axis;
    const float place = split.offset;
    for (BspBoxes& side : sides) side.references.clear();
    for (const Reference& reference : references) {
      const bool is_above = reference.box.hi[axis] > place;
      const bool is_below = reference.box.lo[axis] < place || !is_above;
      if (!is_above || !is_below) {
        sides[is_above].references.push_back(reference);
        continue;
      }
      for (int side = 0; side < 2; ++side) {
        Aabb box = reference.box;
        (side == 0 ? box.hi : box.lo)[axis] = place;
        const Vec3d lo = Vec3d(box.lo) - thickness, hi = Vec3d(box.hi) + thickness;
        const Aabb part =
            intersection(box, primitives.clip(reference.id, {{round_down(lo.x), round_down(lo.y), round_down(lo.z)},
                                                             {round_up(hi.x), round_up(hi.y), round_up(hi.z)}}));
        if (!part.is_empty()) sides[side].references.push_back({part, reference.id});
      }
    }
  }

 private:
  static constexpr int most_bins = 64;
};

}  // namespace sightline
