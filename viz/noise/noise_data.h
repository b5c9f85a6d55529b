#pragma once

#include <filesystem>

#include "viz/noise/field_grid.h"

namespace sightline::viz {

/// Values of a cube as an image of VTK, whole or not at all. \throws FileError
void write_vti(const std::filesystem::path& path, const FieldCube& cube);

}  // namespace sightline::viz
