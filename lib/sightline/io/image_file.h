#pragma once

#include <filesystem>
#include <vector>

namespace sightline {

/// Pixels row by row from the top, the channels of a pixel together. Colors are linear: 0 is black, 1 is white; alpha
/// does not scale them.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;           ///< 1 gray, 2 gray and alpha, 3 color, 4 color and alpha.
  std::vector<float> pixels;  ///< width * height * channels
};

/// The format follows the extension, as OpenImageIO knows it. Formats of integers (PNG, JPEG, ...) get sRGB-encoded
/// 8-bit colors, clamped to [0, 1], NaN as black; formats of floats (EXR, TIFF, ...) get the linear values as they are.
/// Throws FileError, and std::invalid_argument when the image's sizes contradict each other.
void write_image(const std::filesystem::path& path, const Image& image);

/// Colors of sRGB-encoded files become linear. Throws FileError.
Image read_image(const std::filesystem::path& path);

}  // namespace sightline
