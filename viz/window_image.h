#pragma once

#include <vtkRenderWindow.h>

#include <filesystem>

namespace sightline::viz {

/// Writes what the window shows, each `oversampling` x `oversampling` pixels averaged to one, as light adds.
void write_window(vtkRenderWindow& window, int oversampling, const std::filesystem::path& path);

}  // namespace sightline::viz
