#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace sightline {

/// A picture of any number of channels, and what is told of it. Channels that are named R, G, B or Y are colors:
/// linear, 0 is black, 1 is white. Those of a layer are named as EXR does: "N.X".
struct LayeredImage {
  int width = 0, height = 0;
  std::vector<std::string> channels;
  std::vector<float> pixels;  ///< Row by row from the top, the channels of a pixel together.
  bool is_encoded = false;    ///< Colors are what screens take (sRGB), not linear.
  std::vector<std::pair<std::string, std::string>> attributes;  ///< Name and text, as OpenImageIO names them.
};

/// Whether the format that the extension stands for keeps floats as they are: EXR, TIFF and the like. The others get
/// sRGB-encoded 8-bit colors, held within [0, 1], NaN as black.
bool holds_floats(const std::filesystem::path& path);

/// The format follows the extension, as OpenImageIO knows it. The same picture gives the same bytes: no date is
/// written. TIFF keeps no names of channels, and of attributes only those of its own, such as "ImageDescription".
/// \throws FileError, and std::invalid_argument where the image's sizes contradict each other.
void write_layers(const std::filesystem::path& path, const LayeredImage& image);

/// The first line of what OpenImageIO says, whose texts may have several and name the temporary file.
std::string first_line(const std::string& message);

}  // namespace sightline
