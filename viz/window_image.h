#pragma once

#include <vtkRenderWindow.h>

#include <filesystem>
#include <functional>

namespace sightline::viz {

/// Writes a picture of this size, which `show(window, scale)` puts into a window of `scale` times as many pixels. Needs
/// a display (see PictureScreen) while it runs.
void write_picture(const std::filesystem::path& path, int width, int height,
                   const std::function<void(vtkRenderWindow&, int)>& show);

}  // namespace sightline::viz
