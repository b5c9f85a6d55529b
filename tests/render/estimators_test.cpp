/// Two ways to the same light have to agree in every pixel, as far as chance lets one see.
///
/// For each pixel the difference of two means, over its standard error, is compared with what a normal distribution
/// exceeds in one of a million pictures (Bonferroni's correction for so many pixels). Samples of a pixel are more even
/// than independent ones, so the errors are estimates from above: the test is never too strict. That it sees faults is
/// shown by a surface that is a little brighter.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/render/little_scenes.h"

namespace sightline::test {
namespace {

constexpr int width = 16, height = 12;

/// The largest |z| of all pixels; pixels without scatter have to be equal but for rounding.
/// \param hidden a standard error that samples may not show, because it is seldom and large.
double largest_z(const Rendered& a, const Rendered& b, double hidden = 0) {
  double largest = 0;
  for (std::size_t i = 0; i < a.tile.sums.size(); ++i) {
    const auto mean = [&](const Rendered& r) { return PixelSum::luminance(r.mean(i)); };
    const auto variance = [&](const Rendered& r) {
      const PixelSum& sum = r.tile.sums[i];
      return std::fmax(0, sum.luminance_squares / sum.samples - mean(r) * mean(r)) / sum.samples;
    };
    const double rounding = 0x1p-18;
    const double error = std::sqrt(variance(a) + variance(b) + hidden * hidden) + rounding;
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
  settings.shadow_error = 0;  // errors that are rare and large are tested by themselves
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

/// A lamp that the balls hide in part.
Scene under_a_lamp(double albedo, double radiance = 6) {
  Scene scene = under_the_sky(albedo);
  scene.surroundings = {};
  add_light(scene, AreaLight{1.5, 1.5}, radiance,
            Transform::translation({0, 3, 2.5}) * Transform::rotation(Vec3d(1, 0, 0), -70));
  return scene;
}

/// Rays to a lamp that are not sent are missed by nobody: at the first surface, and at those that paths come to. What
/// they add is seldom and large, so a sample tells little of its size: whole pictures are the samples here.
TEST(Estimators, RaysThatAreSparedAreNotMissed) {
  constexpr std::uint32_t pictures = 256;
  constexpr double bound = 0x1p-5;
  struct Pictures {
    Rendered each{TileBuffer({0, 0, width, height}), {}}, whole{TileBuffer({0, 0, 1, 1}), {}};
  };
  for (const bool has_paths : {false, true}) {
    const auto render_all = [&](double shadow_error, double radiance, std::uint64_t first_seed) {
      Scene scene = under_a_lamp(0.7, radiance);
      scene.render.interreflection = has_paths;
      Pictures all;
      for (std::uint32_t i = 0; i < pictures; ++i) {
        RenderSettings settings = settings_of(16, first_seed + i);
        settings.depth = 3;
        settings.shadow_error = shadow_error;
        const Rendered one = render(scene, settings);
        Vec3d sum(0);
        for (std::size_t k = 0; k < one.tile.sums.size(); ++k) {
          all.each.tile.sums[k].add(one.mean(k));
          sum += one.mean(k);
        }
        all.whole.tile.sums[0].add(sum / double(width * height));
        all.each.counters += one.counters;
      }
      return all;
    };
    const double most = limit(std::size_t{width} * height), hidden = bound / std::sqrt(double(pictures));
    const Pictures all = render_all(0, 6, 0), few = render_all(bound, 6, 1000), brighter = render_all(bound, 6.1, 1000);
    EXPECT_EQ(all.each.counters.shadow_rays_spared + all.each.counters.shadow_trials, 0u);
    EXPECT_LT(1.25 * double(few.each.counters[Effect::soft_shadow]), double(all.each.counters[Effect::soft_shadow]));
    EXPECT_GT(few.each.counters.shadow_trials, 0u);
    EXPECT_LT(largest_z(all.each, few.each, hidden), most);
    EXPECT_LT(largest_z(all.whole, few.whole), limit(1));
    EXPECT_GT(largest_z(all.whole, brighter.whole), limit(1)) << "the test has to see a lamp that is brighter";
  }
}

/// What they add, as root of the mean square of all pixels, is below the bound, and a tighter bound spares fewer.
TEST(Estimators, SparedRaysKeepTheirBound) {
  const auto picture = [](double shadow_error) {
    RenderSettings settings = settings_of(64, 5);
    settings.shadow_error = shadow_error;
    return render(under_a_lamp(0.7), settings);
  };
  const Rendered all = picture(0);
  std::uint64_t spared = ~std::uint64_t{0};
  for (const double bound : {0x1p-4, 0x1p-6, 0x1p-8}) {
    const Rendered few = picture(bound);
    double squares = 0;
    for (std::size_t i = 0; i < all.tile.sums.size(); ++i) {
      const double error = PixelSum::luminance(few.mean(i) - all.mean(i));
      squares += error * error;
    }
    EXPECT_GT(squares, 0) << bound;
    EXPECT_LT(std::sqrt(squares / (width * height)), bound);
    EXPECT_LT(few.counters.shadow_rays_spared, spared);
    spared = few.counters.shadow_rays_spared;
  }
  EXPECT_GT(spared, 0u);
}

/// One call, and one a pass, on tiles that go from hand to hand; and the integrator that knows all.
TEST(Estimators, SparedRaysDoNotDependOnTheWayThere) {
  RenderSettings settings = settings_of(24, 5);
  settings.shadow_error = 0x1p-5;
  const auto scene = std::make_shared<const Scene>(under_a_lamp(0.7));
  const Renderer renderer(scene, settings);
  const Rendered at_once = render(renderer);
  EXPECT_GT(at_once.counters.shadow_rays_spared, 0u);
  Rendered in_passes{TileBuffer({0, 0, width, height}), {}};
  for (const auto& [first, last] : std::to_array<std::array<std::uint32_t, 2>>({{0, 3}, {3, 4}, {4, 13}, {13, 24}})) {
    for (int x = 0; x < width; x += 4) {
      TileBuffer tile({x, 0, 4, height});
      for (std::size_t i = 0; i < tile.sums.size(); ++i) tile.sums[i] = in_passes.tile.sums[i / 4 * width + x + i % 4];
      renderer.add_samples(tile, all_pixels(tile.rect), {first, last}, FactsAsked::none, in_passes.counters);
      for (std::size_t i = 0; i < tile.sums.size(); ++i) in_passes.tile.sums[i / 4 * width + x + i % 4] = tile.sums[i];
    }
  }
  EXPECT_EQ(in_passes.tile.sums, at_once.tile.sums);
  EXPECT_EQ(in_passes.counters, at_once.counters);
  settings.knows_all = true;
  const Rendered by_all = render(Renderer(scene, settings));
  EXPECT_EQ(by_all.tile.sums, at_once.tile.sums);
  EXPECT_EQ(by_all.counters, at_once.counters);
}

/// The balls under an image of the sky, as lambert surfaces or of a material.
Scene in_a_studio(double albedo, std::optional<Material> of_balls = {}) {
  Scene scene = under_the_sky(albedo);
  SkyImage sky;
  sky.image = SIGHTLINE_SOURCE_DIR "/data/scenes/images/studio.exr";
  sky.rotation = 40;
  scene.surroundings = {sky, 1, true};
  if (of_balls) {
    const std::uint32_t material = add_material(scene, *of_balls);
    for (const char* name : {"/ball", "/small"}) scene.graph.set_material(scene.graph.find(name), material);
  }
  return scene;
}

/// A bright sky by asking where it is bright, and by paths of one bounce that know nothing of it.
TEST(Estimators, BrightSkyByAskingAndByPaths) {
  const auto picture = [](bool has_paths, double albedo, std::uint64_t seed) {
    Scene scene = in_a_studio(albedo);
    scene.render.interreflection = has_paths;
    RenderSettings settings = settings_of(1024, seed);
    settings.depth = 1;
    return render(scene, settings);
  };
  const auto scatter = [](const Rendered& r) {
    double all = 0;
    for (std::size_t i = 0; i < r.tile.sums.size(); ++i) {
      const PixelSum& sum = r.tile.sums[i];
      all += sum.luminance_squares / sum.samples - std::pow(PixelSum::luminance(r.mean(i)), 2);
    }
    return all;
  };
  const double most = limit(std::size_t{width} * height);
  const Rendered asked = picture(false, 0.7, 1), paths = picture(true, 0.7, 2);
  EXPECT_LT(largest_z(asked, paths), most);
  EXPECT_LT(4 * scatter(asked), scatter(paths)) << "what it is for";
  EXPECT_GT(largest_z(asked, picture(true, 1, 2)), most);
}

/// The same in rough metal and under a clear coat, whose reflections are shared out between two ways.
TEST(Estimators, BrightSkyInGlossyBalls) {
  for (const double metallic : {1.0, 0.0}) {
    const auto picture = [&](bool has_paths, double albedo, std::uint64_t seed) {
      Material material = lambert(albedo);
      material.metallic = metallic;
      material.roughness = 0.5;
      Scene scene = in_a_studio(0.7, material);
      scene.render.interreflection = has_paths;
      // Not what lies between them, which paths follow farther.
      for (const char* name : {"/floor", "/wall", "/small"}) scene.graph.set_visible(scene.graph.find(name), false);
      add_shape(scene, "speck", SolidTree(solid::Sphere{Vec3d(0, 0, 900), 0x1p-10}), 0);
      RenderSettings settings = settings_of(1024, seed);
      settings.depth = 1;
      return render(scene, settings);
    };
    const double most = limit(std::size_t{width} * height);
    const Rendered asked = picture(false, 0.5, 1), paths = picture(true, 0.5, 2);
    EXPECT_GT(asked.counters[Effect::environment], 0u);
    EXPECT_EQ(paths.counters[Effect::environment], 0u);
    EXPECT_LT(largest_z(asked, paths), most) << metallic;
    EXPECT_GT(largest_z(asked, picture(true, 0.8, 2)), most) << metallic;
  }
}

}  // namespace
}  // namespace sightline::test
