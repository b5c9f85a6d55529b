#pragma once

#include <vtkRenderWindow.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

#include "viz/noise/flat_panels.h"

namespace sightline::viz {

enum class NoisePanel { slice, gradients, lattice, ease, spectrum, coherence, isosurfaces, volume };

struct NoisePanelInfo {
  NoisePanel panel;
  std::string_view name;
  std::string_view description;
};
inline constexpr std::array<NoisePanelInfo, 8> noise_panel_infos{{
    {NoisePanel::slice, "slice", "values in a plane, as colors"},
    {NoisePanel::gradients, "gradients", "the analytic gradient, as arrows"},
    {NoisePanel::lattice, "lattice", "the gradients of a cell's corners, and what they give to a point"},
    {NoisePanel::ease, "ease", "the ease curve with its slope and curvature"},
    {NoisePanel::spectrum, "spectrum", "how much of the variance lies at which frequency"},
    {NoisePanel::coherence, "coherence", "white noise beside this noise"},
    {NoisePanel::isosurfaces, "isosurfaces", "surfaces of equal value in space"},
    {NoisePanel::volume, "volume", "values in space, as a mist"},
}};

/// Everything about a kind of noise on one sheet, or one panel of it.
struct NoisePicture {
  static constexpr int lowest_width = 800, lowest_height = 500;

  NoiseLook look;
  std::optional<NoisePanel> only;
  int width, height;  ///< Pixels.

  /// Replaces what the window shows. `scale` is the number of the window's pixels for each of the picture's.
  void show_in(vtkRenderWindow& window, int scale) const;

  /// Needs a display (see PictureScreen) while it runs.
  void write_png(const std::filesystem::path& path) const;
};

}  // namespace sightline::viz
