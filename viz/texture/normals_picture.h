#pragma once

#include <vtkRenderWindow.h>

#include <array>
#include <filesystem>
#include <string>

#include "viz/texture/dented_sphere.h"

namespace sightline::viz {

/// A sphere as it is, with dented normals, and with dents in truth: shaded, as silhouettes, and what each costs.
struct NormalsPicture {
  static constexpr int lowest_width = 800, lowest_height = 500;

  /// Paints the three at once, as large as the picture of this size shows them.
  NormalsPicture(const Dents& dents, int divisions, int width, int height);

  int width, height;  ///< Pixels.

  /// Replaces what the window shows. `scale` is the number of the window's pixels for each of the picture's. Counts are
  /// in the picture, times are not: so it is the same whenever it is drawn.
  void show_in(vtkRenderWindow& window, int scale) const;

  /// Needs a display (see PictureScreen) while it runs.
  void write_png(const std::filesystem::path& path) const;

  /// What each took, with times.
  std::string table() const;

 private:
  double unit() const;

  double amplitude_;
  std::array<DentedSphere, 3> spheres_;
};

}  // namespace sightline::viz
