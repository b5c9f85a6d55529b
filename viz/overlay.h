#pragma once

#include <vtkRenderer.h>

#include <string>
#include <vector>

#include "viz/coloring.h"

namespace sightline::viz {

/// Text and legend around a picture, placed in pixels of the picture (`scale` pixels of the window each).
struct Overlay {
  struct Line {
    std::string text;
    int size;
    bool is_bold = false;
    double gray = 0;
  };
  std::vector<Line> lines;  ///< At the top, one below the other.
  const Coloring& coloring;
  std::vector<std::size_t> counts;  ///< Cells shown of each level, from coloring.lowest().
  int width, height;
  double scale;

  static constexpr int top = 104;     ///< Height of the caption.
  static constexpr int legend = 150;  ///< Width of the legend at the right.

  void add_to(vtkRenderer& renderer) const;
};

}  // namespace sightline::viz
