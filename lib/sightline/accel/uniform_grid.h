#pragma once

#include <utility>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/uniform_grid_builder.h"
#include "sightline/accel/uniform_grid_cells.h"
#include "sightline/accel/uniform_grid_walk.h"

namespace sightline {

/// Uniform grid: space cut into equal cells, each with the list of the primitives that meet it; cells with many are cut
/// again, into a block of up to 4 x 4 x 4, and so on.
///   G1  Planes are the real numbers origin + i * size, and size halves from a cell to its block's cells, so a plane is
///       the same number at every level. There is no gap between cells.
///   G2  A cell holds every primitive that comes within pad_ of it, on every axis.
///   G3  A walk visits, for every t of its range, a cell that ray(t) is within pad_ / 4 of (uniform_grid_walk.h).
/// Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing", 1987, but crossing parameters are multiplied
/// from plane numbers and never accumulated. Resolution: Ize, Shirley and Parker, "Grid creation strategies for
/// efficient ray tracing", 2007. Grids in crowded cells: Jevans and Wyvill, "Adaptive voxel subdivision for ray
/// tracing", 1989; Kalojanov, Billeter and Slusallek, "Two-level grids for ray tracing on GPUs", 2011.
class UniformGrid {
 public:
  static constexpr std::string_view name = "grid";
  static constexpr std::string_view description =
      "equal cells, crowded ones cut again, walked from plane to plane; Amanatides and Woo 1987, Jevans and Wyvill "
      "1989";
  static constexpr std::size_t node_bytes = sizeof(GridCell);
  using Options = UniformGridOptions;

  /// \throws std::invalid_argument for options out of their limits.
  static UniformGrid build(const Primitives& primitives, const Options& options = {}) {
    validate(name, options);
    UniformGrid grid;
    if (primitives.size() != 0) grid.parts_ = UniformGridBuilder(primitives, options).build();
    return grid;
  }

  std::size_t memory_bytes() const {
    return parts_.cells.size() * sizeof(GridCell) + parts_.blocks.size() * sizeof(GridBlock) +
           parts_.order.size() * sizeof(std::uint32_t);
  }
  std::span<const std::uint32_t> leaf_order() const { return parts_.order; }
  bool is_order_final() const { return true; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
    if (parts_.order.empty() || !is_valid(ray)) return;
    const GridRay<T> thin(ray, parts_);
    if (thin.is_ordinary && pad_of(reach_of(ray.origin, parts_.bounds), max_norm(ray.direction)) <= parts_.pad) {
      GridWalk(parts_, thin, visit, probe).walk(ray.t_min, ray.t_max);
    } else {
      GridDescent(parts_, PaddedRay<T>(ray, parts_.bounds), visit, probe).descend();
    }
  }

  /// The whole grid, then its cells, those of a block after the cell that it divides; none that are empty. The whole
  /// grid has the number after the last cell.
  template <class See>
  void for_each_cell(See&& see) const {
    if (parts_.order.empty()) return;
    const GridRegion top = parts_.top();
    see(Cell{parts_.box(top), 0, false, {}, static_cast<std::uint32_t>(parts_.cells.size())});
    top.for_each_place(
        [&](const std::array<int, 3>& place) { see_cell(see, 1, top.cell(place), parts_.top_cell(place)); });
  }

  /// See for_each_leaf in accelerator.h.
  template <class See>
  void for_each_leaf(See&& see) const {
    for (const GridCell& cell : parts_.cells) {
      if (cell.is_leaf()) see(cell.range());
    }
  }

 private:
  template <class See>
  void see_cell(See& see, int depth, const GridRegion& region, std::uint32_t number) const {
    const GridCell cell = parts_.cells[number];
    if (cell.is_empty()) return;
    see(Cell{parts_.box(region), depth, cell.is_leaf(), cell.is_leaf() ? cell.range() : LeafRange{}, number});
    if (cell.is_leaf()) return;
    const GridBlock& block = parts_.blocks[cell.block()];
    const GridRegion inside = region.inside(region.first, block);
    inside.for_each_place([&](const std::array<int, 3>& place) {
      const int bit = block.bit_of(place);
      if (block.has(bit)) see_cell(see, depth + 1, inside.cell(place), block.cell_at(bit));
    });
  }

  GridParts parts_;
};

static_assert(Accelerator<UniformGrid>);

}  // namespace sightline
