#include "sightline/texture/normal_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sightline/io/image_file.h"
#include "sightline/math/random.h"
#include "sightline/texture/dents.h"
#include "tests/io/temporary_folder.h"

namespace sightline {
namespace {

constexpr double tiny = 0x1p-50;

Vec3d random_direction(Random& random) {
  for (;;) {
    Vec3d v;
    for (int axis = 0; axis < 3; ++axis) v[axis] = 2 * random.uniform_double() - 1;
    if (normalize_safely(v)) return v;
  }
}

void expect_near(const Vec3d& a, const Vec3d& b, double bound) {
  EXPECT_LE(glm::length(a - b), bound) << a.x << ' ' << a.y;
}

TEST(NormalMap, DecodesColors) {
  EXPECT_EQ(decode_normal({0.5f, 0.5f, 1}), Vec3d(0, 0, 1));
  EXPECT_EQ(decode_normal({1, 0.5f, 0.5f}), Vec3d(1, 0, 0));
  EXPECT_EQ(decode_normal({0.5f, 0, 0.5f}), Vec3d(0, -1, 0));
  EXPECT_EQ(decode_normal({0.5f, 0.5f, 0.5f}), Vec3d(0, 0, 1)) << "no direction at all";
  EXPECT_EQ(decode_normal({0.5f, 0.5f, 0}), Vec3d(0, 0, 1)) << "below the surface";
  EXPECT_EQ(decode_normal(Color(std::nanf(""))), Vec3d(0, 0, 1));
  EXPECT_EQ(decode_normal({1, 0, 0.75f}, 0), Vec3d(0, 0, 1)) << "flat";
  // 0.6, 0, 0.8 as halves of what they are, and shorter, as means of normals are.
  expect_near(decode_normal({0.8f, 0.5f, 0.9f}), {0.6, 0, 0.8}, 1e-7);
  expect_near(decode_normal({0.65f, 0.5f, 0.7f}), {0.6, 0, 0.8}, 1e-7);
  expect_near(decode_normal({0.8f, 0.5f, 0.9f}, 4.0 / 3), {std::sqrt(0.5), 0, std::sqrt(0.5)}, 1e-7);
  expect_near(decode_normal_xy(0.8, 0.5), {0.6, 0, 0.8}, tiny);
  expect_near(decode_normal_xy(1, 1), {std::sqrt(0.5), std::sqrt(0.5), 0}, tiny);
}

/// z = h(x, y) has the normal (-hx, -hy, 1).
TEST(NormalMap, DentsByHeights) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec2 slope(random.uniform_double() - 0.5, 4 * random.uniform_double() - 2);
    Vec3d expected(-slope.x, -slope.y, 1);
    normalize_safely(expected);
    expect_near(dented_normal({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, slope), expected, tiny);
    // (u, v) of any shape, mirrored as well, say the same of the same surface: hu = grad h . du.
    const Vec3d du(random.uniform_double() + 0.5, random.uniform_double(), 0);
    const Vec3d dv(random.uniform_double() - 2, random.below(2) == 0 ? 1.5 : -1.5, 0);
    const glm::dvec2 by_uv(slope.x * du.x + slope.y * du.y, slope.x * dv.x + slope.y * dv.y);
    expect_near(dented_normal({0, 0, 1}, du, dv, by_uv), expected, 1e-12);
    // ... and so does the height in space.
    expect_near(dented_normal({0, 0, 1}, Vec3d(slope.x, slope.y, 7)), expected, tiny);
    expect_near(dented_normal({0, 0, 1}, Vec3d(slope.x, slope.y, 7), 0), {0, 0, 1}, 0);
  }
  EXPECT_EQ(dented_normal({0, 0, 1}, {1, 0, 0}, {2, 0, 0}, {5, 5}), Vec3d(0, 0, 1)) << "no surface";
  EXPECT_EQ(dented_normal({0, 0, 1}, Vec3d(std::nan(""), 0, 0)), Vec3d(0, 0, 1));
}

/// A sphere that noise moves in and out has the normals of its differences.
TEST(NormalMap, DentsByNoise) {
  const NoiseField field({.noise = {}, .fractal = FractalKind::fbm, .octaves = 2, .frequency = 3});
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const double height = 0x1p-20;  // dents are of first order
    const Vec3d n = random_direction(random);
    const TangentFrame frame = frame_around(n);
    const auto moved = [&](double a, double b) {
      Vec3d p = n + a * frame.tangent + b * frame.bitangent;
      normalize_safely(p);
      return p * (1 + height * field(p));
    };
    const double step = 0x1p-13;
    Vec3d expected = glm::cross(moved(step, 0) - moved(-step, 0), moved(0, step) - moved(0, -step));
    normalize_safely(expected);
    const Vec3d dent = dented_normal(n, field.sample(n).gradient, height);
    EXPECT_NEAR(glm::length(dent), 1, tiny);
    expect_near((dent - n) / height, (expected - n) / height, 1e-2);
    expect_near(Dents({height, field.options()}).normal(n, n), dent, 0);
    EXPECT_GT(glm::dot(dented_normal(n, field.sample(n).gradient, 1e6), n), 0) << "never below the surface";
  }
}

TEST(NormalMap, ReadsImagesOfNormals) {
  const TemporaryFolder folder;
  Image image{8, 8, 3, {}};
  for (int i = 0; i < 64; ++i) image.pixels.insert(image.pixels.end(), {0.8f, 0.5f, 0.9f});
  const auto path = folder.path() / "normals.tif";
  write_image(path, image);
  const ImageTexture normals(path, {.content = ImageContent::data});
  const Vec3d local = decode_normal(normals({0.3, 0.7}));
  expect_near(local, {0.6, 0, 0.8}, 1e-6);
  const TangentFrame mirrored =
      triangle_frame({0, 0, 1}, {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)}, {{{1, 0}, {0, 0}, {1, 1}}});
  expect_near(mirrored.to_world(local), {-0.6, 0, 0.8}, 1e-6);
}

TEST(NormalMap, ReadsImagesOfHeights) {
  const TemporaryFolder folder;
  // Waves across: sin(2 pi u) with noise of one texel, which a wide footprint does not see; along v a slope.
  constexpr int size = 64;
  Image image{size, size, 1, {}};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double u = (x + 0.5) / size, v = 1 - (y + 0.5) / size;
      image.pixels.push_back(static_cast<float>(std::sin(2 * std::numbers::pi * u) + 0.25 * v + (x % 2) * 0.5));
    }
  }
  const auto path = folder.path() / "heights.exr";
  write_image(path, image);
  const ImageTexture heights(path, {.wrap_v = ImageWrap::clamp, .content = ImageContent::data});
  const double texel = 1.0 / size;
  for (int i = 8; i < size - 8; ++i) {
    const glm::dvec2 uv((i + 0.5) * texel, 0.5);
    const double expected = 2 * std::numbers::pi * std::cos(2 * std::numbers::pi * uv.x);
    // At a texel's middle the difference over one texel is the central one over its neighbours.
    EXPECT_NEAR(height_slope(heights, uv).x, expected, 0.02) << i;
    EXPECT_NEAR(height_slope(heights, uv).y, 0.25, 1e-3) << i;
    const UvFootprint wide{{4 * texel, 0}, {0, 4 * texel}};
    EXPECT_NEAR(height_slope(heights, uv, wide).x, expected, 0.5) << i;
    EXPECT_NEAR(height_slope(heights, uv, wide).y, 0.25, 0.01) << i;
    const glm::dvec2 edge(i * texel, 0.5);
    EXPECT_GT(std::fabs(height_slope(heights, edge).x - expected), 10) << "but between texels their noise shows";
    EXPECT_NEAR(height_slope(heights, edge, wide).x, expected, 0.8) << i;
  }
}

TEST(NormalMap, FiltersHeightsAsWideAsTheirSlope) {
  const TemporaryFolder folder;
  constexpr int size = 64;
  Image image{size, size, 1, {}};
  Random random(4);
  for (int i = 0; i < size * size; ++i) image.pixels.push_back(random.uniform());  // nothing but noise, so no slope
  const auto path = folder.path() / "noise.exr";
  write_image(path, image);
  const ImageTexture heights(path, {.content = ImageContent::data});
  const double width = 8.0 / size;
  double near = 0, far = 0;
  for (int i = 0; i < size; ++i) {
    const glm::dvec2 uv((i + 0.5) / size, 0.5 + 0.5 / size), fine = height_slope(heights, uv);
    const glm::dvec2 coarse = height_slope(heights, uv, {{width, 0}, {0, width}});
    near += glm::dot(fine, fine) / size, far += glm::dot(coarse, coarse) / size;
  }
  // A texel's deviation is 0.29. The difference of two means of 64 has 0.05, of two texels 0.4.
  EXPECT_LT(std::sqrt(far), 2 * std::sqrt(2) * 0.05 / width);
  EXPECT_GT(std::sqrt(near), 0.2 * size);
}

/// interp-normal-below
TEST(HardCases, InterpolatedNormalBelow) {
  Random random(3);
  int below = 0, flipped = 0;
  for (int i = 0; i < 50'000; ++i) {
    const Vec3d geometric = random_direction(random);
    Vec3d shading = random_direction(random), viewer = random_direction(random);
    if (glm::dot(shading, geometric) < 0) shading = -shading;
    const double side = glm::dot(geometric, viewer) < 0 ? -1 : 1, cosine = side * glm::dot(shading, viewer);
    const Vec3d result = facing_normal(shading, geometric, viewer);
    ASSERT_GT(glm::dot(result, viewer), 0);
    EXPECT_NEAR(glm::length(result), 1, tiny);
    if (cosine > 0) {
      EXPECT_EQ(result, side * shading);
    } else {
      EXPECT_NEAR(glm::dot(result, viewer), -cosine, tiny);
      EXPECT_GE(glm::dot(result, geometric) * side, -tiny) << "still on the surface's side";
    }
    below += cosine < 0, flipped += side < 0;
  }
  EXPECT_GT(below, 1000);
  EXPECT_GT(flipped, 1000);
  // On the very edge, whose reflection is itself.
  EXPECT_EQ(facing_normal({1, 0, 0}, {0, 0, 1}, {0, 0, 1}), Vec3d(0, 0, 1));
  EXPECT_EQ(facing_normal({1, 0, 0}, {1, 0, 0}, {0, 0, 2}), Vec3d(0, 0, 1)) << "edge-on there is no side";
  for (int exponent = -1074; exponent < -1; ++exponent) {
    const double e = std::ldexp(1, exponent);
    for (const Vec3d& viewer : {Vec3d(e, 0, 1), Vec3d(-e, 0, 1), Vec3d(-1, e, e)}) {
      EXPECT_GT(glm::dot(facing_normal({1, 0, 0}, {0.6, 0, 0.8}, viewer), viewer), 0) << exponent;
    }
  }
}

}  // namespace
}  // namespace sightline
