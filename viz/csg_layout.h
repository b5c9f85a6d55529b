#pragma once
/// Where what stands in the picture of an interval ladder. Lengths are in units, of which a picture of 1600x900 is
/// made.

#include <vector>

#include "viz/canvas.h"
#include "viz/csg_ladder.h"

namespace sightline::viz {

/// The part of the picture that shows the solid in space, in pixels; it depends on nothing but the picture's size.
struct SolidPanel {
  int x, y, width, height;
};

class CsgLayout {
 public:
  static constexpr int lowest_width = 800, lowest_height = 450;

  /// Pixels.
  CsgLayout(int width, int height);

  double unit() const { return unit_; }  ///< Pixels.
  double width() const { return width_; }
  double height() const { return height_; }
  SolidPanel panel() const;

  // In units.
  static constexpr double margin = 28, top = 96, bottom = 84, tree_width = 262;
  double panel_width() const { return 0.355 * width_; }
  double tree_left() const { return 2 * margin + panel_width(); }
  double bars_left() const { return tree_left() + tree_width; }
  double bars_right() const { return width_ - margin - 14; }

 private:
  double unit_, width_, height_;
};

/// A row as it is drawn: of all if they fit, otherwise without operands that the ray misses.
struct ShownRow {
  std::size_t row;  ///< Of the ladder.
  int depth;
  char role;
  int parent;  ///< Of the rows shown, or -1.
  double y, height;
};

struct LadderLayout {
  std::vector<ShownRow> rows;
  std::size_t missed = 0;  ///< Primitives left out because the ray misses them.
  std::size_t cut = 0;     ///< Rows left out for want of room.
  double scale = 1;        ///< Of rows and their text.
  double section_height = 0;
  double rows_top = 0, rows_bottom = 0;
  double t_min = 0, t_max = 1;
  bool has_origin = true;  ///< t = 0 lies within.

  double x_of(const CsgLayout& layout, double t) const {
    return layout.bars_left() + (t - t_min) / (t_max - t_min) * (layout.bars_right() - layout.bars_left());
  }
};

LadderLayout lay_out(const CsgLayout& layout, const Ladder& ladder, const LadderSolid& solid);

}  // namespace sightline::viz
