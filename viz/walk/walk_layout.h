#pragma once
/// Where the parts of a walk's picture are, and which of its cells and steps are there. Needs nothing that draws.

#include "viz/walk/walk_state.h"

namespace sightline::viz {

struct Panel {
  double x = 0, y = 0, width = 0, height = 0;

  bool contains(double px, double py) const { return px >= x && px < x + width && py >= y && py < y + height; }
};

/// In units of which 1920 are across and 1080 down, or more of either.
class WalkLayout {
 public:
  static constexpr int lowest_width = 960, lowest_height = 540;

  WalkLayout(int width, int height);

  double unit() const { return unit_; }  ///< Pixels.
  double width() const { return width_; }
  double height() const { return height_; }
  Panel title, space, legend, tree, treemap, facts, timeline, reach, command;

 private:
  double unit_, width_, height_;
};

/// As much of the hierarchy as is legible: what is near the current cell comes first.
struct TreeLayout {
  struct Node {
    std::size_t cell;                  ///< Index into Walk::cells.
    std::optional<std::size_t> above;  ///< Index into `nodes`.
    double x, y;
    std::size_t hidden = 0;  ///< Cells below that are left out.
  };
  std::vector<Node> nodes;
  double radius = 0;
  int first_depth = 0;  ///< Shallower ones are left out.
  std::size_t left_out = 0;

  std::optional<std::size_t> cell_at(double x, double y) const;
};
TreeLayout lay_out_tree(const Walk& walk, std::span<const CellState> states, std::size_t current, const Panel& panel);

/// Candidates below each of walk.cells, as often as leaves refer to them.
std::vector<std::size_t> candidates_below(const Tracer& tracer, const Walk& walk);

/// A panel for each of walk.cells, within its parent's. The children of a cell share its area by their candidates; one
/// that has none takes the share of its volume in its parent's. What is no cell of the walk stays free.
std::vector<Panel> lay_out_treemap(const Walk& walk, std::span<const std::size_t> candidates, const Panel& panel);
/// The deepest cell there.
std::optional<std::size_t> cell_at(std::span<const Panel> treemap, const Walk& walk, double x, double y);

/// One tick a step; where there are more steps than fit, one for several, of the most telling kind.
struct Tick {
  std::size_t first, last;
  std::size_t shown;  ///< The step that gives kind and depth.
  double x, width, height;
};
std::vector<Tick> lay_out_timeline(const Walk& walk, const Panel& panel);
/// The one that a place of the timeline stands for.
std::optional<std::size_t> step_at(std::span<const Tick> ticks, double x);

}  // namespace sightline::viz
