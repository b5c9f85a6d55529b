/// Small pictures of the scenes of data, as they were when somebody looked at them.
///
/// Which surface a ray hits is decided exactly, and sums have one order; so a picture differs between machines only by
/// roundings of what is not ours, such as sines and filters of images. These move a color by less than a step of 8
/// bits, but may turn over a choice that is made by chance or by a threshold: then a pixel is of another color. Hence a
/// step is allowed everywhere, and any color in one of a hundred pixels.
///
/// After a change that is meant: sightline-render data/scenes/NAME.json --size 96x72 --samples 4
/// --out tests/render/golden/NAME.png, and look at it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "sightline/io/image_file.h"
#include "sightline/io/srgb.h"
#include "sightline/scene/scene_file.h"
#include "tests/render/little_scenes.h"

namespace sightline::test {
namespace {

namespace fs = std::filesystem;

constexpr int width = 96, height = 72;
constexpr std::uint32_t samples = 4;
constexpr double most_others = 0.01;

fs::path source(const char* folder) { return fs::path(SIGHTLINE_SOURCE_DIR) / folder; }

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(source("data/scenes"))) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".json" && name != "materials") names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// As PNG has it.
int step_of(float linear) { return static_cast<int>(std::lround(255 * encode_srgb(linear))); }

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, IsAsItWas) {
  const Scene scene = read_scene(source("data/scenes") / (GetParam() + ".json"), source("data"));
  const Rendered picture = render(scene, small(width, height, samples));
  const Image golden = read_image(source("tests/render/golden") / (GetParam() + ".png"));
  ASSERT_EQ(golden.width, width);
  ASSERT_EQ(golden.height, height);
  ASSERT_EQ(golden.channels, 3);
  std::size_t others = 0;
  for (std::size_t i = 0; i < picture.tile.sums.size(); ++i) {
    const Vec3d color = picture.mean(i);
    bool is_other = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const int now = step_of(static_cast<float>(color[static_cast<glm::length_t>(k)]));
      is_other = is_other || std::abs(now - step_of(golden.pixels[3 * i + k])) > 1;
    }
    others += is_other;
  }
  EXPECT_LE(others, most_others * width * height);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(names()), [](const auto& which) {
  std::string name = which.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace sightline::test
