#pragma once
/// Where what stands in the picture of a scene graph. Lengths are in units, of which a picture of 1600x1000 is made.

#include <vector>

#include "viz/noise/panel.h"

namespace sightline::viz {

struct FramePlace {
  PanelFrame tree;  ///< Empty where one tree serves all frames, but for the first.
  PanelFrame space;
  double head;  ///< The middle of the frame's title, in y; text below it.
};

class GraphLayout {
 public:
  static constexpr int lowest_width = 800, lowest_height = 500;
  static constexpr double margin = 28, top = 92, bottom = 62;

  /// Of a picture in pixels. With `has_one_tree` the tree is left of all frames, otherwise in each of them.
  /// `aspect` is the width over the height of what is in space.
  GraphLayout(int width, int height, int frames, bool has_one_tree, double aspect);

  double unit() const { return unit_; }  ///< Pixels.
  double width() const { return width_; }
  double height() const { return height_; }
  const std::vector<FramePlace>& frames() const { return frames_; }

 private:
  double unit_, width_, height_;
  std::vector<FramePlace> frames_;
};

}  // namespace sightline::viz
