#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/grid_resolution.h"
#include "sightline/accel/padded_ray.h"

namespace sightline {

struct UniformGridOptions {
  float density = 4;    ///< Cells wanted for each primitive.
  int max_copies = 16;  ///< Cells that hold a primitive, on average; a grid that needs more is made coarser.

  static constexpr std::array<OptionField<UniformGridOptions>, 2> fields() {
    return {{{"density", &UniformGridOptions::density, 0x1p-10, 64, "cells wanted for each primitive"},
             {"max_copies", &UniformGridOptions::max_copies, 1, 1024,
              "most cells that hold a primitive, on average; a grid that needs more is made coarser"}}};
  }
};

/// Uniform grid: space cut into equal cells, each with the list of the primitives that meet it.
///   G1  The planes of an axis increase strictly; the first and the last are the faces of the bounds. Building and
///       traversal read the same floats, so there is no gap between cells, however the planes are rounded.
///   G2  A point of a primitive lies in a cell that holds the primitive: cells are closed, and one that only touches a
///       cell's face is in the cells on both sides.
///   G3  A walk visits every cell that the padded ray meets within its range exactly once, in the order of entry.
/// Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing", 1987, but crossing parameters are multiplied
/// from the planes and never accumulated. Resolution: Ize, Shirley and Parker, "Grid creation strategies for efficient
/// ray tracing", 2007.
class UniformGrid {
 public:
  static constexpr std::string_view name = "grid";
  static constexpr std::string_view description =
      "equal cells, walked from plane to plane; Amanatides and Woo 1987, Ize et al. 2007";
  static constexpr std::size_t node_bytes = sizeof(std::uint32_t);
  using Options = UniformGridOptions;

  /// \throws std::invalid_argument for options out of their limits.
  static UniformGrid build(const Primitives& primitives, const Options& options = {});

  std::size_t memory_bytes() const {
    std::size_t floats = 0;
    for (const auto& planes : planes_) floats += planes.size();
    return floats * sizeof(float) + (starts_.size() + order_.size()) * sizeof(std::uint32_t);
  }
  std::span<const std::uint32_t> leaf_order() const { return order_; }
  bool is_order_final() const { return true; }

  /// Cells along each axis; 0 where there are no primitives.
  const std::array<int, 3>& resolution() const { return resolution_; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const;

  /// The whole grid, then every cell that holds something. A cell's number is its index, x running fastest; the whole
  /// grid has the number after the last cell.
  template <class See>
  void for_each_cell(See&& see) const;

 private:
  class Builder;
  template <class T>
  struct Layers;

  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(starts_.size() - 1); }
  LeafRange range_of(std::uint32_t cell) const { return {starts_[cell], starts_[cell + 1] - starts_[cell]}; }
  int stride(int axis) const { return axis == 0 ? 1 : axis == 1 ? resolution_[0] : resolution_[0] * resolution_[1]; }
  std::uint32_t cell_at(const std::array<int, 3>& at) const {
    return static_cast<std::uint32_t>(at[0] + resolution_[0] * (at[1] + resolution_[1] * at[2]));
  }

  Aabb bounds_;
  std::array<int, 3> resolution_{};
  std::array<std::vector<float>, 3> planes_;  ///< resolution + 1 of each axis
  std::vector<std::uint32_t> starts_;         ///< of each cell in order_, and the end of the last
  std::vector<std::uint32_t> order_;          ///< by cell, and within a cell by id
};

// ---- Traversal

/// One axis of a walk. The padded ray is a box that moves; along this axis it covers the layers of cells from `trail`,
/// where its back edge is, to `lead`, where its front edge is. A layer counts from the time the front edge enters it to
/// the time the back edge leaves it, ends included. Along an axis on which the ray stands still these times are
/// infinite, or NaN where an edge lies exactly in a plane; both comparisons below keep such a layer for good.
template <class T>
struct UniformGrid::Layers {
  const float* enter_planes;  ///< through which the ray enters layer i
  const float* leave_planes;
  int step, last;  ///< along the ray's direction
  int lead, trail;
  T next_enter;   ///< of the layer after lead
  T trail_leave;  ///< of the layer trail

  Layers(const UniformGrid& grid, const PaddedRay<T>& ray, int axis, T t) {
    const float* planes = grid.planes_[axis].data();
    const int count = grid.resolution_[axis];
    const bool is_negative = ray.is_negative[axis];
    enter_planes = planes + (is_negative ? 1 : 0);
    leave_planes = planes + (is_negative ? 0 : 1);
    step = is_negative ? -1 : 1;
    last = is_negative ? 0 : count - 1;
    const int first = count - 1 - last;

    // Guess where the edges are, then let the very comparisons of the walk decide.
    const T lowest = planes[0], per_unit = static_cast<T>(count) / (static_cast<T>(planes[count]) - lowest);
    lead = clamp_to_index((ray.enter_origin[axis] + t * ray.direction[axis] - lowest) * per_unit, count);
    while (lead != first && ray.enter(axis, enter_planes[lead]) > t) lead -= step;
    while (lead != last && !(ray.enter(axis, enter_planes[lead + step]) > t)) lead += step;
    trail = lead;
    while (trail != first && !(ray.leave(axis, leave_planes[trail - step]) < t)) trail -= step;
    find_next_enter(ray, axis);
    trail_leave = ray.leave(axis, leave_planes[trail]);
  }

  void advance_lead(const PaddedRay<T>& ray, int axis) {
    lead += step;
    find_next_enter(ray, axis);
  }
  /// Never passes lead: the ray leaves a layer no earlier than it enters the next, and leaves the last one no earlier
  /// than the walk ends.
  void advance_trail(const PaddedRay<T>& ray, int axis, T t) {
    while (trail_leave < t) {
      trail += step;
      trail_leave = ray.leave(axis, leave_planes[trail]);
    }
  }

 private:
  void find_next_enter(const PaddedRay<T>& ray, int axis) {
    next_enter = lead == last ? std::numeric_limits<T>::infinity() : ray.enter(axis, enter_planes[lead + step]);
  }
};

template <class T, LeafVisitor<T> Visit, class Probe>
void UniformGrid::traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
  if (order_.empty()) return;
  const PaddedRay<T> padded(ray, bounds_);
  // Nothing is reported at infinity, so that an infinite entry always ends the walk.
  const Interval<T> inside = padded.clip(bounds_, std::min(padded.t_max, std::numeric_limits<T>::max()));
  if (inside.is_empty()) return;
  T t = inside.lo, far = inside.hi;

  // False when the walk is over. All cells of one step are entered at the same t.
  const auto examine = [&](std::uint32_t cell) {
    const LeafRange range = range_of(cell);
    if (range.count == 0) {
      probe.node(cell, t);
      return true;
    }
    probe.leaf(cell, range, t);
    far = std::min<T>(visit(range), inside.hi);
    return !(t > far);
  };

  Layers<T> layers[3] = {{*this, padded, 0, t}, {*this, padded, 1, t}, {*this, padded, 2, t}};
  const auto examine_all = [&](const std::array<int, 3>& from) {
    const auto& [x_layers, y_layers, z_layers] = layers;
    for (int z = from[2];; z += z_layers.step) {
      for (int y = from[1];; y += y_layers.step) {
        for (int x = from[0];; x += x_layers.step) {
          if (!examine(cell_at({x, y, z}))) return false;
          if (x == x_layers.lead) break;
        }
        if (y == y_layers.lead) break;
      }
      if (z == z_layers.lead) break;
    }
    return true;
  };

  if (!examine_all({layers[0].trail, layers[1].trail, layers[2].trail})) return;
  std::uint32_t lead_cell = cell_at({layers[0].lead, layers[1].lead, layers[2].lead});
  // G3: a cell is visited when the last of its three layers is entered, if the ray has not yet left the other two.
  const auto enter_next = [&]<int axis>(std::integral_constant<int, axis>) {
    constexpr int second = axis == 0 ? 1 : 0, third = axis == 2 ? 1 : 2;
    t = layers[axis].next_enter;
    if (t > far) return false;
    layers[axis].advance_lead(padded, axis);
    lead_cell += static_cast<std::uint32_t>(layers[axis].step * stride(axis));
    layers[second].advance_trail(padded, second, t);
    layers[third].advance_trail(padded, third, t);
    if (layers[second].trail == layers[second].lead && layers[third].trail == layers[third].lead) {
      return examine(lead_cell);
    }
    std::array<int, 3> from{layers[0].trail, layers[1].trail, layers[2].trail};
    from[axis] = layers[axis].lead;
    return examine_all(from);
  };
  for (bool goes_on = true; goes_on;) {
    const T x = layers[0].next_enter, y = layers[1].next_enter, z = layers[2].next_enter;
    if (x < y && x < z) {
      goes_on = enter_next(std::integral_constant<int, 0>{});
    } else if (y < z) {
      goes_on = enter_next(std::integral_constant<int, 1>{});
    } else {
      goes_on = enter_next(std::integral_constant<int, 2>{});
    }
  }
}

template <class See>
void UniformGrid::for_each_cell(See&& see) const {
  if (order_.empty()) return;
  see(Cell{bounds_, 0, false, {}, cell_count()});
  std::uint32_t cell = 0;
  for (int z = 0; z < resolution_[2]; ++z) {
    for (int y = 0; y < resolution_[1]; ++y) {
      for (int x = 0; x < resolution_[0]; ++x, ++cell) {
        const LeafRange range = range_of(cell);
        if (range.count == 0) continue;
        const Aabb box{{planes_[0][x], planes_[1][y], planes_[2][z]},
                       {planes_[0][x + 1], planes_[1][y + 1], planes_[2][z + 1]}};
        see(Cell{box, 1, true, range, cell});
      }
    }
  }
}

// ---- Construction

class UniformGrid::Builder {
 public:
  Builder(const Primitives& primitives, UniformGrid& grid) : primitives_(primitives), grid_(grid) {}

  void build(const Options& options) {
    const std::uint32_t count = primitives_.size();
    find_bounds();
    grid_.resolution_ = grid_resolution(grid_.bounds_, double(options.density) * count);
    const std::uint64_t most_entries =
        std::min<std::uint64_t>(std::uint64_t(options.max_copies) * count, std::numeric_limits<std::uint32_t>::max());
    const std::uint32_t step = 1 + count / sample_size;
    // Ends: one cell holds each primitive once, which is always allowed, in a sample too.
    for (place_planes(); !(collect(step, most_entries / step + 1) && (step == 1 || collect(1, most_entries)));
         place_planes()) {
      for (int& layers : grid_.resolution_) layers = std::max(1, layers / 2);
    }
    sort_into_cells();
  }

 private:
  struct Entry {
    std::uint32_t cell, id;
  };
  /// Layers [first, last] of each axis.
  struct Block {
    std::array<int, 3> first, last;
  };
  static constexpr std::uint32_t chunk_size = 1024;   ///< Primitives handled by one task.
  static constexpr std::uint32_t sample_size = 4096;  ///< At least so many primitives tell whether a grid is too fine.

  void find_bounds() {
    for (std::uint32_t id = 0; id != primitives_.size(); ++id) grid_.bounds_.extend(primitives_.bounds(id));
    extent_ = Vec3d(grid_.bounds_.hi) - Vec3d(grid_.bounds_.lo);
    slack_ = 0x1p-40 * max_norm(extent_);
  }

  void place_planes() {
    for (int axis = 0; axis < 3; ++axis) {
      grid_.planes_[axis] = layer_planes(grid_.bounds_.lo[axis], grid_.bounds_.hi[axis], grid_.resolution_[axis]);
    }
  }

  /// G2: the layers that a box meets, touching included.
  Block block_of(const Aabb& box, double slack) const {
    Block block;
    for (int axis = 0; axis < 3; ++axis) {
      const std::vector<float>& planes = grid_.planes_[axis];
      const int count = grid_.resolution_[axis];
      const double lo = box.lo[axis] - slack, hi = box.hi[axis] + slack, per_unit = count / extent_[axis];
      int first = clamp_to_index((lo - planes[0]) * per_unit, count);
      while (first > 0 && planes[first] >= lo) --first;
      while (first < count - 1 && planes[first + 1] < lo) ++first;
      int last = std::max(first, clamp_to_index((hi - planes[0]) * per_unit, count));
      while (last > first && planes[last] > hi) --last;
      while (last < count - 1 && planes[last + 1] <= hi) ++last;
      block.first[axis] = first;
      block.last[axis] = last;
    }
    return block;
  }

  /// Puts the primitive, whose bounds meet all layers of the block, into the cells that it meets. In a single row that
  /// is every cell; other blocks are halved, so the effort grows with the cells met and not with those of the bounds.
  void insert(std::uint32_t id, const Block& block, std::vector<Entry>& entries) const {
    const auto [longest, is_row] = shape_of(block);
    if (is_row) {
      std::array<int, 3> at = block.first;
      for (; at[longest] <= block.last[longest]; ++at[longest]) entries.push_back({grid_.cell_at(at), id});
      return;
    }
    const int middle = block.first[longest] + (block.last[longest] - block.first[longest]) / 2;
    for (const bool is_upper : {false, true}) {
      Block half = block;
      (is_upper ? half.first : half.last)[longest] = is_upper ? middle + 1 : middle;
      const Aabb part = primitives_.clip(id, enlarged_box(half));
      if (part.is_empty()) continue;
      const Block met = block_of(part, slack_);
      bool is_apart = false;
      for (int axis = 0; axis < 3; ++axis) {
        half.first[axis] = std::max(half.first[axis], met.first[axis]);
        half.last[axis] = std::min(half.last[axis], met.last[axis]);
        is_apart |= half.first[axis] > half.last[axis];
      }
      if (!is_apart) insert(id, half, entries);
    }
  }

  /// The axis with most layers, and whether the others have only one.
  static std::pair<int, bool> shape_of(const Block& block) {
    std::array<int, 3> steps;
    for (int axis = 0; axis < 3; ++axis) steps[axis] = block.last[axis] - block.first[axis];
    const int longest = static_cast<int>(std::max_element(steps.begin(), steps.end()) - steps.begin());
    return {longest, steps[0] + steps[1] + steps[2] == steps[longest]};
  }

  /// Clipping against six planes in double moves no point by more than 2^-45 of the extent, so a primitive that touches
  /// the block is found to meet one enlarged by 2^-40 of it.
  Aabb enlarged_box(const Block& block) const {
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
      box.lo[axis] = round_down(grid_.planes_[axis][block.first[axis]] - slack_);
      box.hi[axis] = round_up(grid_.planes_[axis][block.last[axis] + 1] + slack_);
    }
    return box;
  }

  /// Finds the cells of every step-th primitive. False, and incomplete, when there are more than `most_entries`.
  bool collect(std::uint32_t step, std::uint64_t most_entries) {
    const std::uint32_t count = (primitives_.size() - 1) / step + 1;
    chunks_.assign((count - 1) / chunk_size + 1, {});
    std::atomic<std::uint64_t> total = 0;
    tbb::parallel_for(std::size_t(0), chunks_.size(), [&](std::size_t chunk) {
      std::vector<Entry>& entries = chunks_[chunk];
      const std::uint32_t begin = static_cast<std::uint32_t>(chunk) * chunk_size;
      const std::uint32_t end = begin + std::min(count - begin, chunk_size);
      std::size_t told = 0;
      for (std::uint32_t i = begin; i != end; ++i) {
        insert(i * step, block_of(primitives_.bounds(i * step), 0), entries);
        if (entries.size() - told < chunk_size && i + 1 != end) continue;
        if (total.fetch_add(entries.size() - told, std::memory_order_relaxed) > most_entries) return;
        told = entries.size();
      }
    });
    return total <= most_entries;
  }

  /// Counting sort: count, sum up, fill. Cells are filled from their ends in any order and then sorted, so the result
  /// does not depend on threads.
  void sort_into_cells() {
    const std::size_t cells = std::size_t(grid_.resolution_[0]) * grid_.resolution_[1] * grid_.resolution_[2];
    std::vector<std::uint32_t>& starts = grid_.starts_;
    starts.assign(cells + 1, 0);
    const auto for_each_entry = [&](auto&& use) {
      tbb::parallel_for(std::size_t(0), chunks_.size(), [&](std::size_t chunk) {
        for (const Entry& entry : chunks_[chunk]) use(entry, std::atomic_ref(starts[entry.cell]));
      });
    };
    for_each_entry([](const Entry&, auto start) { start.fetch_add(1, std::memory_order_relaxed); });
    for (std::size_t cell = 1; cell <= cells; ++cell) starts[cell] += starts[cell - 1];
    grid_.order_.resize(starts[cells]);
    for_each_entry([&](const Entry& entry, auto start) {
      grid_.order_[start.fetch_sub(1, std::memory_order_relaxed) - 1] = entry.id;
    });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells, chunk_size), [&](const auto& some) {
      for (std::size_t cell = some.begin(); cell != some.end(); ++cell) {
        if (starts[cell + 1] - starts[cell] > 1) {
          std::sort(grid_.order_.begin() + starts[cell], grid_.order_.begin() + starts[cell + 1]);
        }
      }
    });
  }

  const Primitives& primitives_;
  UniformGrid& grid_;
  Vec3d extent_;
  double slack_ = 0;  ///< See enlarged_box.
  std::vector<std::vector<Entry>> chunks_;
};

inline UniformGrid UniformGrid::build(const Primitives& primitives, const Options& options) {
  validate(name, options);
  UniformGrid grid;
  if (primitives.size() != 0) Builder(primitives, grid).build(options);
  return grid;
}

static_assert(Accelerator<UniformGrid>);

}  // namespace sightline
