#include "sightline/io/image_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "sightline/io/file_error.h"
#include "tests/io/temporary_folder.h"

namespace sightline {
namespace {

Image ramp(int channels) {
  Image image{16, 9, channels, {}};
  for (int i = 0; i < 16 * 9 * channels; ++i)
    image.pixels.push_back(static_cast<float>(i) / static_cast<float>(16 * 9 * channels));
  return image;
}

TEST(ImageFile, FloatsComeBackAsTheyWere) {
  const TemporaryFolder folder;
  for (const char* name : {"a.exr", "a.tif"}) {
    for (int channels : {1, 3, 4}) {
      const Image image = ramp(channels);
      write_image(folder.path() / name, image);
      const Image read = read_image(folder.path() / name);
      EXPECT_EQ(read.width, 16);
      EXPECT_EQ(read.height, 9);
      EXPECT_EQ(read.channels, channels);
      EXPECT_EQ(read.pixels, image.pixels) << name << channels;
    }
  }
  EXPECT_EQ(folder.count(), 2);
}

TEST(ImageFile, PngKeepsColorsAsNearAsItsStepsAllow) {
  const TemporaryFolder folder;
  for (int channels : {1, 2, 3, 4}) {
    const Image image = ramp(channels);
    write_image(folder.path() / "a.png", image);
    const Image read = read_image(folder.path() / "a.png");
    ASSERT_EQ(read.channels, channels);
    // A step of 1/255 is at most 2.4 times as wide in linear color, at white; half of it is the error.
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      EXPECT_NEAR(read.pixels[i], image.pixels[i], 1.2 * 1.055 / 255) << channels << " " << i;
    }
  }
}

TEST(ImageFile, PngIsEncodedAsSrgbAndClamped) {
  const TemporaryFolder folder;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  write_image(folder.path() / "a.png", {5, 1, 1, {0.5f, -1, 7, nan, 1}});
  const Image read = read_image(folder.path() / "a.png");
  EXPECT_NEAR(read.pixels[0], 0.5f, 0.004f);
  EXPECT_EQ(read.pixels[1], 0);
  EXPECT_EQ(read.pixels[2], 1);
  EXPECT_EQ(read.pixels[3], 0);
  EXPECT_EQ(read.pixels[4], 1);
}

TEST(ImageFile, WhatCannotBeWrittenLeavesNothing) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_image(folder.path() / "a.xyz", ramp(3)), FileError);
  EXPECT_THROW(write_image(folder.path() / "a", ramp(3)), FileError);
  EXPECT_THROW(write_image("/proc/none/a.png", ramp(3)), FileError);
  EXPECT_THROW(write_image(folder.path(), ramp(3)), FileError);
  EXPECT_THROW(write_image(folder.path() / "a.png", {4, 4, 3, {1, 2}}), std::invalid_argument);
  EXPECT_THROW(write_image(folder.path() / "a.png", {0, 4, 3, {}}), std::invalid_argument);
  EXPECT_EQ(folder.count(), 0);
}

TEST(ImageFile, BrokenImagesAreRefused) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_image(folder.path() / "none.png"), FileError);
  EXPECT_THROW(read_image(folder.path()), FileError);
  EXPECT_THROW(read_image(folder.write("empty.png", "")), FileError);
  EXPECT_THROW(read_image(folder.write("noise.png", "this is no image")), FileError);
  write_image(folder.path() / "whole.exr", ramp(3));
  const auto size = std::filesystem::file_size(folder.path() / "whole.exr");
  std::filesystem::resize_file(folder.path() / "whole.exr", size / 2);
  EXPECT_THROW(read_image(folder.path() / "whole.exr"), FileError);
}

}  // namespace
}  // namespace sightline
