/// What scene files say of the picture as a whole, and of lenses, dents and what is hidden.

#include <gtest/gtest.h>

#include <cmath>

#include "sightline/io/file_error.h"
#include "sightline/io/image_file.h"
#include "sightline/scene/scene_file.h"
#include "tests/io/temporary_folder.h"

namespace sightline {
namespace {

Scene read(const TemporaryFolder& folder, const std::string& text) {
  return read_scene(folder.write("scene.json", text), "no/data");
}

std::string refusal(const TemporaryFolder& folder, const std::string& text) {
  try {
    read(folder, text);
  } catch (const FileError& error) {
    return error.what();
  }
  return "read";
}

TEST(SceneSettings, AreOffUnlessAskedFor) {
  const TemporaryFolder folder;
  const Scene scene = read(folder, R"({"materials": {"m": {}}, "objects": [{"name": "eye", "camera": {}}]})");
  EXPECT_EQ(std::get<Color>(scene.surroundings.background), Color(0));
  EXPECT_FALSE(scene.surroundings.lights);
  EXPECT_EQ(scene.ambient.color, Color(0));
  EXPECT_EQ(scene.fog.density, 0);
  EXPECT_EQ(scene.render.samples, 1u);
  EXPECT_EQ(scene.render.depth, 8u);
  EXPECT_EQ(scene.render.cut_off, 0x1p-9);
  EXPECT_EQ(scene.render.shadow_error, 0x1p-8);
  EXPECT_FALSE(scene.render.interreflection);
  EXPECT_EQ(scene.cameras.at(0).aperture, 0);
  EXPECT_EQ(scene.cameras[0].shutter, (std::array<double, 2>{0, 0}));
  EXPECT_FALSE(scene.materials.at(0).dents);
  EXPECT_TRUE(scene.graph.is_shown(1));
}

TEST(SceneSettings, SayWhatTheySay) {
  const TemporaryFolder folder;
  const Scene scene = read(folder, R"({
    "background": {"zenith": [0.25, 0.5, 1], "horizon": [1, 1, 1], "ground": [0.5, 0, 0], "intensity": 2, "lights": true},
    "ambient": {"color": [0.1, 0.2, 0.3], "occlusion_distance": 4},
    "fog": {"density": 0.5, "color": "#ffffff"},
    "render": {"samples": 64, "depth": 3, "interreflection": true, "cut_off": 0,
               "shadow_error": 0.25},
    "materials": {"m": {"dents": {"height": -0.5, "noise": "improved", "fractal": "ridged", "octaves": 3, "lacunarity": 3,
                                  "gain": 0.25, "frequency": 7, "warp": 2, "seed": 9}}},
    "objects": [
      {"name": "eye", "camera": {"aperture": 0.5, "focus_distance": 3, "shutter": [1, 1.5]}},
      {"name": "ghost", "visible": false, "children": [{"name": "below"}]},
      {"name": "row", "visible": false, "repeat": {"count": 2}}
    ]})");
  const auto& sky = std::get<SkyGradient>(scene.surroundings.background);
  EXPECT_EQ(sky.toward({0, 1, 0}), Color(0.25f, 0.5f, 1));
  EXPECT_EQ(sky.toward({1, 0, 0}), Color(1));
  EXPECT_EQ(sky.toward({0, -1, 0}), Color(0.5f, 0, 0));
  EXPECT_EQ(sky.toward({std::sqrt(0.75), -0.5, 0}), Color(0.75f, 0.5f, 0.5f));
  EXPECT_EQ(scene.surroundings.intensity, 2);
  EXPECT_TRUE(scene.surroundings.lights);
  EXPECT_EQ(scene.ambient.color, Color(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(scene.ambient.occlusion_distance, 4);
  EXPECT_EQ(scene.fog.density, 0.5);
  EXPECT_EQ(scene.fog.color, Color(1));
  EXPECT_EQ(scene.render.samples, 64u);
  EXPECT_EQ(scene.render.depth, 3u);
  EXPECT_TRUE(scene.render.interreflection);
  EXPECT_EQ(scene.render.cut_off, 0);
  EXPECT_EQ(scene.render.shadow_error, 0.25);
  ASSERT_TRUE(scene.materials[0].dents);
  const DentOptions& dents = *scene.materials[0].dents;
  EXPECT_EQ(dents.height, -0.5);
  EXPECT_EQ(dents.field.noise.kind, NoiseKind::improved);
  EXPECT_EQ(dents.field.noise.seed, 9u);
  EXPECT_EQ(dents.field.fractal, FractalKind::ridged);
  EXPECT_EQ(dents.field.octaves, 3);
  EXPECT_EQ(dents.field.lacunarity, 3);
  EXPECT_EQ(dents.field.gain, 0.25);
  EXPECT_EQ(dents.field.frequency, 7);
  EXPECT_EQ(dents.field.warp, 2);
  EXPECT_EQ(scene.cameras[0].aperture, 0.5);
  EXPECT_EQ(scene.cameras[0].focus_distance, 3);
  EXPECT_EQ(scene.cameras[0].shutter, (std::array{1.0, 1.5}));
  for (NodeId node = 2; node < scene.graph.size(); ++node) EXPECT_FALSE(scene.graph.is_shown(node)) << node;
  EXPECT_EQ(scene.graph.size(), 6u);
}

TEST(SceneSettings, BackgroundsAreColorsSkiesAndImages) {
  const TemporaryFolder folder;
  write_image(folder.path() / "sky.png", {2, 1, 3, {1, 0, 0, 0, 1, 0}});
  EXPECT_EQ(std::get<Color>(read(folder, R"({"background": [1, 2, 3]})").surroundings.background), Color(1, 2, 3));
  const Scene plain = read(folder, R"({"background": {"color": "#ffffff", "lights": true}})");
  EXPECT_EQ(std::get<Color>(plain.surroundings.background), Color(1));
  EXPECT_TRUE(plain.surroundings.lights);
  const Scene sky = read(folder, R"({"background": {"zenith": [0, 0, 1], "horizon": [1, 0, 0]}})");
  EXPECT_EQ(std::get<SkyGradient>(sky.surroundings.background).toward({0, -1, 0}), Color(1, 0, 0));
  const Scene scene = read(folder, R"({"background": {"image": "sky.png", "rotation": 90}})");
  EXPECT_EQ(std::get<SkyImage>(scene.surroundings.background).image, folder.path() / "sky.png");
}

/// An image that is turned by an angle has in a direction what it had in that direction turned back.
TEST(SceneSettings, ImagesOfTheSkyTurnLikeThingsDo) {
  const SkyImage still{"", 0}, turned{"", 30};
  EXPECT_EQ(still.uv_of({0, 0, -1}), glm::dvec2(0.5, 0.5));
  EXPECT_EQ(still.uv_of({1, 0, 0}), glm::dvec2(0.75, 0.5));
  EXPECT_EQ(still.uv_of({0, 3, 0}).y, 1);
  EXPECT_EQ(still.uv_of({0, -3, 0}).y, 0);
  const Transform turn = Transform::rotation({0, 1, 0}, 30);
  for (const Vec3d& d : {Vec3d(0, 0.5, -1), Vec3d(1, -2, 0.3), Vec3d(-0.2, 1, -0.7)}) {
    const glm::dvec2 before = still.uv_of(d), after = turned.uv_of(turn.vector(d));
    EXPECT_NEAR(std::remainder(before.x - after.x, 1), 0, 1e-15);
    EXPECT_NEAR(before.y, after.y, 1e-15);
  }
}

TEST(SceneSettings, OnesOwnGoBeforeIncludedOnes) {
  const TemporaryFolder folder;
  folder.write("dusk.json", R"({"background": [0.5, 0.5, 0.5], "fog": {"density": 1, "color": [1, 1, 1]},
    "objects": [{"name": "ground", "visible": false}]})");
  const Scene scene = read(folder, R"({"include": "dusk.json", "background": [0, 0, 1]})");
  EXPECT_EQ(std::get<Color>(scene.surroundings.background), Color(0, 0, 1));
  EXPECT_EQ(scene.fog.density, 1);
  // What stands within another scene leaves its surroundings behind, but what it hides stays hidden.
  const Scene outer = read(folder, R"({"objects": [{"scene": "dusk.json"}]})");
  EXPECT_EQ(std::get<Color>(outer.surroundings.background), Color(0));
  EXPECT_EQ(outer.fog.density, 0);
  EXPECT_FALSE(outer.graph.is_shown(2));
}

TEST(SceneSettings, BadOnesAreRefusedInOneLine) {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> cases[] = {
      {R"({"background": {}})", ":/background: expected one of color, zenith, image, found none"},
      {R"({"background": {"zenith": [0,0,0]}})", R"(:/background: expected a member "horizon", found none)"},
      {R"({"background": {"color": [0,0,0], "rotation": 5}})",
       R"(:/background/rotation: expected "image" beside it, found "color")"},
      {R"({"background": {"color": [0,0,0], "ground": [0,0,0]}})", R"(expected "zenith" beside it, found "color")"},
      {R"({"background": {"image": "none.png"}})", "none.png: expected a file, found No such file"},
      {R"({"background": {"color": [0,0,0], "lights": 1}})", ":/background/lights: expected true or false, found 1"},
      {R"({"ambient": {"occlusion_distance": 1}})", R"(:/ambient: expected a member "color", found none)"},
      {R"({"ambient": {"color": [0,0,0], "occlusion_distance": -1}})", "expected a number of at least 0.0, found -1"},
      {R"({"fog": {"density": -1, "color": [0,0,0]}})", ":/fog/density: expected a number of at least 0.0, found -1"},
      {R"({"render": {"samples": 0}})", ":/render/samples: expected a whole number from 1 to 1048576, found 0"},
      {R"({"render": {"samples": 1.5}})", ":/render/samples: expected a whole number, found 1.5"},
      {R"({"render": {"depht": 1}})", R"(found "depht" (is "depth" meant?))"},
      {R"({"render": {"cut_off": 2}})", ":/render/cut_off: expected a number from 0.0 to 1.0, found 2"},
      {R"({"render": {"shadow_error": -1}})", ":/render/shadow_error: expected a number from 0.0 to 1.0, found -1"},
      {R"({"objects": [{"camera": {"aperture": 1}}]})",
       R"(:/objects/0/camera: expected a "focus_distance" above 0 beside "aperture", found none)"},
      {R"({"objects": [{"camera": {"shutter": [1, 0]}}]})", ":/objects/0/camera/shutter/1: expected a time at which"},
      {R"({"objects": [{"camera": {"shutter": [1]}}]})", ":/objects/0/camera/shutter: expected 2 numbers, found 1"},
      {R"({"objects": [{"visible": "no"}]})", R"(:/objects/0/visible: expected true or false, found "no")"},
      {R"({"materials": {"m": {"dents": {"noise": "perl"}}}})",
       R"(/dents/noise: expected one of perlin, improved, value, white, found "perl")"},
      {R"({"materials": {"m": {"dents": {"frequency": 0}}}})", ":/materials/m/dents: expected noise with its options"},
      {R"({"materials": {"m": {"dents": {"octaves": 33}}}})",
       ":/materials/m/dents/octaves: expected a whole number from 1 to 32, found 33"}};
  for (const auto& [text, expected] : cases) {
    const std::string found = refusal(folder, text);
    EXPECT_NE(found.find(expected), std::string::npos) << text << "\n  " << found << "\n  " << expected;
    EXPECT_EQ(found.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace sightline
