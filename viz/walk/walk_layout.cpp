#include "viz/walk/walk_layout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sightline::viz {
namespace {

using Kind = WalkStep::Kind;

int telling(const WalkStep& step) {
  if (step.is_hit) return 4;
  switch (step.kind) {
    case Kind::leaf:
      return 3;
    case Kind::cull:
      return 2;
    case Kind::visit:
      return 1;
    case Kind::candidate:
      break;
  }
  return 0;
}

}  // namespace

WalkLayout::WalkLayout(int pixel_width, int pixel_height)
    : unit_(std::min(pixel_width / 1920.0, pixel_height / 1080.0)),
      width_(pixel_width / unit_),
      height_(pixel_height / unit_) {
  constexpr double margin = 20, bottom = 236, right = 820;
  const double low = height_ - bottom, beside = width_ - right - margin;
  title = {margin, 10, width_ - 2 * margin, 58};
  legend = {margin, low - 76, beside - 2 * margin, 70};
  space = {margin, 74, beside - 2 * margin, legend.y - 80};
  const double top = 74, rest = low - top, facts_height = 268;
  tree = {beside, top + 28, right, 0.56 * (rest - facts_height) - 40};
  const double below = tree.y + tree.height + 40;
  facts = {beside, low - facts_height, right, facts_height};
  treemap = {beside, below, right, facts.y - below - 12};
  timeline = {margin + 90, low + 26, width_ - 2 * margin - 90, 84};
  reach = {margin + 90, low + 118, width_ - 2 * margin - 90, 72};
  command = {margin, height_ - 34, width_ - 2 * margin, 24};
}

std::vector<Tick> lay_out_timeline(const Walk& walk, const Panel& panel) {
  std::vector<Tick> ticks;
  if (walk.steps.empty()) return ticks;
  constexpr double narrowest = 2, widest = 70;
  const auto room = static_cast<std::size_t>(panel.width / narrowest);
  const std::size_t together = (walk.steps.size() + room - 1) / room;
  const std::size_t count = (walk.steps.size() + together - 1) / together;
  const double width = std::min(widest, panel.width / double(count));
  int deepest = 1;
  for (const WalkStep& step : walk.steps) {
    deepest = std::max(deepest, walk.cells[walk.cell_of(step.node)].cell.depth);
  }
  for (std::size_t first = 0; first < walk.steps.size(); first += together) {
    const std::size_t last = std::min(first + together, walk.steps.size()) - 1;
    std::size_t shown = first;
    for (std::size_t i = first; i <= last; ++i) {
      if (telling(walk.steps[i]) > telling(walk.steps[shown])) shown = i;
    }
    const WalkStep& step = walk.steps[shown];
    const double depth = walk.cells[walk.cell_of(step.node)].cell.depth;
    const double height = step.kind == Kind::candidate ? 0.5 : 1;
    ticks.push_back({first, last, shown, panel.x + double(ticks.size()) * width, width,
                     height * panel.height * (0.15 + 0.85 * depth / deepest)});
  }
  return ticks;
}

std::optional<std::size_t> step_at(std::span<const Tick> ticks, double x) {
  for (const Tick& tick : ticks) {
    if (x >= tick.x && x < tick.x + tick.width) return tick.shown;
  }
  return std::nullopt;
}

}  // namespace sightline::viz
