#include "sightline/io/layered_image.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "sightline/io/file_error.h"
#include "sightline/io/output_file.h"
#include "sightline/io/srgb.h"

namespace sightline {
namespace {

bool is_color(std::string_view channel) { return channel == "R" || channel == "G" || channel == "B" || channel == "Y"; }

void check(const LayeredImage& image) {
  if (image.width < 1 || image.height < 1 || image.channels.empty()) {
    throw std::invalid_argument("an image is at least 1 x 1 pixels of 1 channel, not " + std::to_string(image.width) +
                                " x " + std::to_string(image.height) + " of " + std::to_string(image.channels.size()));
  }
  const std::size_t count = std::size_t(image.width) * std::size_t(image.height) * image.channels.size();
  if (image.pixels.size() != count) {
    throw std::invalid_argument("an image of this size has " + std::to_string(count) + " values, not " +
                                std::to_string(image.pixels.size()));
  }
}

std::vector<float> encoded(const LayeredImage& image) {
  std::vector<float> pixels = image.pixels;
  for (std::size_t channel = 0; channel < image.channels.size(); ++channel) {
    if (!is_color(image.channels[channel])) continue;
    for (std::size_t i = channel; i < pixels.size(); i += image.channels.size()) pixels[i] = encode_srgb(pixels[i]);
  }
  return pixels;
}

}  // namespace

bool holds_floats(const std::filesystem::path& path) {
  constexpr auto extensions = std::to_array<std::string_view>({".exr", ".tif", ".tiff", ".hdr", ".pfm"});
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

std::string first_line(const std::string& message) {
  return message.empty() ? "a failure of OpenImageIO" : message.substr(0, message.find('\n'));
}

void write_layers(const std::filesystem::path& path, const LayeredImage& image) {
  check(image);
  const std::unique_ptr<OIIO::ImageOutput> writer = OIIO::ImageOutput::create(path.string());
  if (!writer) {
    OIIO::geterror();  // else it would be printed when the program ends
    throw FileError(path, 0, "an extension of an image format such as .png or .exr",
                    path.extension().empty() ? "none" : path.extension().string());
  }
  const bool floats = holds_floats(path);
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                       floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  spec.channelnames = image.channels;
  const auto alpha = std::find(image.channels.begin(), image.channels.end(), "A");
  spec.alpha_channel = alpha == image.channels.end() ? -1 : static_cast<int>(alpha - image.channels.begin());
  spec.attribute("oiio:ColorSpace", floats ? "Linear" : "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);  // colors are stored as they are, not divided by alpha
  spec.attribute("DateTime", "");               // none: that of writing would be there otherwise
  for (const auto& [name, text] : image.attributes) spec.attribute(name, text);

  OutputFile output(path);
  const std::vector<float> pixels = floats || image.is_encoded ? image.pixels : encoded(image);
  const bool written = writer->open(output.temporary().string(), spec) &&
                       writer->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && writer->close();
  if (!written) throw FileError(path, 0, "an image that can be written", first_line(writer->geterror()));
  output.commit();
}

}  // namespace sightline
