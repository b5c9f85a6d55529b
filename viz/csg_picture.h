#pragma once

#include <vtkRenderWindow.h>

#include <filesystem>
#include <optional>
#include <string>

#include "viz/csg_layout.h"
#include "viz/csg_trace.h"

namespace sightline::viz {

/// A solid in space with its operands as ghosts and a ray, and beside it the ray's interval ladder under a section
/// through the ray, whose t runs as the ladder's does.
struct CsgPicture {
  const LadderSolid& solid;
  Ladder ladder;
  std::string name, description;
  int width, height;  ///< Pixels.

  /// Replaces what the window shows. `scale` is the number of the window's pixels for each of the picture's.
  void show_in(vtkRenderWindow& window, int scale) const;

  /// Needs a display (see PictureScreen) while it runs.
  void write_png(const std::filesystem::path& path) const;
};

/// The ray through the middle of a pixel, counted from the top left corner, of a picture of this size; nothing outside
/// of the panel that shows the solid.
std::optional<Ray<double>> ray_through_pixel(const LadderSolid& solid, int width, int height, int x, int y);

}  // namespace sightline::viz
