#include "viz/graph/graph_layout.h"

#include <algorithm>

namespace sightline::viz {
namespace {

constexpr double head = 46, gap = 22;

/// Where a tree of so many rows is hard to follow.
constexpr double low_tree = 200;
/// Below that, captions are cut off.
constexpr double narrow_space = 150, narrow_frame = 300;

/// The best number of columns: those that show most of what is in space, and leave room for a tree.
int columns_for(int frames, double width, double height, double tree_share, double aspect) {
  int best = 1;
  double best_side = 0;
  for (int columns = 1; columns <= frames; ++columns) {
    const int rows = (frames + columns - 1) / columns;
    const double across = ((width - (columns - 1) * gap) / columns) * (1 - tree_share);
    const double down = (height - (rows - 1) * gap) / rows - head;
    if (columns > 1 && (width - (columns - 1) * gap) / columns < (tree_share > 0 ? narrow_frame : narrow_space)) break;
    const double side = std::min(across / aspect, down) * (tree_share > 0 && down < low_tree ? 0.4 : 1);
    if (side > best_side) best = columns, best_side = side;
  }
  return best;
}

}  // namespace

GraphLayout::GraphLayout(int width, int height, int frames, bool has_one_tree, double aspect)
    : unit_(std::min(width / 1600.0, height / 1000.0)), width_(width / unit_), height_(height / unit_) {
  PanelFrame room{margin, top, width_ - 2 * margin, height_ - top - bottom};
  PanelFrame tree{room.x, room.y + 8, 0, room.height - 8};
  if (has_one_tree) {
    tree.width = frames == 1 ? 0.26 * room.width : 0.19 * room.width;
    room.x += tree.width + gap, room.width -= tree.width + gap;
  }
  constexpr double tree_share = 0.34;
  const int columns = columns_for(frames, room.width, room.height, has_one_tree ? 0 : tree_share, aspect);
  const int rows = (frames + columns - 1) / columns;
  const double across = (room.width - (columns - 1) * gap) / columns;
  const double down = (room.height - (rows - 1) * gap) / rows;
  for (int i = 0; i < frames; ++i) {
    const double x = room.x + (i % columns) * (across + gap), y = room.y + (i / columns) * (down + gap);
    const double head_height = frames == 1 && has_one_tree ? 0 : head;
    FramePlace place{tree, {x, y + head_height, across, down - head_height}, y + 13};
    if (!has_one_tree) {
      place.tree = {x, y + head, std::clamp(tree_share * across, 150.0, 330.0), down - head};
      place.space.x += place.tree.width + 10, place.space.width -= place.tree.width + 10;
    }
    frames_.push_back(place);
    tree = {};
  }
}

}  // namespace sightline::viz
