/// What decides a grid's top level: a number of cells for each primitive, by rule; here with what others would cost.

#include <cmath>

#include "sightline/accel/uniform_grid.h"
#include "viz/build/replay.h"

namespace sightline::viz {
namespace {

class GridReplay final : public BuildReplay {
 public:
  GridReplay(const Primitives& primitives, const UniformGridOptions& options)
      : primitives_(primitives), options_(options) {
    for (std::uint32_t id = 0; id < primitives.size(); ++id) grid_.bounds.extend(primitives.bounds(id));
    extent_ = max_norm(Vec3d(grid_.bounds.hi) - Vec3d(grid_.bounds.lo));
    grid_.pad = static_cast<float>(margin<float> * near * extent_);
  }

  /// \throws std::invalid_argument below the root
  Decision decide(std::span<const int> way) override {
    if (!way.empty()) {
      throw std::invalid_argument("grid: only the choice of the top level is weighed again, at the root (--step 0)");
    }
    Decision decision;
    decision.chart = DecisionChart::by_cells;
    decision.position_title = "cells of the top level, as a power of 2";
    decision.cost_unit = "steps from cell to cell";
    for (std::uint32_t id = 0; id < primitives_.size(); ++id) decision.primitives.push_back(id);
    decision.is_divided = true;

    const std::array<int, 3> taken = resolution_taken();
    Cells cells = fill(taken, 1);
    add(decision, taken, cells, 1);
    grid_.top().for_each_place([&](const std::array<int, 3>& place) {
      auto& ids = cells[grid_.top_cell(place)];
      if (!ids.empty()) decision.parts.push_back(std::move(ids));
    });
    decision.candidates.back().label = "by rule";
    const std::uint32_t step = 1 + primitives_.size() / most_weighed;
    for (double cells_each = 0x1p-9; cells_each <= 0x1p5; cells_each *= 2) {
      const std::array<int, 3> resolution = grid_resolution(grid_.bounds, cells_each * primitives_.size());
      if (resolution == taken || cells_of(resolution) > most_cells) continue;
      const Cells weighed = fill(resolution, step);
      add(decision, resolution, weighed, step);
      if (entries(weighed) * step > 2 * top_copies * primitives_.size()) break;  // finer ones would not be taken
    }
    std::stable_sort(decision.candidates.begin(), decision.candidates.end(),
                     [](const auto& a, const auto& b) { return a.position < b.position; });
    for (std::size_t i = 0; i < decision.candidates.size(); ++i) {
      if (!decision.candidates[i].label.empty()) decision.chosen = i;
    }
    explain(taken, step, decision);
    return decision;
  }

 private:
  static constexpr float near = 4;  ///< These two are UniformGridBuilder's.
  static constexpr std::uint64_t top_copies = 8;
  static constexpr std::uint32_t most_weighed = 50'000;  ///< Of more primitives a part stands for all.
  static constexpr double most_cells = 0x1p21;
  using Cells = std::vector<std::vector<std::uint32_t>>;

  static double cells_of(const std::array<int, 3>& resolution) {
    return double(resolution[0]) * resolution[1] * resolution[2];
  }
  /// Of a leaf, as GridDivider weighs it: a visit, and two for each eight triangles.
  static double leaf_cost(double primitives) { return primitives == 0 ? 0 : 1 + 2 * std::ceil(primitives / 8); }

  /// As the builder: coarser until cells hold each primitive no more than top_copies times on average.
  std::array<int, 3> resolution_taken() {
    const std::uint32_t count = primitives_.size(), step = 1 + count / 4096;
    const std::uint64_t most = top_copies * count;
    std::array<int, 3> resolution = grid_resolution(grid_.bounds, double(options_.density) * count);
    while ((step > 1 && entries(fill(resolution, step)) > most / step + 1) || entries(fill(resolution, 1)) > most + 1) {
      for (int& layers : resolution) layers = std::max(1, layers / 2);
    }
    return resolution;
  }

  /// Every step-th primitive in all cells that it meets.
  Cells fill(const std::array<int, 3>& resolution, std::uint32_t step) {
    grid_.resolution = resolution;
    for (int axis = 0; axis < 3; ++axis) {
      grid_.origin[axis] = next_down(round_down(double(grid_.bounds.lo[axis]) - grid_.pad));
      const double end = double(next_up(round_up(double(grid_.bounds.hi[axis]) + grid_.pad)));
      grid_.size[axis] = next_up(round_up((end - grid_.origin[axis]) / resolution[axis]));
    }
    const GridDivider divider(primitives_, options_.quality, Vec3d(grid_.origin),
                              double(grid_.pad) + 0x1p-40 * extent_);
    Cells cells(static_cast<std::size_t>(cells_of(resolution)));
    for (std::uint32_t id = 0; id < primitives_.size(); id += step) {
      divider.for_each_cell(id, Vec3d(grid_.size), resolution,
                            [&](const std::array<int, 3>& place) { cells[grid_.top_cell(place)].push_back(id); });
    }
    return cells;
  }

  static std::uint64_t entries(const Cells& cells) {
    std::uint64_t sum = 0;
    for (const auto& ids : cells) sum += ids.size();
    return sum;
  }

  /// A ray that crosses the bounds meets a cell with the probability that their surfaces tell.
  void add(Decision& decision, const std::array<int, 3>& resolution, const Cells& cells, double step) const {
    const Vec3d whole = Vec3d(grid_.bounds.hi) - Vec3d(grid_.bounds.lo);
    const Vec3d part = whole / Vec3d(resolution[0], resolution[1], resolution[2]);
    const auto area = [](const Vec3d& e) { return e.x * e.y + e.y * e.z + e.z * e.x; };
    double cost = static_cast<double>(cells.size());
    for (const auto& ids : cells) cost += leaf_cost(step * static_cast<double>(ids.size()));
    const double share = area(whole) > 0 ? area(part) / area(whole) : 1;
    decision.candidates.push_back({.position = std::log2(static_cast<double>(cells.size())),
                                   .cost = share * cost,
                                   .below = static_cast<std::uint32_t>(step * static_cast<double>(entries(cells)))});
  }

  void explain(const std::array<int, 3>& taken, std::uint32_t step, Decision& decision) const {
    const BuildCandidate& chosen = decision.candidates[*decision.chosen];
    const std::string count =
        std::to_string(taken[0]) + " x " + std::to_string(taken[1]) + " x " + std::to_string(taken[2]);
    const double bytes = cells_of(taken) * sizeof(GridCell) + 4.0 * chosen.below;
    decision.reason = "is cut into " + count + " cells, " + cost_text(options_.density) +
                      " for each triangle by rule: that costs " + cost_text(chosen.cost) +
                      " steps where one cell would cost " + cost_text(1 + leaf_cost(primitives_.size()));
    decision.how = "the top level alone, whose cells are as near to cubes as can be; it holds " +
                   cost_text(chosen.below) + " references, " + cost_text(bytes / 1024) +
                   " KiB. Finer ones look cheaper here, but crowded cells are cut again afterwards" +
                   (step > 1 ? "; every " + std::to_string(step) + "th triangle stands for all at the others" : "");
  }

  const Primitives& primitives_;
  const UniformGridOptions options_;
  GridParts grid_;
  double extent_ = 0;
};

}  // namespace

std::unique_ptr<BuildReplay> make_grid_replay(const Primitives& primitives, const TracerSettings& settings) {
  UniformGridOptions options;
  for (const auto& [name, value] : settings.options) set_option(UniformGrid::name, options, name, value);
  return std::make_unique<GridReplay>(primitives, options);
}

}  // namespace sightline::viz
