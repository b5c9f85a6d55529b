#pragma once
/// A step of a construction as a picture: the node in space, and beside it the chart of what was weighed.

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <filesystem>

#include "viz/build/build_step.h"
#include "viz/space_camera.h"

namespace sightline::viz {

struct BuildLook {
  double azimuth = 24, elevation = 20, zoom = 1;
  int width = 1920, height = 1080;
};

/// What brings a picture back.
std::string command_of(const BuildStep& step, const BuildLook& look);

struct BuildPicture {
  static constexpr int lowest_width = 1200, lowest_height = 675;  ///< Below, text would not be read.

  const BuildStory& story;
  const BuildStep& step;
  BuildLook look;

  /// Replaces what the window shows. `scale` enlarges text and lines, for drawing larger than the picture will be.
  void show_in(vtkRenderWindow& window, double scale) const;
  /// Needs a display (see PictureScreen) while it runs.
  void write_png(const std::filesystem::path& path) const;
};

}  // namespace sightline::viz
