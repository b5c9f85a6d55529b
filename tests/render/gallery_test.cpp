/// The scenes of data: together they call for every effect, and each pays for its own alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "sightline/scene/scene_file.h"
#include "tests/render/little_scenes.h"

namespace sightline::test {
namespace {

class Gallery : public testing::TestWithParam<std::filesystem::path> {};

std::vector<std::filesystem::path> gallery() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(SIGHTLINE_SOURCE_DIR "/data/scenes")) {
    if (entry.path().extension() == ".json" && entry.path().stem() != "materials") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Renderer renderer_of(const std::filesystem::path& file, RenderSettings settings) {
  return {std::make_shared<const Scene>(read_scene(file, SIGHTLINE_SOURCE_DIR "/data")), settings};
}

TEST_P(Gallery, CountsNothingThatIsNotInThePlan) {
  const Renderer renderer = renderer_of(GetParam(), small(32, 24, 2));
  const RenderCounters counters = render(renderer).counters;
  EXPECT_EQ(counters.camera_rays, 32u * 24 * 2);
  for (std::size_t i = 0; i < effect_count; ++i) {
    if (renderer.plan().analysis.effects.has(static_cast<Effect>(i))) continue;
    EXPECT_EQ(counters.counts[i], 0u) << effect_names[i];
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Gallery, testing::ValuesIn(gallery()), [](const auto& which) {
  std::string name = which.param.stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(GalleryAsAWhole, ShowsEveryEffect) {
  Effects shown;
  for (const auto& file : gallery()) {
    RenderSettings settings = small(8, 8);
    settings.samples = 0;  // as many as the scene says: of one sample nothing is smoothed
    shown = shown | renderer_of(file, settings).plan().analysis.effects;
  }
  for (std::size_t i = 0; i < effect_count; ++i) EXPECT_TRUE(shown.has(static_cast<Effect>(i))) << effect_names[i];
}

}  // namespace
}  // namespace sightline::test
