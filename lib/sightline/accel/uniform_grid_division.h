#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <deque>
#include <numeric>
#include <span>
#include <vector>

#include "sightline/accel/options.h"
#include "sightline/accel/primitives.h"
#include "sightline/accel/uniform_grid_cells.h"
#include "sightline/accel/uniform_grid_overlap.h"

namespace sightline {

struct UniformGridOptions {
  float density = 0.1f;  ///< Cells of the top level wanted for each primitive.
  int max_copies = 16;   ///< Leaves that hold a primitive, on average; cells that need more are not divided.
  Quality quality = Quality::balanced;  ///< `best` is as `balanced`: cells hold no more than meets them.

  static constexpr std::array<OptionField<UniformGridOptions>, 3> fields() {
    return {{{"density", &UniformGridOptions::density, 0x1p-10, 64, "cells of the top level wanted for each primitive"},
             {"max_copies", &UniformGridOptions::max_copies, 1, 1024,
              "most leaves that hold a primitive, on average; cells that need more are not divided"},
             {"quality", &UniformGridOptions::quality, 0, 2,
              "fast: a cell holds what has bounds that meet it; balanced and best: what meets it itself"}}};
  }
};

/// What some cells of the top level became; numbers count from the beginning of each list.
struct DividedCells {
  std::vector<GridCell> cells;
  std::vector<GridBlock> blocks;
  std::vector<std::uint32_t> order;
};

/// Finds the cells that primitives meet and divides those that hold many. Coordinates are relative to the grid's
/// origin; cells count as enlarged by `reach` on every side (G2).
class GridDivider {
 public:
  GridDivider(const Primitives& primitives, Quality quality, const Vec3d& origin, double reach)
      : primitives_(primitives), quality_(quality), origin_(origin), reach_(reach) {}

  /// Calls see(place) for every cell of the top level that the primitive meets.
  template <class See>
  void for_each_cell(std::uint32_t id, const Vec3d& size, const std::array<int, 3>& counts, See&& see) const {
    const Layers met = layers_met(primitives_.bounds(id), Lattice(Vec3d(0), size, counts));
    if (met.first == met.last) return see(met.first);
    std::array<int, 3> tile, rest;
    for (tile[2] = met.first[2]; tile[2] <= met.last[2]; tile[2] += GridBlock::side) {
      for (tile[1] = met.first[1]; tile[1] <= met.last[1]; tile[1] += GridBlock::side) {
        for (tile[0] = met.first[0]; tile[0] <= met.last[0]; tile[0] += GridBlock::side) {
          for (int i = 0; i < 3; ++i) rest[i] = std::min(met.last[i] - tile[i] + 1, GridBlock::side);
          for_each_bit(cells_met(id, Lattice(Vec3d(tile[0], tile[1], tile[2]) * size, size, rest)), [&](int bit) {
            const std::array<int, 3> local = GridBlock::place_of(bit);
            see(std::array<int, 3>{tile[0] + local[0], tile[1] + local[1], tile[2] + local[2]});
          });
        }
      }
    }
  }

  /// Divides the cell with the corner `lo`, which holds `ids`, where that pays, into no more than `budget` references.
  GridCell divide(std::span<const std::uint32_t> ids, const Vec3d& lo, const Vec3d& size, std::uint64_t budget,
                  DividedCells& out, int depth = 0) {
    if (ids.size() < least_divided || depth == max_depth) return leaf_of(ids, out);
    if (levels_.size() == static_cast<std::size_t>(depth)) levels_.emplace_back();
    Level& level = levels_[static_cast<std::size_t>(depth)];

    std::array<int, 3> shifts;
    for (int axis = 0; axis < 3; ++axis) {
      shifts[axis] = size[axis] >= 4 * thinnest * reach_ ? 2 : size[axis] >= 2 * thinnest * reach_ ? 1 : 0;
    }
    const Lattice finest = lattice_of(lo, size, shifts);
    level.met.resize(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) level.met[i] = cells_met(ids[i], finest);

    // As finely as can be, or half as finely; what costs least, if less than a leaf.
    float least_cost = leaf_cost(static_cast<std::uint32_t>(ids.size()));
    std::array<int, 3> chosen{0, 0, 0};
    for (const bool is_folded : {false, true}) {
      if (is_folded) fold(level.met, shifts);
      if (shifts == std::array<int, 3>{0, 0, 0}) break;
      count(level);
      // Parts of which each still holds half of all bring nothing but copies: primitives that lie upon one another.
      if (level.total > budget || 2 * level.total > level.occupied() * ids.size()) continue;
      const float cost = cost_of(level, size, lattice_of(lo, size, shifts).size);
      if (cost >= least_cost) continue;
      least_cost = cost;
      chosen = shifts;
      level.chosen = level.met;
      level.chosen_counts = level.counts;
    }
    if (chosen == std::array<int, 3>{0, 0, 0}) return leaf_of(ids, out);
    return block_of(ids, lattice_of(lo, size, chosen), chosen, budget, out, depth);
  }

 private:
  static constexpr std::size_t least_divided = 3;  ///< Primitives of a cell.
  static constexpr int max_depth = 6;
  static constexpr double thinnest = 8;  ///< Thickness of a layer, in units of the reach: below, all would be copies.

  /// Costs are relative to one step from cell to cell.
  static constexpr float leaf_visit_cost = 1, triangle_block_cost = 2, block_entry_cost = 3;
  static float leaf_cost(std::uint32_t primitives) {
    return primitives == 0 ? 0 : leaf_visit_cost + triangle_block_cost * static_cast<float>((primitives + 7) / 8);
  }

  /// Equal cells in rows, at most `counts` along each axis.
  struct Lattice {
    Vec3d lo, size, inverse;
    std::array<int, 3> counts;
    Lattice(const Vec3d& first, const Vec3d& of_each, const std::array<int, 3>& how_many)
        : lo(first), size(of_each), inverse(1.0 / of_each), counts(how_many) {}
  };
  struct Layers {
    std::array<int, 3> first, last;
  };
  /// Scratch of dividing a cell. Masks have the bits of the cells that a primitive meets.
  struct Level {
    std::vector<std::uint64_t> met, chosen;
    std::array<std::uint32_t, 64> counts, chosen_counts;  ///< Of the primitives that meet each cell.
    std::uint64_t total;
    std::vector<std::uint32_t> ids;

    std::uint64_t occupied() const {
      return 64 - static_cast<std::uint64_t>(std::count(counts.begin(), counts.end(), 0u));
    }
  };

  template <class See>
  static void for_each_bit(std::uint64_t bits, See&& see) {
    for (; bits != 0; bits &= bits - 1) see(std::countr_zero(bits));
  }

  static Lattice lattice_of(const Vec3d& lo, const Vec3d& size, const std::array<int, 3>& shifts) {
    Vec3d part;
    for (int axis = 0; axis < 3; ++axis) part[axis] = size[axis] / (1 << shifts[axis]);
    return {lo, part, {1 << shifts[0], 1 << shifts[1], 1 << shifts[2]}};
  }

  static void count(Level& level) {
    level.counts.fill(0);
    for (const std::uint64_t met : level.met) for_each_bit(met, [&](int bit) { ++level.counts[bit]; });
    level.total = std::accumulate(level.counts.begin(), level.counts.end(), std::uint64_t(0));
  }

  /// Of a ray that crosses the cell: it meets a part with the probability that their surfaces tell.
  static float cost_of(const Level& level, const Vec3d& size, const Vec3d& part) {
    const auto half_area = [](const Vec3d& e) { return e.x * e.y + e.y * e.z + e.z * e.x; };
    float cost = static_cast<float>(std::round(size.x / part.x * (size.y / part.y) * (size.z / part.z)));
    for (const std::uint32_t n : level.counts) cost += leaf_cost(n);
    return block_entry_cost + static_cast<float>(half_area(part) / half_area(size)) * cost;
  }

  static GridCell leaf_of(std::span<const std::uint32_t> ids, DividedCells& out) {
    const auto first = static_cast<std::uint32_t>(out.order.size());
    out.order.insert(out.order.end(), ids.begin(), ids.end());
    return {first, static_cast<std::uint32_t>(ids.size())};
  }

  /// Counting sort into the cells of the lattice as `chosen`, each of which is divided in turn.
  GridCell block_of(std::span<const std::uint32_t> ids, const Lattice& lattice, const std::array<int, 3>& shifts,
                    std::uint64_t budget, DividedCells& out, int depth) {
    Level& level = levels_[static_cast<std::size_t>(depth)];
    const std::array<std::uint32_t, 64> counts = level.chosen_counts;
    std::array<std::uint32_t, 64> ends;
    std::partial_sum(counts.begin(), counts.end(), ends.begin());
    GridBlock block;
    for (int axis = 0; axis < 3; ++axis) block.shifts[axis] = static_cast<std::uint8_t>(shifts[axis]);
    block.first_cell = static_cast<std::uint32_t>(out.cells.size());
    level.ids.resize(ends.back());
    std::array<std::uint32_t, 64> at;
    for (int bit = 0; bit < 64; ++bit) at[bit] = ends[bit] - counts[bit];
    for (std::size_t i = 0; i < ids.size(); ++i) {
      block.occupied |= level.chosen[i];
      for_each_bit(level.chosen[i], [&](int bit) { level.ids[at[bit]++] = ids[i]; });
    }
    const auto number = static_cast<std::uint32_t>(out.blocks.size());
    out.blocks.push_back(block);
    out.cells.resize(out.cells.size() + static_cast<std::size_t>(std::popcount(block.occupied)));
    for_each_bit(block.occupied, [&](int bit) {
      const std::array<int, 3> place = GridBlock::place_of(bit);
      const GridCell cell = divide({level.ids.data() + ends[bit] - counts[bit], counts[bit]},
                                   lattice.lo + lattice.size * Vec3d(place[0], place[1], place[2]), lattice.size,
                                   budget * counts[bit] / ends.back(), out, depth + 1);
      out.cells[block.cell_at(bit)] = cell;
    });
    return GridCell::divided_by(number);
  }

  /// Joins layers in pairs.
  static void fold(std::vector<std::uint64_t>& masks, std::array<int, 3>& shifts) {
    constexpr std::uint64_t lowest[3] = {0x1111'1111'1111'1111, 0x000f'000f'000f'000f, 0xffff};  // layer 0 of each axis
    for (int axis = 0; axis < 3; ++axis) {
      const int stride = 1 << 2 * axis;
      for (std::uint64_t& met : masks) {
        const std::uint64_t pairs = met | met >> stride;
        met = (pairs & lowest[axis]) | ((pairs >> stride) & (lowest[axis] << stride));
      }
      shifts[axis] = std::max(0, shifts[axis] - 1);
    }
  }

  /// The layers that a box meets.
  Layers layers_met(const Aabb& box, const Lattice& lattice) const {
    Layers met;
    for (int axis = 0; axis < 3; ++axis) {
      const double lo = box.lo[axis] - origin_[axis] - lattice.lo[axis],
                   hi = box.hi[axis] - origin_[axis] - lattice.lo[axis];
      met.first[axis] = clamp_to_index((lo - reach_) * lattice.inverse[axis], lattice.counts[axis]);
      met.last[axis] = clamp_to_index((hi + reach_) * lattice.inverse[axis], lattice.counts[axis]);
    }
    return met;
  }

  static std::uint64_t cells_of(const Layers& layers) {
    const auto along = [&](int axis) { return (2u << layers.last[axis]) - (1u << layers.first[axis]); };
    const std::uint64_t row = along(0), plane = row * spread(along(1), 4);
    return plane * spread(along(2), 16);
  }
  /// The lowest four bits, `stride` apart.
  static std::uint64_t spread(std::uint64_t bits, int stride) {
    return (bits & 1) | (bits & 2) << (stride - 1) | (bits & 4) << 2 * (stride - 1) | (bits & 8) << 3 * (stride - 1);
  }

  static Aabb bounds_of(const Hull& polygon) {
    Aabb box;
    for (const Vec3f& p : polygon.points) box.extend(p);
    return box;
  }

  /// The cells that a primitive meets, which meets the lattice.
  std::uint64_t cells_met(std::uint32_t id, const Lattice& lattice) const {
    if (quality_ == Quality::fast) return cells_of(layers_met(primitives_.bounds(id), lattice));
    const Hull hull = primitives_.hull(id);
    const Layers layers = layers_met(hull.is_polygon ? bounds_of(hull) : primitives_.bounds(id), lattice);
    std::uint64_t met = cells_of(layers);
    if (layers.first == layers.last) return met;
    if (hull.is_polygon) return met & PolygonOverlap(hull, origin_ + lattice.lo, lattice.size, reach_).boxes_met();
    for_each_bit(met, [&](int bit) {
      const std::array<int, 3> place = GridBlock::place_of(bit);
      const Vec3d lo = origin_ + lattice.lo + lattice.size * Vec3d(place[0], place[1], place[2]) - reach_;
      const Vec3d hi = lo + lattice.size + 2 * reach_;
      const Aabb box{{round_down(lo.x), round_down(lo.y), round_down(lo.z)},
                     {round_up(hi.x), round_up(hi.y), round_up(hi.z)}};
      if (primitives_.clip(id, box).is_empty()) met &= ~(std::uint64_t(1) << bit);
    });
    return met;
  }

  const Primitives& primitives_;
  Quality quality_;
  Vec3d origin_;
  double reach_;
  std::deque<Level> levels_;  ///< By depth; their addresses stay as more are added.
};

}  // namespace sightline
