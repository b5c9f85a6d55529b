#pragma once

#include <filesystem>

#include "viz/drawing/drawing.h"

namespace sightline::viz {

struct DrawingSize {
  static constexpr int least_width = 480, least_height = 360;
  int width = 1200, height = 900;
};

/// Draws the panels side by side, on white. What is not finite is left out, and the caption says so. Needs a display
/// (see PictureScreen).
void write_drawing_png(const std::filesystem::path& path, const Drawing& drawing, const DrawingSize& size);

}  // namespace sightline::viz
