#include "viz/graph/tree_panel.h"

#include <algorithm>
#include <cmath>

#include "viz/material_color.h"
#include "viz/paper.h"
#include "viz/partition_picture.h"

namespace sightline::viz {
namespace {

using Point = Canvas::Point;

constexpr double lowest_row = 19.5, highest_row = 25, widest_step = 17, name_room = 96;

}  // namespace

class TreePanel::Drawing {
 public:
  Drawing(const TreePanel& tree, Canvas& canvas, const GraphFrame& frame, const GraphLook& look)
      : tree_(tree), canvas_(canvas), frame_(frame), look_(look), numbers_(tree.drawn_.graph.size(), 0) {
    for (std::size_t i = 0; i < frame.told.size(); ++i) numbers_[frame.told[i]] = i + 1;
  }

  void run() {
    for (std::size_t i = 0; i < tree_.rows_.size(); ++i) draw_band(i);
    for (std::size_t i = 0; i < tree_.rows_.size(); ++i) draw_branch(i);
    for (std::size_t i = 0; i < tree_.rows_.size(); ++i) draw_row(i);
  }

 private:
  bool is_told(NodeId node) const { return numbers_[node] > 0; }
  bool is_numbered() const { return frame_.moved != no_node; }

  /// Below the node that was moved, and so moved as well, but not told of it.
  bool is_carried(NodeId node) const {
    if (!is_numbered() || is_told(node)) return false;
    const SceneGraph& graph = tree_.drawn_.graph;
    while (node != no_node && node != frame_.moved) node = graph.parent(node);
    return node == frame_.moved;
  }

  void draw_band(std::size_t i) {
    const NodeId node = tree_.rows_[i].node;
    if (node == no_node) return;
    const bool is_selected = node == look_.selected && node != root_node;
    if (!is_selected && !is_told(node)) return;
    const double share = is_selected ? 0.2 : is_numbered() ? 0.1 : 0.07;
    canvas_.rectangle({tree_.panel_.x, tree_.y_of(i) - tree_.height_ / 2 + 0.5}, tree_.panel_.width, tree_.height_ - 1,
                      diluted(accent, share));
  }

  void draw_branch(std::size_t i) {
    const TreeRow& row = tree_.rows_[i];
    if (row.parent < 0) return;
    const auto above = static_cast<std::size_t>(row.parent);
    const double x = tree_.x_of(tree_.rows_[above]), y = tree_.y_of(i);
    // The way that an event has gone.
    const bool is_way = is_numbered() && row.node != no_node && is_told(row.node) &&
                        tree_.rows_[above].node != no_node && is_told(tree_.rows_[above].node);
    const Rgb& color = is_way ? accent : faint_ink;
    const double width = is_way ? 2 : 1.2;
    canvas_.line({x, tree_.y_of(above) + 7}, {x, y}, width, color);
    canvas_.line({x, y}, {tree_.x_of(row) - 7, y}, width, color);
  }

  void draw_row(std::size_t i) {
    const TreeRow& row = tree_.rows_[i];
    const double x = tree_.x_of(row), y = tree_.y_of(i), right = tree_.panel_.x + tree_.panel_.width;
    if (row.node == no_node) {
      canvas_.text({x - 6, y}, counted(row.hidden, "node") + " more", {13, soft_ink});
      return;
    }
    const NodeId node = row.node;
    const SceneGraph& graph = tree_.drawn_.graph;
    const std::uint32_t depth = tree_.drawn_.shape.depths[node];
    if (is_nothing(frame_.bounds->bounds[node])) {
      canvas_.ring({x, y}, 4, 1.4, faint_ink);
    } else {
      canvas_.rectangle({x - 5.5, y - 5.5}, 11, 11, color_of_depth(depth, look_.deepest));
    }
    const bool is_selected = node == look_.selected && node != root_node;
    const bool has_mark = is_numbered() && (is_told(node) || is_carried(node));
    Canvas::TextStyle style{14.5, is_selected ? accent : ink, Canvas::Align::left, is_selected};
    if (is_nothing(frame_.bounds->bounds[node])) style.color = soft_ink;
    std::string name = node == root_node ? "/ (root)" : graph.name(node);
    if (name.empty()) name = "#" + std::to_string(node);
    const std::string below = row.hidden == 0 ? "" : "+" + with_commas(row.hidden);
    const Canvas::TextStyle below_style{13, soft_ink};
    const double below_width = below.empty() ? 0 : canvas_.text_width(below, below_style) + 8;
    name = canvas_.shortened(name, style, right - (x + 11) - below_width - (has_mark ? 28 : 4));
    canvas_.text({x + 11, y}, name, style);
    if (!below.empty()) canvas_.text({x + 11 + canvas_.text_width(name, style) + 8, y}, below, below_style);
    if (!has_mark) return;
    if (is_told(node)) {
      draw_number(canvas_, {right - 13, y}, numbers_[node], numbers_[node] == frame_.told.size());
    } else {
      canvas_.ring({right - 13, y}, 5, 2, soft_ink);
    }
  }

  const TreePanel& tree_;
  Canvas& canvas_;
  const GraphFrame& frame_;
  const GraphLook& look_;
  std::vector<std::size_t> numbers_;  ///< By node, of those that an event has passed, from 1.
};

TreePanel::TreePanel(const DrawnScene& drawn, NodeId focus, const PanelFrame& panel)
    : drawn_(drawn),
      panel_(panel),
      rows_(tree_rows(drawn.graph, drawn.shape, focus,
                      static_cast<std::size_t>(std::max(8.0, std::floor(panel.height / lowest_row))))) {
  height_ = std::min(highest_row, panel.height / double(std::max<std::size_t>(rows_.size(), 1)));
  int deepest = 1;
  for (const TreeRow& row : rows_) deepest = std::max(deepest, row.indent);
  step_ = std::min(widest_step, std::max(3.0, (panel.width - name_room) / deepest));
}

void TreePanel::draw(Canvas& canvas, const GraphFrame& frame, const GraphLook& look) const {
  Drawing(*this, canvas, frame, look).run();
}

std::optional<NodeId> TreePanel::node_at(const Point& at) const {
  if (at.x < panel_.x || at.x >= panel_.x + panel_.width || at.y < panel_.y) return std::nullopt;
  const auto row = static_cast<std::size_t>((at.y - panel_.y) / height_);
  if (row >= rows_.size() || rows_[row].node == no_node) return std::nullopt;
  return rows_[row].node;
}

}  // namespace sightline::viz
