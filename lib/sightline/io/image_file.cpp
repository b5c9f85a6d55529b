#include "sightline/io/image_file.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <stdexcept>
#include <string>

#include "sightline/io/file_bytes.h"
#include "sightline/io/file_error.h"
#include "sightline/io/output_file.h"
#include "sightline/io/srgb.h"

namespace sightline {
namespace {

/// Alpha is never encoded.
bool is_color(std::size_t i, int channels) {
  const bool has_alpha = channels == 2 || channels == 4;
  return !has_alpha || i % static_cast<std::size_t>(channels) != static_cast<std::size_t>(channels - 1);
}

bool holds_floats(const std::filesystem::path& path) {
  constexpr auto extensions = std::to_array<std::string_view>({".exr", ".tif", ".tiff", ".hdr", ".pfm"});
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

/// The first line of what OpenImageIO says, whose texts may have several and name the temporary file.
std::string first_line(const std::string& message) {
  return message.empty() ? "a failure of OpenImageIO" : message.substr(0, message.find('\n'));
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
  check(image);
  const std::unique_ptr<OIIO::ImageOutput> writer = OIIO::ImageOutput::create(path.string());
  if (!writer) {
    OIIO::geterror();  // else it would be printed when the program ends
    throw FileError(path, 0, "an extension of an image format such as .png or .exr",
                    path.extension().empty() ? "none" : path.extension().string());
  }
  const bool floats = holds_floats(path);
  std::vector<float> encoded = image.pixels;
  for (std::size_t i = 0; i < encoded.size() && !floats; ++i) {
    if (is_color(i, image.channels)) encoded[i] = encode_srgb(encoded[i]);
  }
  OIIO::ImageSpec spec(image.width, image.height, image.channels,
                       floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", floats ? "Linear" : "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);  // colors are stored as they are, not divided by alpha
  if (image.channels == 2) {
    spec.channelnames = {"Y", "A"};
    spec.alpha_channel = 1;
  }

  OutputFile output(path);
  const bool written = writer->open(output.temporary().string(), spec) &&
                       writer->write_image(OIIO::TypeDesc::FLOAT, encoded.data()) && writer->close();
  if (!written) throw FileError(path, 0, "an image that can be written", first_line(writer->geterror()));
  output.commit();
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
