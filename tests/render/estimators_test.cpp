/// Two ways to the same light have to agree in every pixel, as far as chance lets one see.
///
/// For each pixel the difference of two means, over its standard error, is compared with what a normal distribution
/// exceeds in one of a million pictures (Bonferroni's correction for so many pixels). Samples of a pixel are more even
/// than independent ones, so the errors are estimates from above: the test is never too strict. That it sees faults is
/// shown by a surface that is a little brighter.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/render/little_scenes.h"

namespace sightline::test {
namespace {

constexpr int width = 16, height = 12;

/// The largest |z| of all pixels; pixels without scatter have to be equal but for rounding.
double largest_z(const Rendered& a, const Rendered& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.tile.sums.size(); ++i) {
    const auto mean = [&](const Rendered& r) { return PixelSum::luminance(r.mean(i)); };
    const auto variance = [&](const Rendered& r) {
      const PixelSum& sum = r.tile.sums[i];
      return std::fmax(0, sum.luminance_squares / sum.samples - mean(r) * mean(r)) / sum.samples;
    };
    const double rounding = 0x1p-18;
    const double error = std::sqrt(variance(a) + variance(b)) + rounding;
    largest = std::fmax(largest, std::fabs(mean(a) - mean(b)) / error);
  }
  return largest;
}

/// What one of a million pictures of `pixels` exceeds: the inverse of the normal distribution's tail on both sides.
double limit(std::size_t pixels) {
  const double chance = 1e-6 / static_cast<double>(pixels);
  double low = 0, high = 20;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (std::erfc(middle / std::sqrt(2.0)) > chance ? low : high) = middle;
  }
  return low;
}

RenderSettings settings_of(std::uint32_t samples, std::uint64_t seed) {
  RenderSettings settings = small(width, height, samples);
  settings.seed = seed;
  settings.cut_off = 0;
  return settings;
}

/// Balls in front of a wall on a floor, under a sky.
Scene under_the_sky(double albedo) {
  Scene scene;
  const std::uint32_t material = add_material(scene, lambert(albedo));
  add_shape(scene, "ball", SolidTree(solid::Sphere{Vec3d(-0.8, 0, 0), 1}), material);
  add_shape(scene, "small", SolidTree(solid::Sphere{Vec3d(1, -0.5, 0.5), 0.5}), material);
  add_shape(scene, "floor", SolidTree(solid::Box{Vec3d(-9, -2, -9), Vec3d(9, -1, 9)}), material);
  add_shape(scene, "wall", SolidTree(solid::Box{Vec3d(-9, -1, -4), Vec3d(9, 4, -3)}), material);
  scene.surroundings = {SkyGradient{Color(0.2f, 0.5f, 1), Color(1, 0.9f, 0.8f), Color(0.1f)}, 1, true};
  add_camera(scene, 7, 40);
  return scene;
}

/// The sky's light by asking whether it is seen, and by paths of one bounce that end in it.
TEST(Estimators, SkyByAskingAndByPaths) {
  const auto picture = [](bool has_paths, double albedo, std::uint64_t seed) {
    Scene scene = under_the_sky(albedo);
    scene.render.interreflection = has_paths;
    RenderSettings settings = settings_of(1024, seed);
    settings.depth = 1;
    return render(scene, settings);
  };
  const Rendered asked = picture(false, 0.7, 1);
  EXPECT_GT(asked.counters[Effect::environment], 0u);
  const Rendered paths = picture(true, 0.7, 2);
  EXPECT_EQ(paths.counters[Effect::environment], 0u);
  EXPECT_GT(paths.counters[Effect::interreflection], 0u);
  const double most = limit(std::size_t{width} * height);
  EXPECT_LT(largest_z(asked, paths), most);
  EXPECT_GT(largest_z(asked, picture(true, 0.8, 2)), most) << "the test has to see a surface that is brighter";
}

/// Occlusion without end under a white sky is the sky's light.
TEST(Estimators, OcclusionWithoutEndIsAWhiteSky) {
  Scene sky = under_the_sky(0.7);
  sky.surroundings = {Color(1), 1, true};
  Scene ambient = under_the_sky(0.7);
  ambient.surroundings = {Color(1), 1, false};
  ambient.ambient = {Color(1), 1e6};
  const double most = limit(std::size_t{width} * height);
  EXPECT_LT(largest_z(render(sky, settings_of(256, 3)), render(ambient, settings_of(256, 4))), most);
  ambient.ambient.occlusion_distance = 2;
  EXPECT_GT(largest_z(render(sky, settings_of(256, 3)), render(ambient, settings_of(256, 4))), most);
}

/// One lamp, and four of a quarter of it side by side.
TEST(Estimators, LampInPartsIsOneLamp) {
  const auto picture = [](bool is_in_parts, double radiance, std::uint64_t seed) {
    Scene scene = under_the_sky(0.7);
    scene.surroundings = {};
    const Transform down = Transform::translation({0, 3, 2}) * Transform::rotation(Vec3d(1, 0, 0), -90);
    for (int i = 0; i < (is_in_parts ? 4 : 1); ++i) {
      const Vec3d at = is_in_parts ? Vec3d(i % 2 - 0.5, i / 2 - 0.5, 0) : Vec3d(0);
      add_light(scene, AreaLight{is_in_parts ? 1.0 : 2.0, is_in_parts ? 1.0 : 2.0}, radiance,
                down * Transform::translation(at));
    }
    return render(scene, settings_of(128, seed));
  };
  const double most = limit(std::size_t{width} * height);
  EXPECT_LT(largest_z(picture(false, 5, 1), picture(true, 5, 2)), most);
  EXPECT_GT(largest_z(picture(false, 5, 1), picture(true, 5.5, 2)), most);
}

/// At each surface one way is chosen, or all are gone: glass, a mirror and rough metal with paths and without. What
/// calls for paths is too far to be seen.
TEST(Estimators, ChosenWaysAreAllWays) {
  const auto picture = [](bool has_paths, double index, std::uint64_t seed) {
    Scene scene = under_the_sky(0.7);
    Material metal = mirror();
    metal.roughness = 0.4;
    scene.graph.set_material(scene.graph.find("/ball"), add_material(scene, glass(index)));
    scene.graph.set_material(scene.graph.find("/small"), add_material(scene, metal));
    for (const char* name : {"/floor", "/wall"}) scene.graph.set_visible(scene.graph.find(name), false);
    add_shape(scene, "speck", SolidTree(solid::Sphere{Vec3d(0, 0, 900), 0x1p-10}), 0);
    scene.render.interreflection = has_paths;
    RenderSettings settings = settings_of(1024, seed);
    settings.depth = 10;
    return render(scene, settings);
  };
  const double most = limit(std::size_t{width} * height);
  const Rendered all = picture(false, 1.5, 1), chosen = picture(true, 1.5, 2);
  EXPECT_LT(chosen.counters[Effect::refraction], all.counters[Effect::refraction]);
  EXPECT_LT(largest_z(all, chosen), most);
  EXPECT_GT(largest_z(all, picture(true, 1.7, 2)), most);
}

}  // namespace
}  // namespace sightline::test
