#include "viz/noise_tool/slice.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::noise_tool {
namespace {

template <class T>
void fill(const NoiseField& field, const Request& request, Image& image) {
  const Slice& slice = request.slice;
  // Cells are those of the first octave, so that the same extent shows as many of them at any frequency.
  const double pixel = slice.extent / request.field.frequency / slice.width;
  std::vector<glm::vec<3, T>> row(static_cast<std::size_t>(slice.width));
  std::vector<T> values(row.size());
  for (int y = 0; y < slice.height; ++y) {
    for (int x = 0; x < slice.width; ++x) {
      row[static_cast<std::size_t>(x)] =
          glm::dvec3(pixel * (x + 0.5 - 0.5 * slice.width), pixel * (0.5 * slice.height - 0.5 - y), slice.z);
    }
    field.values<3, T>(row, values, static_cast<T>(request.footprint));
    std::copy(values.begin(), values.end(), image.pixels.begin() + std::ptrdiff_t{y} * slice.width);
  }
}

}  // namespace

bool holds_values(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr auto extensions = std::to_array<std::string_view>({".exr", ".tif", ".tiff", ".hdr", ".pfm"});
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

Image slice_of(const NoiseField& field, const Request& request) {
  Image image{request.slice.width, request.slice.height, 1, {}};
  image.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  request.precision == Level::fast ? fill<float>(field, request, image) : fill<double>(field, request, image);
  return image;
}

void map_to_colors(Image& image, const NoiseField& field) {
  const FractalKind fractal = field.options().fractal;
  const bool is_signed = fractal == FractalKind::none || fractal == FractalKind::fbm;
  const float high = static_cast<float>(field.amplitude()), low = is_signed ? -high : 0;
  for (float& value : image.pixels) {
    const float share = std::clamp((value - low) / (high - low), 0.0f, 1.0f);
    // Files of colors encode what is linear; decoded here (IEC 61966-2-1), their numbers are the shares themselves.
    value = share <= 0.04045f ? share / 12.92f : std::pow((share + 0.055f) / 1.055f, 2.4f);
  }
}

void write_slice(const NoiseField& field, const Request& request) {
  Image image = slice_of(field, request);
  if (!holds_values(request.image)) map_to_colors(image, field);
  write_image(request.image, image);
}

}  // namespace sightline::noise_tool
