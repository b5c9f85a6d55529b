#pragma once

#include <array>
#include <bit>
#include <cstdlib>
#include <deque>
#include <limits>
#include <span>
#include <vector>

#include "sightline/accel/options.h"
#include "sightline/accel/primitives.h"
#include "sightline/accel/uniform_grid_cells.h"
#include "sightline/accel/uniform_grid_overlap.h"

namespace sightline {

inline float envf(const char* n, float d) { const char* s = getenv(n); return s ? atof(s) : d; }

struct UniformGridOptions {
  float density = 0.0625f;  ///< Cells of the top level wanted for each primitive.
  int max_copies = 128;  ///< Leaves that hold a primitive, on average; cells that would need more are not divided.
  Quality quality = Quality::balanced;

  static constexpr std::array<OptionField<UniformGridOptions>, 3> fields() {
    return {{{"density", &UniformGridOptions::density, 0x1p-10, 64, "cells of the top level wanted for each primitive"},
             {"max_copies", &UniformGridOptions::max_copies, 1, 1024,
              "most leaves that hold a primitive, on average; cells that would need more are not divided"},
             {"quality", &UniformGridOptions::quality, 0, 2, "fast: cells hold what their bounds meet"}}};
  }
};

/// What some cells of the top level became; numbers count from the beginning of each list.
struct DividedCells {
  std::vector<GridCell> cells;
  std::vector<GridBlock> blocks;
  std::vector<std::uint32_t> order;
};

/// Divides cells. Coordinates are relative to the grid's origin; cells count as enlarged by `reach` on every side.
class GridDivider {
 public:
  GridDivider(const Primitives& primitives, Quality quality, const Vec3d& origin, double reach)
      : primitives_(primitives), quality_(quality), origin_(origin), reach_(reach) {}

  /// Calls see(place) for every cell of the top level that the primitive meets.
  template <class See>
  void for_each_cell(std::uint32_t id, const Vec3d& size, const std::array<int, 3>& counts, See&& see) const {
    const auto [first, last] = layers_met(id, Vec3d(0), size, counts);
    std::array<int, 3> tile;
    for (tile[2] = first[2]; tile[2] <= last[2]; tile[2] += GridBlock::side) {
      for (tile[1] = first[1]; tile[1] <= last[1]; tile[1] += GridBlock::side) {
        for (tile[0] = first[0]; tile[0] <= last[0]; tile[0] += GridBlock::side) {
          const Vec3d lo = Vec3d(tile[0], tile[1], tile[2]) * size;
          std::array<int, 3> rest;
          for (int axis = 0; axis < 3; ++axis) rest[axis] = std::min(last[axis] - tile[axis] + 1, GridBlock::side);
          for (std::uint64_t met = cells_met(id, lo, size, rest); met != 0; met &= met - 1) {
            const int bit = std::countr_zero(met);
            see(std::array<int, 3>{tile[0] + bit % 4, tile[1] + bit / 4 % 4, tile[2] + bit / 16});
          }
        }
      }
    }
  }

  /// The cell with the corner `lo`, which holds `ids`, as a leaf or divided, with no more than `budget` references.
  GridCell divide(std::span<const std::uint32_t> ids, const Vec3d& lo, const Vec3d& size, std::uint64_t budget,
                  DividedCells& out, int depth = 0) {
    const auto as_leaf = [&]() -> GridCell {
      const auto first = static_cast<std::uint32_t>(out.order.size());
      out.order.insert(out.order.end(), ids.begin(), ids.end());
      return {first, static_cast<std::uint32_t>(ids.size())};
    };
    if (ids.size() <= 2 || depth == max_depth) return as_leaf();
    if (levels_.size() <= static_cast<std::size_t>(depth)) levels_.emplace_back();
    Level& level = levels_[depth];

    std::array<int, 3> shifts;
    Vec3d finest = size;
    for (int axis = 0; axis < 3; ++axis) {
      shifts[axis] = size[axis] >= 4 * thinnest * reach_ ? 2 : size[axis] >= 2 * thinnest * reach_ ? 1 : 0;
      finest[axis] = std::ldexp(size[axis], -shifts[axis]);
    }
    level.met.resize(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      level.met[i] = cells_met(ids[i], lo, finest, {1 << shifts[0], 1 << shifts[1], 1 << shifts[2]});
    }

    static const float CB = envf("CB", 2), CV = envf("CV", 1), CS = envf("CS", 1), CE = envf("CE", 3);
    const auto leaf_cost = [&](std::uint32_t n) { return n == 0 ? 0.f : CV + CB * float((n + 7) / 8); };
    // Choose among dividing as finely as can be, half as finely, or not at all.
    float best_cost = leaf_cost(ids.size());
    int best = -1;
    std::array<std::uint32_t, 64> counts;
    for (int coarser = 0; coarser < 2; ++coarser) {
      const auto [wide, x, y, z] = coarsened(shifts, coarser);
      if (x + y + z == 0) break;
      counts.fill(0);
      std::uint64_t total = 0;
      for (const std::uint64_t met : level.met) {
        const std::uint64_t folded = coarser ? fold(met, shifts) : met;
        total += std::popcount(folded);
        for (std::uint64_t rest = folded; rest != 0; rest &= rest - 1) ++counts[std::countr_zero(rest)];
      }
      int occupied = 0;
      float cost = 0;
      for (const std::uint32_t n : counts) occupied += n != 0, cost += leaf_cost(n);
      if (total > budget || 2 * total > occupied * ids.size()) continue;
      const Vec3d part(std::ldexp(size.x, -x), std::ldexp(size.y, -y), std::ldexp(size.z, -z));
      const float share = area(part) / area(size);
      cost = CE + share * (cost + CS * float(1 << (x + y + z)));
      if (cost < best_cost) best_cost = cost, best = coarser;
    }
    if (best < 0) return as_leaf();

    if (best == 1) {
      for (std::uint64_t& met : level.met) met = fold(met, shifts);
      for (int& s : shifts) s = std::max(0, s - 1);
    }
    counts.fill(0);
    std::uint64_t occupied = 0, total = 0;
    for (const std::uint64_t met : level.met) {
      occupied |= met;
      for (std::uint64_t rest = met; rest != 0; rest &= rest - 1) ++counts[std::countr_zero(rest)];
    }
    std::array<std::uint32_t, 65> starts{};
    for (int bit = 0; bit < 64; ++bit) starts[bit + 1] = starts[bit] + counts[bit];
    total = starts[64];
    level.ids.resize(total);
    {
      auto at = starts;
      for (std::size_t i = 0; i < ids.size(); ++i) {
        for (std::uint64_t rest = level.met[i]; rest != 0; rest &= rest - 1) level.ids[at[std::countr_zero(rest)]++] = ids[i];
      }
    }
    const auto block = static_cast<std::uint32_t>(out.blocks.size());
    auto cell = static_cast<std::uint32_t>(out.cells.size());
    GridBlock made{occupied, cell, {}};
    for (int axis = 0; axis < 3; ++axis) made.shifts[axis] = static_cast<std::uint8_t>(shifts[axis]);
    out.blocks.push_back(made);
    out.cells.resize(out.cells.size() + std::popcount(occupied));
    Vec3d part;
    for (int axis = 0; axis < 3; ++axis) part[axis] = std::ldexp(size[axis], -shifts[axis]);
    for (std::uint64_t rest = occupied; rest != 0; rest &= rest - 1, ++cell) {
      const int bit = std::countr_zero(rest);
      const Vec3d corner = lo + part * Vec3d(bit % 4, bit / 4 % 4, bit / 16);
      const GridCell child = divide({level.ids.data() + starts[bit], counts[bit]}, corner, part,
                                    budget * counts[bit] / total, out, depth + 1);
      out.cells[cell] = child;
    }
    return GridCell::divided_by(block);
  }

 private:
  static constexpr int max_depth = 6;
  static constexpr double thinnest = 8;
  struct Level {
    std::vector<std::uint64_t> met;
    std::vector<std::uint32_t> ids;
  };
  struct Coarse { int wide, x, y, z; };

  static Coarse coarsened(const std::array<int, 3>& shifts, int coarser) {
    return {0, std::max(0, shifts[0] - coarser), std::max(0, shifts[1] - coarser), std::max(0, shifts[2] - coarser)};
  }

  static double area(const Vec3d& size) { return size.x * size.y + size.y * size.z + size.z * size.x; }

  /// The mask of a division half as fine.
  static std::uint64_t fold(std::uint64_t met, const std::array<int, 3>& shifts) {
    if (shifts[0] == 2) met = fold_axis<1>(met, 0x1111111111111111);
    else if (shifts[0] == 1) met = (met | met >> 1) & 0x1111111111111111;
    if (shifts[1] == 2) met = fold_axis<4>(met, 0x000f000f000f000f);
    else if (shifts[1] == 1) met = (met | met >> 4) & 0x000f000f000f000f;
    if (shifts[2] == 2) met = fold_axis<16>(met, 0xffff);
    else if (shifts[2] == 1) met = (met | met >> 16) & 0xffff;
    return met;
  }
  /// `lowest` are the bits of layer 0.
  template <int stride>
  static std::uint64_t fold_axis(std::uint64_t met, std::uint64_t lowest) {
    const std::uint64_t pairs = met | met >> stride;
    return (pairs & lowest) | ((pairs >> stride) & (lowest << stride));
  }

  struct LayersMet {
    std::array<int, 3> first, last;
  };
  LayersMet layers_met(std::uint32_t id, const Vec3d& lo, const Vec3d& size, const std::array<int, 3>& counts) const {
    const Aabb box = primitives_.bounds(id);
    LayersMet met;
    for (int axis = 0; axis < 3; ++axis) {
      const double from = (box.lo[axis] - origin_[axis] - reach_ - lo[axis]) / size[axis];
      const double to = (box.hi[axis] - origin_[axis] + reach_ - lo[axis]) / size[axis];
      met.first[axis] = clamp_to_index(from, counts[axis]);
      met.last[axis] = clamp_to_index(to, counts[axis]);
    }
    return met;
  }

  std::uint64_t cells_met(std::uint32_t id, const Vec3d& lo, const Vec3d& size, const std::array<int, 3>& counts) const {
    const auto [first, last] = layers_met(id, lo, size, counts);
    std::uint64_t within = 0;
    int places = 1;
    {
      std::uint64_t row = 0, plane = 0;
      row = ((2u << last[0]) - 1) & ~((1u << first[0]) - 1);
      for (int y = first[1]; y <= last[1]; ++y) plane |= row << (4 * y);
      for (int z = first[2]; z <= last[2]; ++z) within |= plane << (16 * z);
      for (int axis = 0; axis < 3; ++axis) places *= last[axis] - first[axis] + 1;
    }
    if (places == 1 || quality_ == Quality::fast) return within;
    const Hull hull = primitives_.hull(id);
    if (hull.is_polygon) return within & PolygonOverlap(hull, origin_, reach_).boxes_met(lo, size);
    for (std::uint64_t rest = within; rest != 0; rest &= rest - 1) {
      const int bit = std::countr_zero(rest);
      const Vec3d corner = origin_ + lo + size * Vec3d(bit % 4, bit / 4 % 4, bit / 16);
      Aabb box;
      for (int axis = 0; axis < 3; ++axis) {
        box.lo[axis] = round_down(corner[axis] - reach_);
        box.hi[axis] = round_up(corner[axis] + size[axis] + reach_);
      }
      if (primitives_.clip(id, box).is_empty()) within &= ~(std::uint64_t(1) << bit);
    }
    return within;
  }

  const Primitives& primitives_;
  Quality quality_;
  Vec3d origin_;
  double reach_;
  std::deque<Level> levels_;  ///< Scratch, by depth.
};

}  // namespace sightline
