#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sightline/accel/large_pages.h"
#include "sightline/accel/probe.h"
#include "sightline/math/aabb.h"
#include "sightline/math/rounding.h"

namespace sightline {

/// A cell: empty, a leaf, or divided by a block.
struct GridCell {
  std::uint32_t first = 0;  ///< Position of a leaf in the order; index of a divided cell's block, plus one.
  std::uint32_t count = 0;  ///< Primitives of a leaf; 0 for other cells.

  static GridCell divided_by(std::uint32_t block) { return {block + 1, 0}; }
  bool is_empty() const { return (first | count) == 0; }
  bool is_leaf() const { return count != 0; }
  std::uint32_t block() const { return first - 1; }
  LeafRange range() const { return {first, count}; }
};
static_assert(sizeof(GridCell) == 8);

/// Divides one cell into 1, 2 or 4 layers along each axis. Place (x, y, z) of its cells has the bit x + 4 y + 16 z.
struct GridBlock {
  static constexpr int side = 4;

  std::uint64_t occupied = 0;            ///< Bits of the places of cells that are not empty; only those are stored, ...
  std::uint32_t first_cell = 0;          ///< ... in the order of their bits, from here on.
  std::array<std::uint8_t, 3> shifts{};  ///< The cell has 2^shift layers along the axis.

  static constexpr int bit(int x, int y, int z) { return x + side * (y + side * z); }
  static constexpr std::array<int, 3> place_of(int bit) { return {bit % side, bit / side % side, bit / (side * side)}; }
  /// Of the cell that has the number `place` among all cells of its size.
  int bit_of(const std::array<int, 3>& place) const {
    const auto local = [&](int axis) { return place[axis] & ((1 << shifts[axis]) - 1); };
    return bit(local(0), local(1), local(2));
  }
  bool has(int bit) const { return (occupied >> bit & 1) != 0; }
  std::uint32_t cell_at(int bit) const {
    return first_cell + static_cast<std::uint32_t>(std::popcount(occupied & ((std::uint64_t(1) << bit) - 1)));
  }
};
static_assert(sizeof(GridBlock) == 16);

/// Cells of one size by number: those from `first` to `last`, both included, along each axis.
struct GridRegion {
  std::array<int, 3> first{}, last{};
  std::array<int, 3> shifts{};  ///< There are 2^shift layers of them in one layer of the top level.

  /// The cells of the block that divides the cell at `place`.
  GridRegion inside(const std::array<int, 3>& place, const GridBlock& block) const {
    GridRegion region;
    for (int axis = 0; axis < 3; ++axis) {
      region.first[axis] = place[axis] << block.shifts[axis];
      region.last[axis] = region.first[axis] + (1 << block.shifts[axis]) - 1;
      region.shifts[axis] = shifts[axis] + block.shifts[axis];
    }
    return region;
  }
  GridRegion cell(const std::array<int, 3>& place) const { return {place, place, shifts}; }

  /// Calls see(place), x running fastest.
  template <class See>
  void for_each_place(See&& see) const {
    for (int z = first[2]; z <= last[2]; ++z) {
      for (int y = first[1]; y <= last[1]; ++y) {
        for (int x = first[0]; x <= last[0]; ++x) see(std::array<int, 3>{x, y, z});
      }
    }
  }
};

/// A built grid: the cells of the top level, x running fastest, and after them those of the blocks.
struct GridParts {
  Aabb bounds;    ///< Of the primitives.
  float pad = 0;  ///< Cells hold every primitive that comes so near.
  Vec3f origin{0};
  Vec3f size{0};                    ///< Of a cell of the top level.
  Vec3f inverse_size{0};            ///< 1 / size, rounded.
  std::array<int, 3> resolution{};  ///< Of the top level.
  LargeVector<GridCell> cells;
  LargeVector<GridBlock> blocks;
  std::vector<std::uint32_t> order;

  GridRegion top() const { return {{0, 0, 0}, {resolution[0] - 1, resolution[1] - 1, resolution[2] - 1}, {0, 0, 0}}; }
  std::uint32_t top_cell(const std::array<int, 3>& place) const {
    return static_cast<std::uint32_t>(place[0] + resolution[0] * (place[1] + resolution[1] * place[2]));
  }

  /// Contains the cells of the region.
  Aabb box(const GridRegion& region) const {
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
      const double layer = std::ldexp(double(size[axis]), -region.shifts[axis]);
      box.lo[axis] = next_down(round_down(origin[axis] + region.first[axis] * layer));
      box.hi[axis] = next_up(round_up(origin[axis] + (region.last[axis] + 1) * layer));
    }
    return box;
  }
};

}  // namespace sightline
