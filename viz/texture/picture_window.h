#pragma once

#include <vtkRenderWindow.h>

#include <functional>
#include <string>

namespace sightline::viz {

/// Shows a picture that does not change until its window is closed.
void open_picture_window(const std::string& title, int width, int height,
                         const std::function<void(vtkRenderWindow&, int)>& show);

}  // namespace sightline::viz
