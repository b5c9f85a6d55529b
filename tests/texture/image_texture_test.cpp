#include "sightline/texture/image_texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "sightline/io/file_bytes.h"
#include "sightline/io/file_error.h"
#include "sightline/io/image_file.h"
#include "sightline/math/random.h"
#include "tests/io/temporary_folder.h"

namespace sightline {
namespace {

/// Every texel another color; rows from the top.
Image some_image(int width, int height, int channels = 3) {
  Image image{width, height, channels, {}};
  Random random(1);
  for (int i = 0; i < width * height * channels; ++i) image.pixels.push_back(random.uniform());
  return image;
}

Color texel(const Image& image, int column, int row_from_bottom) {
  const int row = image.height - 1 - row_from_bottom;
  Color color;
  for (int channel = 0; channel < 3; ++channel) {
    color[channel] = image.pixels[static_cast<std::size_t>((row * image.width + column) * image.channels +
                                                           (image.channels < 3 ? 0 : channel))];
  }
  return color;
}

class ImageTextureTest : public testing::Test {
 protected:
  std::filesystem::path write(const Image& image, const std::string& name = "image.exr") {
    write_image(folder_.path() / name, image);
    return folder_.path() / name;
  }

  void expect_error(const std::filesystem::path& path, const std::string& part) {
    try {
      const ImageTexture texture(path);
      ADD_FAILURE() << path << " is refused";
    } catch (const FileError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find(path.string() + ": expected "), 0u) << message;
      EXPECT_NE(message.find(part), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }

  TemporaryFolder folder_;
};

TEST_F(ImageTextureTest, NearestIsTheTexelItself) {
  for (const int channels : {1, 3, 4}) {
    const Image image = some_image(7, 5, channels);
    const ImageTexture texture(write(image), {.filter = ImageFilter::nearest});
    EXPECT_EQ(texture.width(), 7);
    EXPECT_EQ(texture.height(), 5);
    EXPECT_EQ(texture.channels(), channels);
    for (int row = 0; row < 5; ++row) {
      for (int column = 0; column < 7; ++column) {
        for (const double place : {0.01, 0.5, 0.99}) {
          const glm::dvec2 uv((column + place) / 7, (row + place) / 5);
          EXPECT_EQ(texture(uv), texel(image, column, row)) << channels << ' ' << column << ' ' << row;
          EXPECT_EQ(texture(uv, {{1, 0}, {0, 1}}), texel(image, column, row)) << "whatever the footprint";
        }
      }
    }
  }
}

TEST_F(ImageTextureTest, BilinearIsBetweenTexels) {
  const Image image = some_image(4, 4);
  const auto path = write(image);
  for (const ImageFilter filter : {ImageFilter::bilinear, ImageFilter::trilinear, ImageFilter::anisotropic}) {
    const ImageTexture texture(path, {.filter = filter});
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        const auto at = [&](double x, double y) { return texture({(column + 0.5 + x) / 4, (row + 0.5 + y) / 4}); };
        const auto expect_near = [&](const Color& found, const Color& expected) {
          for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(found[channel], expected[channel], 1e-6);
        };
        const Color a = texel(image, column, row), b = texel(image, column + 1, row);
        const Color c = texel(image, column, row + 1), d = texel(image, column + 1, row + 1);
        expect_near(at(0, 0), a);
        expect_near(at(0.5, 0), 0.5f * (a + b));
        expect_near(at(0.25, 0.5), 0.5f * (0.75f * (a + c) + 0.25f * (b + d)));
      }
    }
  }
}

TEST_F(ImageTextureTest, WrapsAsItIsTold) {
  const Image image = some_image(4, 4);
  const auto path = write(image);
  const auto with = [&](ImageWrap wrap) {
    return ImageTexture(path, {.wrap_u = wrap, .wrap_v = wrap, .filter = ImageFilter::nearest});
  };
  const ImageTexture repeat = with(ImageWrap::repeat), mirror = with(ImageWrap::mirror);
  const ImageTexture clamp = with(ImageWrap::clamp), black = with(ImageWrap::black);
  for (int column = -9; column < 13; ++column) {
    const glm::dvec2 uv((column + 0.5) / 4, 0.375);
    const int repeated = ((column % 4) + 4) % 4, twice = ((column % 8) + 8) % 8;
    EXPECT_EQ(repeat(uv), texel(image, repeated, 1)) << column;
    EXPECT_EQ(mirror(uv), texel(image, twice < 4 ? twice : 7 - twice, 1)) << column;
    EXPECT_EQ(clamp(uv), texel(image, std::clamp(column, 0, 3), 1)) << column;
    EXPECT_EQ(black(uv), column == repeated ? texel(image, column, 1) : Color(0)) << column;
  }
  for (const double far : {1e9, -1e9, 1e30, -1e30, 1e300}) {
    for (const ImageTexture* texture : {&repeat, &mirror, &clamp, &black}) {
      EXPECT_TRUE(is_finite((*texture)({far, far}, {{far, far}, {far, far}})));
    }
  }
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isnan(repeat({nan, 0}).x));
  EXPECT_TRUE(std::isnan(clamp({0, infinity}).x));
  const ImageTexture wide(path);
  EXPECT_TRUE(is_finite(wide({0.5, 0.5}, {{nan, nan}, {infinity, 0}})));
}

/// sph-uv-seam: both signs of zero are the same texel, and so are u = 0 and u = 1.
TEST_F(ImageTextureTest, HardCaseSphereSeam) {
  const Image image = some_image(16, 8);
  const ImageTexture texture(write(image), {.wrap_v = ImageWrap::clamp, .filter = ImageFilter::nearest});
  for (const double z : {-0.9, -0.0, 0.0, 0.3}) {
    for (const double x : {-1.0, 1.0}) {
      const glm::dvec2 above = spherical_uv({x, 0.0, z}), below = spherical_uv({x, -0.0, z});
      EXPECT_EQ(above, below);
      EXPECT_EQ(above.x, x < 0 ? 0.5 : 0.0);
      EXPECT_EQ(texture(above), texture(below));
    }
  }
  for (int row = 0; row < 8; ++row) {
    const double v = (row + 0.5) / 8;
    EXPECT_EQ(texture({1, v}), texture({0, v}));
    EXPECT_EQ(texture({1, v}), texel(image, 0, row));
    EXPECT_EQ(texture({-0x1p-60, v}), texel(image, 15, row)) << "just before the seam";
    EXPECT_EQ(texture({1 - 0x1p-53, v}), texel(image, 15, row));
  }
  EXPECT_EQ(spherical_uv({1, -1e-300, 0}).x, 1 - 0x1p-53);
  // Along the equator and a meridian by their definitions; the poles are finite.
  for (int i = 0; i < 100; ++i) {
    const double u = i / 100.0, v = (i + 0.5) / 100;
    const double turn = 2 * std::numbers::pi * u, rise = std::numbers::pi * v;
    EXPECT_NEAR(spherical_uv({3 * std::cos(turn), 3 * std::sin(turn), 0}).x, u, 1e-15);
    EXPECT_NEAR(spherical_uv({0, std::sin(rise), -std::cos(rise)}).y, v, 1e-15);
  }
  for (const double zero : {0.0, -0.0}) {
    EXPECT_EQ(spherical_uv({zero, zero, 1}).y, 1);
    EXPECT_EQ(spherical_uv({zero, zero, -1}).y, 0);
    EXPECT_TRUE(is_finite(texture(spherical_uv({zero, -zero, 1}))));
  }
}

TEST_F(ImageTextureTest, SphereFootprintsAreDerivatives) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const double turn = 6.28 * random.uniform_double(), rise = 0.2 + 2.7 * random.uniform_double();
    const Vec3d p = 2.0 * Vec3d(std::cos(turn) * std::sin(rise), std::sin(turn) * std::sin(rise), -std::cos(rise));
    const Vec3d step(random.uniform_double() - 0.5, random.uniform_double() - 0.5, random.uniform_double() - 0.5);
    const Vec3d across = 1e-6 * (step - p * (glm::dot(step, p) / 4));
    const UvFootprint footprint = spherical_footprint(p, across, Vec3d(0));
    glm::dvec2 difference = spherical_uv(p + across) - spherical_uv(p);
    difference.x -= std::round(difference.x);  // the seam
    EXPECT_NEAR(footprint.right.x, difference.x, 1e-10);
    EXPECT_NEAR(footprint.right.y, difference.y, 1e-10);
    const auto [du, dv] = spherical_derivatives(p);
    EXPECT_NEAR(glm::dot(du, p), 0, 1e-12);
    EXPECT_NEAR(glm::dot(dv, p), 0, 1e-12);
  }
  EXPECT_EQ(spherical_footprint({0, 0, 1}, {0.1, 0, 0}, {0, 0.1, 0}).right.x, 1) << "a pole is all of u";
}

TEST_F(ImageTextureTest, MakesLevelsThatTheFileDoesNotHave) {
  // A checker of texels: near by black and white, in a footprint of two texels and more gray.
  constexpr int size = 64;
  Image image{size, size, 3, {}};
  for (int i = 0; i < size * size; ++i) {
    for (int channel = 0; channel < 3; ++channel) image.pixels.push_back(static_cast<float>((i + i / size) % 2));
  }
  for (const char* name : {"checker.exr", "checker.png"}) {  // encoded colors are linear before they are filtered
    const auto path = write(image, name);
    for (const ImageFilter filter : {ImageFilter::trilinear, ImageFilter::anisotropic}) {
      const ImageTexture texture(path, {.filter = filter});
      for (int i = 0; i < size; ++i) {
        const glm::dvec2 uv((i + 0.5) / size, 0.5 + 0.5 / size);
        EXPECT_NEAR(texture(uv).x, (i + size / 2 + 1) % 2 == 0 ? 0 : 1, 0.01) << name << i;
        for (const double texels : {4.0, 16.0, 64.0}) {
          const double width = texels / size;
          EXPECT_NEAR(texture(uv, {{width, 0}, {0, width}}).x, 0.5, 0.01) << name << ' ' << texels;
        }
      }
    }
  }
  const ImageTexture data(folder_.path() / "checker.png", {.content = ImageContent::data});
  EXPECT_NEAR(data({0.5, 0.5}, {{0.5, 0}, {0, 0.5}}).x, 0.5, 0.01);
}

TEST_F(ImageTextureTest, FiltersAlongALongFootprint) {
  // Columns in turn black and white. A footprint along a column keeps it, one across it does not.
  constexpr int size = 64;
  Image image{size, size, 1, {}};
  for (int i = 0; i < size * size; ++i) image.pixels.push_back(static_cast<float>(i % 2));
  const ImageTexture texture(write(image));
  const glm::dvec2 white((31 + 0.5) / size, 0.5);
  EXPECT_GT(texture(white, {{0.25 / size, 0}, {0, 8.0 / size}}).x, 0.9);
  EXPECT_NEAR(texture(white, {{8.0 / size, 0}, {0, 0.25 / size}}).x, 0.5, 0.05);
  // Steps that are mirrored or turned are the same footprint.
  EXPECT_NEAR(texture(white, {{0, -8.0 / size}, {-0.25 / size, 0}}).x,
              texture(white, {{0.25 / size, 0}, {0, 8.0 / size}}).x, 1e-3);
}

TEST_F(ImageTextureTest, ColorsAreLinearAndDataIsNot) {
  Image image{1, 1, 3, {0.5f, 0.0f, 1.0f}};
  const auto path = write(image, "half.png");
  const Image read = read_image(path);
  const ImageTexture color(path), data(path, {.content = ImageContent::data});
  EXPECT_NEAR(color({0.5, 0.5}).x, read.pixels[0], 1e-6);
  EXPECT_NEAR(data({0.5, 0.5}).x, 188.0 / 255, 1e-6) << "the byte that stands for a half";
  EXPECT_EQ(data({0.5, 0.5}).z, 1);
}

TEST_F(ImageTextureTest, IsTheSameFromManyThreads) {
  const ImageTexture texture(write(some_image(300, 200), "large.png"));
  std::vector<glm::dvec2> places(20'000);
  Random random(2);
  for (glm::dvec2& uv : places) uv = {4 * random.uniform_double() - 2, 4 * random.uniform_double() - 2};
  const auto footprint = [](std::size_t i) { return UvFootprint{{1.0 / double(1 + i % 300), 0}, {0, 0.01}}; };
  std::vector<Color> parallel(places.size());
  std::vector<std::thread> threads;
  for (std::size_t first = 0; first < 4; ++first) {
    threads.emplace_back([&, first] {
      for (std::size_t i = first; i < places.size(); i += 4) parallel[i] = texture(places[i], footprint(i));
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < places.size(); ++i) ASSERT_EQ(parallel[i], texture(places[i], footprint(i)));
}

TEST_F(ImageTextureTest, AFileThatChangedIsAnotherTexture) {
  const auto path = write(Image{1, 1, 1, {0.25f}});
  {
    const ImageTexture texture(path);
    EXPECT_EQ(texture({0.5, 0.5}), Color(0.25f));
  }
  write(Image{1, 1, 1, {0.75f}});
  EXPECT_EQ(ImageTexture(path)({0.5, 0.5}), Color(0.75f));
}

TEST_F(ImageTextureTest, SaysWhatIsWrongWithAFile) {
  expect_error(folder_.path() / "missing.png", "No such file");
  expect_error(folder_.path(), "");
  expect_error(folder_.write("empty.png", ""), "");
  expect_error(folder_.write("text.png", "this is no image at all"), "expected an image");
  expect_error(folder_.write("image.xyz", "what is this"), "expected an image");
  const auto path = write(some_image(64, 64), "whole.png");
  const std::string bytes = read_bytes(path);
  expect_error(folder_.write("half.png", bytes.substr(0, bytes.size() / 2)), "expected a whole image of 64 x 64");
  const std::string exr = read_bytes(write(some_image(64, 64), "whole.exr"));
  expect_error(folder_.write("half.exr", exr.substr(0, exr.size() / 2)), "expected a");

  // A header of the PPM format that promises more than there may be.
  expect_error(folder_.write("huge.ppm", "P6\n60000 60000\n255\n"), "60000 x 60000");
  expect_error(folder_.write("long.ppm", "P6\n70000 1\n255\n"), "70000 x 1");
  expect_error(folder_.write("short.ppm", "P6\n600 600\n255\nabc"), "rows");
}

}  // namespace
}  // namespace sightline
