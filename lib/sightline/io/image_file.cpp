#include "sightline/io/image_file.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>

#include "sightline/io/file_bytes.h"
#include "sightline/io/file_error.h"
#include "sightline/io/layered_image.h"
#include "sightline/io/srgb.h"

namespace sightline {
namespace {

/// Alpha is never encoded.
bool is_color(std::size_t i, int channels) {
  const bool has_alpha = channels == 2 || channels == 4;
  return !has_alpha || i % static_cast<std::size_t>(channels) != static_cast<std::size_t>(channels - 1);
}

void check(const Image& image) {
  if (image.width < 1 || image.height < 1 || image.channels < 1 || image.channels > 4) {
    throw std::invalid_argument("an image is at least 1 x 1 pixels of 1 to 4 channels, not " +
                                std::to_string(image.width) + " x " + std::to_string(image.height) + " of " +
                                std::to_string(image.channels));
  }
  const std::size_t count = std::size_t(image.width) * std::size_t(image.height) * std::size_t(image.channels);
  if (image.pixels.size() != count) {
    throw std::invalid_argument("an image of this size has " + std::to_string(count) + " values, not " +
                                std::to_string(image.pixels.size()));
  }
}

}  // namespace

void write_image(const std::filesystem::path& path, const Image& image) {
  static const std::array<std::vector<std::string>, 4> names{
      {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}}};
  check(image);
  const std::vector<std::string>& channels = names[static_cast<std::size_t>(image.channels - 1)];
  write_layers(path, {image.width, image.height, channels, image.pixels, false, {}});
}

Image read_image(const std::filesystem::path& path) {
  read_bytes(path);  // says what is wrong with it as a file
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);  // nor multiplied by it
  const std::unique_ptr<OIIO::ImageInput> reader = OIIO::ImageInput::open(path.string(), &wishes);
  if (!reader) throw FileError(path, 0, "an image", first_line(OIIO::geterror()));
  const OIIO::ImageSpec& spec = reader->spec();
  // Wider or deeper ones are beyond what a picture or a texture is, and beyond int.
  constexpr int longest = 1 << 16;
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.width > longest || spec.height > longest ||
      std::int64_t{spec.width} * spec.height > (std::int64_t{1} << 28)) {
    throw FileError(path, 0, "an image of at most 2^28 pixels",
                    std::to_string(spec.width) + " x " + std::to_string(spec.height));
  }
  Image image{spec.width, spec.height, std::min(spec.nchannels, 4), {}};
  image.pixels.resize(std::size_t(image.width) * std::size_t(image.height) * std::size_t(image.channels));
  const bool is_encoded = spec.get_string_attribute("oiio:ColorSpace") == "sRGB";
  if (!reader->read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, image.pixels.data())) {
    throw FileError(path, 0, "a whole image", first_line(reader->geterror()));
  }
  for (std::size_t i = 0; i < image.pixels.size() && is_encoded; ++i) {
    if (is_color(i, image.channels)) image.pixels[i] = decode_srgb(image.pixels[i]);
  }
  return image;
}

}  // namespace sightline
