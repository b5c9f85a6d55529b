#include "viz/noise_tool/answer.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "sightline/math/random.h"
#include "viz/noise_tool/slice.h"

namespace sightline::noise_tool {
namespace {

TEST(Answer, ReadsNumbersHoweverTheyAreApart) {
  for (const char* line : {"1 -2.5 3e2", " 1\t-2.5   3e2 \r", "1,-2.5,3e2", "1 , -2.5 ,3e2", "+1 -2.5 +3e2"}) {
    const Point point = parse_point(line);
    EXPECT_EQ(point.dims, 3) << line;
    EXPECT_EQ(point.p, glm::dvec3(1, -2.5, 300)) << line;
  }
  EXPECT_EQ(parse_point("4 5").dims, 2);
}

TEST(Answer, RefusesEverythingElse) {
  Random random(1);
  const std::string letters = "0123456789.,-+eE \tinfax#";
  int refused = 0;
  for (int i = 0; i < 50'000; ++i) {
    std::string line;
    for (std::uint32_t k = random.below(20); k > 0; --k) {
      line += letters[random.below(static_cast<std::uint32_t>(letters.size()))];
    }
    try {
      const Point point = parse_point(line);
      EXPECT_TRUE(point.dims == 2 || point.dims == 3);
    } catch (const std::invalid_argument& error) {
      ++refused;
      const std::string what = error.what();
      EXPECT_TRUE(what.starts_with("column ") && what.find(": expected ") != what.npos &&
                  what.find(", found ") != what.npos)
          << what;
    }
  }
  EXPECT_GT(refused, 25'000);
  EXPECT_LT(refused, 50'000);
}

template <class T>
void expect_round_trip(T number) {
  std::string text;
  append_number(text, number);
  T read = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
  EXPECT_EQ(end, text.data() + text.size());
  EXPECT_TRUE(read == number || (std::isnan(read) && std::isnan(number))) << text;
}

TEST(Answer, NumbersAreReadBackTheSame) {
  Random random(2);
  for (int i = 0; i < 10'000; ++i) {
    const double number = std::ldexp(random.uniform_double() - 0.5, static_cast<int>(random.below(200)) - 100);
    expect_round_trip(number);
    expect_round_trip(static_cast<float>(number));
  }
  expect_round_trip(std::numeric_limits<double>::quiet_NaN());
  expect_round_trip(std::numeric_limits<double>::denorm_min());
}

/// Batches end where the number of coordinates changes and where they are full, which no answer may show.
TEST(Answer, IsThatOfEachPointAlone) {
  Request request;
  request.field = {.noise = {.seed = 5}, .fractal = FractalKind::fbm, .octaves = 2};
  request.has_gradient = true;
  const NoiseField field(request.field);
  Random random(3);
  std::string lines, expected;
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 p(random.uniform_double() * 100, random.uniform_double() - 50, random.uniform_double());
    const bool is_plane = i > 10'000 && random.below(3) == 0;
    for (int axis = 0; axis < (is_plane ? 2 : 3); ++axis) append_number(lines += axis == 0 ? "" : " ", p[axis]);
    lines += '\n';
    const auto add = [&](const auto& sample, int dims) {
      append_number(expected, sample.value);
      for (int axis = 0; axis < dims; ++axis) append_number(expected += ' ', sample.gradient[axis]);
      expected += '\n';
    };
    is_plane ? add(field.sample(glm::dvec2(p)), 2) : add(field.sample(p), 3);
  }
  std::istringstream in(lines);
  std::ostringstream out, errors;
  EXPECT_EQ(answer_points(field, request, in, out, errors), 0u);
  EXPECT_TRUE(out.str() == expected);
  EXPECT_EQ(errors.str(), "");
}

TEST(Slice, HasTheValuesOfItsPixelsMiddles) {
  Request request;
  request.slice = {.width = 8, .height = 4, .z = 0.25, .extent = 4};
  request.field.frequency = 2;
  const NoiseField field(request.field);
  const Image image = slice_of(field, request);
  ASSERT_EQ(image.pixels.size(), 32u);
  // Four cells are two units; a pixel is a quarter of one.
  EXPECT_EQ(image.pixels[0], static_cast<float>(field(glm::dvec3(-0.875, 0.375, 0.25))));
  EXPECT_EQ(image.pixels[31], static_cast<float>(field(glm::dvec3(0.875, -0.375, 0.25))));
}

TEST(Slice, ColorsGoFromTheLowestToTheHighest) {
  for (const FractalInfo& info : fractal_infos) {
    const NoiseField field({.noise = {}, .fractal = info.kind, .octaves = 2, .gain = 0.5});
    const float high = static_cast<float>(field.amplitude());
    const bool is_signed = info.kind == FractalKind::none || info.kind == FractalKind::fbm;
    Image image{3, 1, 1, {is_signed ? -high : 0, is_signed ? 0 : high / 2, high}};
    map_to_colors(image, field);
    EXPECT_EQ(image.pixels[0], 0);
    EXPECT_NEAR(image.pixels[1], 0.2140f, 0.0001f);  // what sRGB shows as one half
    EXPECT_EQ(image.pixels[2], 1);
  }
}

}  // namespace
}  // namespace sightline::noise_tool
