#pragma once
/// The tree of a scene graph as a part of a picture.

#include <optional>
#include <vector>

#include "viz/canvas.h"
#include "viz/graph/graph_space.h"

namespace sightline::viz {

/// Rows, and where they are; in the canvas's units.
class TreePanel {
 public:
  TreePanel(const DrawnScene& drawn, NodeId focus, const PanelFrame& panel);

  void draw(Canvas& canvas, const GraphFrame& frame, const GraphLook& look) const;

  /// The node whose row is there.
  std::optional<NodeId> node_at(const Canvas::Point& at) const;
  const std::vector<TreeRow>& rows() const { return rows_; }

 private:
  class Drawing;

  double x_of(const TreeRow& row) const { return panel_.x + 12 + row.indent * step_; }
  double y_of(std::size_t row) const { return panel_.y + (double(row) + 0.5) * height_; }

  const DrawnScene& drawn_;
  PanelFrame panel_;
  std::vector<TreeRow> rows_;
  double height_ = 0, step_ = 0;
};

}  // namespace sightline::viz
