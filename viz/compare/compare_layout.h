#pragma once
/// Where the parts of a comparison are.

#include <vector>

#include "viz/noise/panel.h"

namespace sightline::viz {

/// Pixels of the picture, from its top left corner.
struct PixelFrame {
  int x = 0, y = 0, width = 0, height = 0;

  bool contains(int px, int py) const { return px >= x && px < x + width && py >= y && py < y + height; }
};

/// A panel a structure: two lines of text, below them its picture. All in units, of which a pixel is 1 / unit().
class CompareLayout {
 public:
  static constexpr int lowest_width = 960, lowest_height = 540;
  static constexpr double margin = 30, title_line = 38, verdict_line = 76;

  CompareLayout(int width, int height, std::size_t panels);

  double unit() const { return unit_; }  ///< Pixels.
  double width() const { return width_; }
  double height() const { return height_; }
  double legend_line() const { return height_ - 78; }
  double command_line() const { return height_ - 24; }

  const std::vector<PanelFrame>& panels() const { return panels_; }
  /// Of equal sizes, so that one camera suits all.
  const std::vector<PixelFrame>& pictures() const { return pictures_; }
  PanelFrame units(const PixelFrame& frame) const;

 private:
  double unit_, width_, height_;
  std::vector<PanelFrame> panels_;
  std::vector<PixelFrame> pictures_;
};

}  // namespace sightline::viz
