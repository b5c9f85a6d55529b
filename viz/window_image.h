#pragma once

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <filesystem>
#include <functional>

namespace sightline::viz {

/// Writes a picture of this size, which `show(window, scale)` puts into a window of `scale` times as many pixels. Needs
/// a display (see PictureScreen) while it runs.
void write_picture(const std::filesystem::path& path, int width, int height,
                   const std::function<void(vtkRenderWindow&, int)>& show);

/// Writes the charts and flat shapes of a renderer as a drawing of this size; what is in space is left out. Needs a
/// display (see PictureScreen) while it runs.
void write_svg(const std::filesystem::path& path, vtkRenderer& renderer, int width, int height);

}  // namespace sightline::viz
