/// The hierarchy of a walk as few nodes as can be read.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "viz/walk/walk_layout.h"

namespace sightline::viz {
namespace {

constexpr double least_slot = 17, least_level = 12, widest_slot = 64, highest_level = 40;

/// Cells in the order in which they are wanted.
std::vector<std::size_t> ranked(const Walk& walk, std::span<const CellState> states, std::size_t current) {
  const std::size_t count = walk.cells.size();
  std::vector<std::uint8_t> is_on_path(count);
  for (std::optional<std::size_t> i = current; i; i = walk.cells[*i].parent) is_on_path[*i] = 1;
  std::vector<std::size_t> children(count);
  for (const WalkCell& cell : walk.cells) {
    if (cell.parent) ++children[*cell.parent];
  }
  const auto rank = [&](std::size_t i) {
    if (is_on_path[i]) return 0;
    if (states[i] == CellState::pending) return 1;
    const auto& parent = walk.cells[i].parent;
    if (parent && is_on_path[*parent] && children[*parent] <= 8) return 2;
    if (states[i] == CellState::opened || states[i] == CellState::culled) return 3;
    return states[i] == CellState::beside ? 4 : 5;
  };
  std::vector<int> ranks(count);
  for (std::size_t i = 0; i < count; ++i) ranks[i] = rank(i);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    if (ranks[a] != ranks[b]) return ranks[a] < ranks[b];
    return ranks[a] == 3 && walk.cells[a].opened.value_or(0) > walk.cells[b].opened.value_or(0);  // the latest first
  });
  return order;
}

/// Cells are added with what contains them as long as there is room beside each other.
class Choice {
 public:
  explicit Choice(const Walk& walk) : walk_(walk), shown_(walk.cells.size()), below_(walk.cells.size()) {}

  bool is_shown(std::size_t cell) const { return shown_[cell] != 0; }

  /// False where that would take more than `most` slots.
  bool add(std::size_t cell, std::size_t most) {
    std::size_t top = cell;
    if (is_shown(cell)) return true;
    while (walk_.cells[top].parent && !is_shown(*walk_.cells[top].parent)) top = *walk_.cells[top].parent;
    const auto& parent = walk_.cells[top].parent;
    const std::size_t more = parent && below_[*parent] == 0 ? 0 : 1;
    if (slots_ + more > most) return false;
    slots_ += more;
    for (std::optional<std::size_t> i = cell; i && !is_shown(*i); i = walk_.cells[*i].parent) {
      shown_[*i] = 1;
      if (walk_.cells[*i].parent) ++below_[*walk_.cells[*i].parent];
    }
    return true;
  }

 private:
  const Walk& walk_;
  std::vector<std::uint8_t> shown_;
  std::vector<std::size_t> below_;  ///< Children that are shown.
  std::size_t slots_ = 0;
};

}  // namespace

TreeLayout lay_out_tree(const Walk& walk, std::span<const CellState> states, std::size_t current, const Panel& panel) {
  TreeLayout layout;
  if (walk.cells.empty()) return layout;
  const auto most_slots = static_cast<std::size_t>(std::max(2.0, panel.width / least_slot));
  const int most_levels = std::max(2, static_cast<int>(panel.height / least_level));
  int deepest = 0;
  for (const WalkCell& cell : walk.cells) deepest = std::max(deepest, cell.cell.depth);
  const int below = std::min(3, most_levels - 2);  // levels shown beneath the current cell
  layout.first_depth =
      std::clamp(walk.cells[current].cell.depth + below + 1 - most_levels, 0, std::max(0, deepest + 1 - most_levels));
  const int last_depth = layout.first_depth + most_levels - 1;

  Choice choice(walk);
  for (const std::size_t cell : ranked(walk, states, current)) {
    if (walk.cells[cell].cell.depth <= last_depth) choice.add(cell, most_slots);
  }
  std::vector<std::optional<std::size_t>> place(walk.cells.size());
  for (std::size_t i = 0; i < walk.cells.size(); ++i) {
    const auto& parent = walk.cells[i].parent;
    if (!choice.is_shown(i) || walk.cells[i].cell.depth < layout.first_depth) {
      ++layout.left_out;
      std::optional<std::size_t> above = parent;
      while (above && !place[*above]) above = walk.cells[*above].parent;
      if (above) ++layout.nodes[*place[*above]].hidden;
      continue;
    }
    place[i] = layout.nodes.size();
    layout.nodes.push_back({i, parent ? place[*parent] : std::nullopt, -1, 0, 0});
  }

  // Parents first, so that slots are given out in order; nodes that have children are then put above their middle.
  std::vector<std::size_t> children(layout.nodes.size());
  int lowest = layout.first_depth;
  for (const auto& node : layout.nodes) {
    if (node.above) ++children[*node.above];
    lowest = std::max(lowest, walk.cells[node.cell].cell.depth);
  }
  std::size_t slots = 0;
  for (std::size_t i = 0; i < layout.nodes.size(); ++i) {
    if (children[i] == 0) layout.nodes[i].x = double(slots++);
  }
  std::vector<double> left(layout.nodes.size(), 1e300), right(layout.nodes.size(), -1e300);
  for (std::size_t i = layout.nodes.size(); i-- > 0;) {
    auto& node = layout.nodes[i];
    if (children[i] > 0) node.x = 0.5 * (left[i] + right[i]);
    if (!node.above) continue;
    left[*node.above] = std::min(left[*node.above], node.x);
    right[*node.above] = std::max(right[*node.above], node.x);
  }
  const double slot = std::min(widest_slot, panel.width / double(std::max<std::size_t>(slots, 1)));
  const double level = std::min(highest_level, panel.height / (lowest - layout.first_depth + 1));
  const double start = panel.x + 0.5 * (panel.width - slot * double(slots));
  layout.radius = std::min(9.0, 0.36 * std::min(slot, level));
  for (auto& node : layout.nodes) {
    node.x = start + (node.x + 0.5) * slot;
    node.y = panel.y + (walk.cells[node.cell].cell.depth - layout.first_depth + 0.5) * level;
  }
  return layout;
}

std::optional<std::size_t> TreeLayout::cell_at(double x, double y) const {
  for (const Node& node : nodes) {
    if (std::hypot(x - node.x, y - node.y) <= radius + 3) return node.cell;
  }
  return std::nullopt;
}

}  // namespace sightline::viz
