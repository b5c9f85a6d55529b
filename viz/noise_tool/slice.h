#pragma once

#include <filesystem>

#include "sightline/io/image_file.h"
#include "viz/noise_tool/request.h"

namespace sightline::noise_tool {

/// Whether files of this name hold values as they are, as EXR and TIFF do, or colors from 0 to 1.
bool holds_values(const std::filesystem::path& path);

/// Noise on a plane of constant z, a value a pixel, at the pixels' middles. x grows to the right and y upwards.
Image slice_of(const NoiseField& field, const Request& request);

/// -1 to 1 of noise, or 0 to the sum of all amplitudes where nothing is below 0, become 0 to 1, to the eye linearly.
void map_to_colors(Image& image, const NoiseField& field);

/// \throws FileError
void write_slice(const NoiseField& field, const Request& request);

}  // namespace sightline::noise_tool
