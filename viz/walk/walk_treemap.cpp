/// The hierarchy of a walk as areas within areas.

#include <algorithm>
#include <numeric>

#include "viz/partition.h"
#include "viz/walk/walk_layout.h"

namespace sightline::viz {
namespace {

struct Share {
  std::optional<std::size_t> cell;  ///< None: what is no cell of the walk.
  double weight;
};

double sum_of(std::span<const Share> shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0, [](double sum, const Share& s) { return sum + s.weight; });
}

/// Cuts the panel across its longer side into two groups as even as they get, and so on.
void divide(std::span<const Share> shares, const Panel& panel, std::vector<Panel>& panels) {
  if (shares.size() == 1) {
    if (shares.front().cell) panels[*shares.front().cell] = panel;
    return;
  }
  const double all = sum_of(shares);
  std::size_t count = 1;
  double first = shares.front().weight;
  while (count + 1 < shares.size() && first + 0.5 * shares[count].weight < 0.5 * all) first += shares[count++].weight;
  const double part = all > 0 ? first / all : 0.5;
  Panel a = panel, b = panel;
  if (panel.width >= panel.height) {
    a.width = part * panel.width;
    b.x += a.width, b.width -= a.width;
  } else {
    a.height = part * panel.height;
    b.y += a.height, b.height -= a.height;
  }
  divide(shares.first(count), a, panels);
  divide(shares.subspan(count), b, panels);
}

}  // namespace

std::vector<std::size_t> candidates_below(const Tracer& tracer, const Walk& walk) {
  std::vector<std::size_t> below(walk.cells.size());
  std::unordered_map<std::uint32_t, std::size_t> index;
  for (std::size_t i = 0; i < walk.cells.size(); ++i) index.emplace(walk.cells[i].cell.node, i);
  std::vector<std::optional<std::size_t>> path;
  tracer.for_each_cell([&](const Cell& cell) {
    const auto depth = static_cast<std::size_t>(cell.depth);
    path.resize(depth);
    const auto kept = index.find(cell.node);
    const bool is_kept = kept != index.end() && walk.cells[kept->second].cell.depth == cell.depth;
    path.push_back(is_kept ? std::optional(kept->second) : std::nullopt);
    if (!cell.is_leaf) return;
    for (const auto& above : path) {
      if (above) below[*above] += cell.range.count;
    }
  });
  return below;
}

std::vector<Panel> lay_out_treemap(const Walk& walk, std::span<const std::size_t> candidates, const Panel& panel) {
  std::vector<Panel> panels(walk.cells.size());
  std::vector<std::vector<std::size_t>> children(walk.cells.size());
  for (std::size_t i = 0; i < walk.cells.size(); ++i) {
    if (walk.cells[i].parent) children[*walk.cells[i].parent].push_back(i);
  }
  if (!panels.empty()) panels.front() = panel;
  for (std::size_t i = 0; i < walk.cells.size(); ++i) {
    if (children[i].empty()) continue;
    const double all = double(candidates[i]), volume = volume_of(walk.cells[i].cell);
    std::vector<Share> shares;
    double counted = 0;
    for (const std::size_t child : children[i]) {
      const double part = volume > 0 ? std::min(1.0, volume_of(walk.cells[child].cell) / volume) : 0;
      shares.push_back({child, candidates[child] > 0 ? double(candidates[child]) / all : part});
      counted += double(candidates[child]);
    }
    if (counted < all) shares.push_back({std::nullopt, (all - counted) / all});
    divide(shares, panels[i], panels);
  }
  return panels;
}

std::optional<std::size_t> cell_at(std::span<const Panel> treemap, const Walk& walk, double x, double y) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < treemap.size(); ++i) {
    if (treemap[i].contains(x, y) && (!found || walk.cells[i].cell.depth > walk.cells[*found].cell.depth)) found = i;
  }
  return found;
}

}  // namespace sightline::viz
