#pragma once

#include <vtkRenderWindow.h>

#include <filesystem>
#include <string>

#include "sightline/texture/texture.h"

namespace sightline::viz {

/// A block of a texture and a section across it; or the course's sheet for tuning wood: its texture frequency, noise
/// frequency and noise amplitude from 1 to 3, each with the other two as they are.
struct WoodPicture {
  static constexpr int lowest_width = 800, lowest_height = 500;

  std::string spec;  ///< Of make_texture.
  bool is_tuning = false;
  int width, height;  ///< Pixels.

  /// Replaces what the window shows. `scale` is the number of the window's pixels for each of the picture's.
  /// \throws std::invalid_argument for a spec that is wrong, or for tuning what is no wood.
  void show_in(vtkRenderWindow& window, int scale) const;

  /// Needs a display (see PictureScreen) while it runs.
  void write_png(const std::filesystem::path& path) const;
};

}  // namespace sightline::viz
