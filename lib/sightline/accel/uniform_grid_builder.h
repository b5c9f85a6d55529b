#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sightline/accel/grid_resolution.h"
#include "sightline/accel/options.h"
#include "sightline/accel/padded_ray.h"
#include "sightline/accel/uniform_grid_cells.h"
#include "sightline/accel/uniform_grid_division.h"

namespace sightline {

class UniformGridBuilder {
 public:
  UniformGridBuilder(const Primitives& primitives, const UniformGridOptions& options)
      : primitives_(primitives), options_(options) {}

  GridParts build() {
    place_bounds();
    const std::uint32_t count = primitives_.size();
    resolution_ = grid_resolution(grid_.bounds, double(options_.density) * count);
    const std::uint64_t most_entries = std::uint64_t(top_copies) * count;
    const std::uint32_t step = 1 + count / sample_size;
    // Ends: one cell holds each primitive once, which is always allowed, in a sample too.
    for (place_planes(); !(collect(step, most_entries / step + 1) && (step == 1 || collect(1, most_entries)));
         place_planes()) {
      for (int& layers : resolution_) layers = std::max(1, layers / 2);
    }
    sort_into_cells();
    divide_cells();
    return std::move(grid_);
  }

 private:
  struct Entry {
    std::uint32_t cell, id;
  };
  static constexpr std::uint32_t top_copies = 8;      ///< Cells of the top level that hold a primitive, on average.
  static constexpr std::uint32_t chunk_size = 1024;   ///< Primitives handled by one task.
  static constexpr std::uint32_t sample_size = 4096;  ///< At least so many primitives tell whether a grid is too fine.
  static constexpr float near = 4;  ///< Largest extents within which rays may start that the cells allow for.

  void place_bounds() {
    const auto extended = [&](const auto& ids, Aabb box) {
      for (std::uint32_t id = ids.begin(); id != ids.end(); ++id) box.extend(primitives_.bounds(id));
      return box;
    };
    const auto joined = [](Aabb a, const Aabb& b) {
      a.extend(b);
      return a;
    };
    tight_ = tbb::parallel_reduce(tbb::blocked_range<std::uint32_t>(0, primitives_.size(), chunk_size), Aabb{},
                                  extended, joined);
    grid_.bounds = tight_;
    extent_ = max_norm(Vec3d(tight_.hi) - Vec3d(tight_.lo));
    grid_.pad = static_cast<float>(margin<float> * near * extent_);
  }

  /// The grid extends pad beyond the bounds (W4).
  void place_planes() {
    grid_.resolution = resolution_;
    for (int axis = 0; axis < 3; ++axis) {
      grid_.origin[axis] = next_down(round_down(double(tight_.lo[axis]) - grid_.pad));
      const double end = double(next_up(round_up(double(tight_.hi[axis]) + grid_.pad)));
      grid_.size[axis] = next_up(round_up((end - grid_.origin[axis]) / resolution_[axis]));
      grid_.inverse_size[axis] = 1 / grid_.size[axis];
    }
  }

  GridDivider divider() const {
    return {primitives_, options_.quality, Vec3d(grid_.origin), double(grid_.pad) + 0x1p-40 * extent_};
  }

  /// Finds the cells of every step-th primitive. False, and incomplete, when there are more than `most_entries`.
  bool collect(std::uint32_t step, std::uint64_t most_entries) {
    const std::uint32_t count = (primitives_.size() - 1) / step + 1;
    chunks_.assign((count - 1) / chunk_size + 1, {});
    std::atomic<std::uint64_t> total = 0;
    tbb::parallel_for(std::size_t(0), chunks_.size(), [&](std::size_t chunk) {
      std::vector<Entry>& entries = chunks_[chunk];
      const GridDivider divider = this->divider();
      const std::uint32_t begin = static_cast<std::uint32_t>(chunk) * chunk_size;
      const std::uint32_t end = begin + std::min(count - begin, chunk_size);
      std::size_t told = 0;
      for (std::uint32_t i = begin; i != end; ++i) {
        divider.for_each_cell(i * step, Vec3d(grid_.size), grid_.resolution, [&](const std::array<int, 3>& place) {
          entries.push_back({grid_.top_cell(place), i * step});
        });
        if (entries.size() - told < chunk_size && i + 1 != end) continue;
        if (total.fetch_add(entries.size() - told, std::memory_order_relaxed) > most_entries) return;
        told = entries.size();
      }
    });
    return total <= most_entries;
  }

  /// Counting sort: count, sum up, fill. Cells are filled from their ends in any order and sorted when they are
  /// divided, so the result does not depend on threads.
  void sort_into_cells() {
    const std::size_t cells = std::size_t(resolution_[0]) * resolution_[1] * resolution_[2];
    starts_.assign(cells + 1, 0);
    const auto for_each_entry = [&](auto&& use) {
      tbb::parallel_for(std::size_t(0), chunks_.size(), [&](std::size_t chunk) {
        for (const Entry& entry : chunks_[chunk]) use(entry, std::atomic_ref(starts_[entry.cell]));
      });
    };
    for_each_entry([](const Entry&, auto start) { start.fetch_add(1, std::memory_order_relaxed); });
    for (std::size_t cell = 1; cell <= cells; ++cell) starts_[cell] += starts_[cell - 1];
    ids_.resize(starts_[cells]);
    for_each_entry(
        [&](const Entry& entry, auto start) { ids_[start.fetch_sub(1, std::memory_order_relaxed) - 1] = entry.id; });
    chunks_ = {};
  }

  /// Divides the cells of the top level, so many in a task that each has about as much to do, and joins what they
  /// became.
  void divide_cells() {
    const std::size_t cells = starts_.size() - 1;
    std::vector<std::size_t> begins{0};
    for (std::size_t cell = 0; cell != cells; ++cell) {
      if (starts_[cell + 1] - starts_[begins.back()] >= chunk_size) begins.push_back(cell + 1);
    }
    if (begins.back() != cells) begins.push_back(cells);

    std::vector<DividedCells> parts(begins.size() - 1);
    grid_.cells.resize(cells);
    tbb::parallel_for(std::size_t(0), parts.size(), [&](std::size_t part) {
      GridDivider divider = this->divider();
      for (std::size_t cell = begins[part]; cell != begins[part + 1]; ++cell) {
        const std::span<std::uint32_t> ids(ids_.data() + starts_[cell], starts_[cell + 1] - starts_[cell]);
        if (ids.empty()) continue;
        std::sort(ids.begin(), ids.end());
        std::array<int, 3> place;
        auto rest = static_cast<int>(cell);
        for (int axis = 0; axis < 3; ++axis) {
          place[axis] = rest % resolution_[axis];
          rest /= resolution_[axis];
        }
        const Vec3d size(grid_.size);
        grid_.cells[cell] = divider.divide(ids, Vec3d(place[0], place[1], place[2]) * size, size,
                                           std::uint64_t(options_.max_copies) * ids.size(), parts[part]);
      }
    });
    join(parts, begins);
  }

  void join(const std::vector<DividedCells>& parts, const std::vector<std::size_t>& begins) {
    struct Place {
      std::uint32_t cells, blocks, order;
    };
    std::vector<Place> places;
    std::uint64_t cells = grid_.cells.size(), blocks = 0, order = 0;
    for (const DividedCells& part : parts) {
      places.push_back(
          {static_cast<std::uint32_t>(cells), static_cast<std::uint32_t>(blocks), static_cast<std::uint32_t>(order)});
      cells += part.cells.size(), blocks += part.blocks.size(), order += part.order.size();
    }
    if (std::max({cells, blocks, order}) >= std::numeric_limits<std::uint32_t>::max()) {
      throw std::length_error("grid: more than 2^32 - 2 references; expected fewer primitives or copies");
    }
    grid_.cells.resize(cells);
    grid_.blocks.resize(blocks);
    grid_.order.resize(order);
    tbb::parallel_for(std::size_t(0), parts.size(), [&](std::size_t i) {
      const Place& place = places[i];
      const auto moved = [&](GridCell cell) -> GridCell {
        if (!cell.is_empty()) cell.first += cell.is_leaf() ? place.order : place.blocks;
        return cell;
      };
      std::transform(parts[i].cells.begin(), parts[i].cells.end(), grid_.cells.begin() + place.cells, moved);
      std::transform(parts[i].blocks.begin(), parts[i].blocks.end(), grid_.blocks.begin() + place.blocks,
                     [&](GridBlock block) {
                       block.first_cell += place.cells;
                       return block;
                     });
      std::copy(parts[i].order.begin(), parts[i].order.end(), grid_.order.begin() + place.order);
      for (std::size_t cell = begins[i]; cell != begins[i + 1]; ++cell) grid_.cells[cell] = moved(grid_.cells[cell]);
    });
  }

  const Primitives& primitives_;
  const UniformGridOptions& options_;
  GridParts grid_;
  Aabb tight_;
  double extent_ = 0;
  std::array<int, 3> resolution_{};
  std::vector<std::vector<Entry>> chunks_;
  std::vector<std::uint32_t> starts_, ids_;  ///< By cell of the top level.
};

}  // namespace sightline
