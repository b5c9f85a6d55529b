#include "sightline/io/layered_image.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "sightline/io/file_error.h"
#include "tests/io/temporary_folder.h"

namespace sightline {
namespace {

LayeredImage image_of(std::vector<std::string> channels, int width, int height) {
  LayeredImage image{width, height, std::move(channels), {}, false, {}};
  for (std::size_t i = 0; i < image.channels.size() * std::size_t(width) * std::size_t(height); ++i) {
    image.pixels.push_back(static_cast<float>(i) / 7 - 2);
  }
  image.attributes = {{"Software", "Sightline"}, {"ImageDescription", "scene a; samples 3"}, {"sightline:scene", "a"}};
  return image;
}

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(LayeredImage, ExrKeepsChannelsByNameAndAttributes) {
  const TemporaryFolder folder;
  LayeredImage image = image_of({"R", "G", "B", "Z", "N.X", "N.Y", "N.Z", "id"}, 5, 3);
  image.pixels[3] = std::numeric_limits<float>::infinity();
  const auto path = folder.path() / "a.exr";
  write_layers(path, image);
  const auto reader = OIIO::ImageInput::open(path.string());
  ASSERT_TRUE(reader);
  const OIIO::ImageSpec spec = reader->spec();
  ASSERT_EQ(spec.nchannels, 8);
  EXPECT_EQ(spec.format, OIIO::TypeDesc::FLOAT);
  EXPECT_EQ(spec.get_string_attribute("sightline:scene"), "a");
  EXPECT_EQ(spec.get_string_attribute("Software"), "Sightline");
  EXPECT_EQ(spec.get_string_attribute("ImageDescription"), "scene a; samples 3");
  EXPECT_EQ(spec.find_attribute("DateTime"), nullptr);
  std::vector<float> pixels(image.pixels.size());
  ASSERT_TRUE(reader->read_image(0, 0, 0, 8, OIIO::TypeDesc::FLOAT, pixels.data()));
  for (std::size_t channel = 0; channel < 8; ++channel) {
    const auto found = static_cast<std::size_t>(spec.channelindex(image.channels[channel]));
    ASSERT_LT(found, 8u) << image.channels[channel];
    for (std::size_t i = 0; i < 15; ++i) EXPECT_EQ(pixels[8 * i + found], image.pixels[8 * i + channel]);
  }
}

TEST(LayeredImage, TiffKeepsFloatsInOrder) {
  const TemporaryFolder folder;
  const LayeredImage image = image_of({"R", "G", "B", "Z", "id"}, 4, 4);
  const auto path = folder.path() / "a.tif";
  write_layers(path, image);
  const auto reader = OIIO::ImageInput::open(path.string());
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->spec().get_string_attribute("ImageDescription"), "scene a; samples 3");
  std::vector<float> pixels(image.pixels.size());
  ASSERT_TRUE(reader->read_image(0, 0, 0, 5, OIIO::TypeDesc::FLOAT, pixels.data()));
  EXPECT_EQ(pixels, image.pixels);
}

TEST(LayeredImage, PngIsEncodedOnce) {
  const TemporaryFolder folder;
  LayeredImage image{2, 1, {"R", "G", "B"}, {0, 0.5f, 1, -1, 2, std::nanf("")}, false, {{"Software", "Sightline"}}};
  const auto bytes = [&](bool is_encoded) {
    image.is_encoded = is_encoded;
    write_layers(folder.path() / "a.png", image);
    const auto reader = OIIO::ImageInput::open((folder.path() / "a.png").string());
    EXPECT_EQ(reader->spec().get_string_attribute("Software"), "Sightline");
    std::vector<std::uint8_t> read(6);
    EXPECT_TRUE(reader->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, read.data()));
    return read;
  };
  EXPECT_EQ(bytes(false), (std::vector<std::uint8_t>{0, 188, 255, 0, 255, 0}));
  EXPECT_EQ(bytes(true)[1], 128);
}

TEST(LayeredImage, SamePictureSameBytes) {
  const TemporaryFolder folder;
  const LayeredImage image = image_of({"R", "G", "B"}, 8, 8);
  const std::vector<std::string> extensions{".exr", ".png", ".tif"};
  for (const auto& extension : extensions) write_layers(folder.path() / ("a" + extension), image);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // dates would count seconds
  for (const auto& extension : extensions) {
    write_layers(folder.path() / ("b" + extension), image);
    EXPECT_EQ(contents(folder.path() / ("a" + extension)), contents(folder.path() / ("b" + extension))) << extension;
  }
}

TEST(LayeredImage, RefusesWhatIsNoPicture) {
  const TemporaryFolder folder;
  LayeredImage image = image_of({"R", "G", "B"}, 2, 2);
  EXPECT_THROW(write_layers(folder.path() / "a.doc", image), FileError);
  EXPECT_THROW(write_layers("/dev/null/a.png", image), FileError);
  image.pixels.pop_back();
  EXPECT_THROW(write_layers(folder.path() / "a.png", image), std::invalid_argument);
  EXPECT_THROW(write_layers(folder.path() / "a.png", LayeredImage{}), std::invalid_argument);
  EXPECT_EQ(folder.count(), 0);
}

}  // namespace
}  // namespace sightline
