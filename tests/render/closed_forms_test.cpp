/// Pictures of which every pixel is known in closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sightline/scene/round_meshes.h"
#include "sightline/scene/simple_meshes.h"
#include "tests/render/little_scenes.h"

namespace sightline::test {
namespace {

using std::numbers::pi;

/// Colors are floats, and a handful of them are multiplied.
constexpr double few_roundings = 16 * 0x1p-24;

void expect_gray(const Vec3d& color, double expected, const std::string& where) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(color[i], expected, few_roundings * std::fmax(expected, 0x1p-6)) << where;
}
std::string at(int x, int y) { return "pixel " + std::to_string(x) + ", " + std::to_string(y); }

/// The irradiance of a point light on a Lambert sphere: I cos / d^2, and radiance albedo / pi of it.
TEST(ClosedForms, SphereUnderAPointLight) {
  constexpr double distance = 5, albedo = 0.5, intensity = 40;
  const Vec3d lamp(3, 4, 5);
  Scene scene;
  add_shape(scene, "sphere", SolidTree(solid::Sphere{}), add_material(scene, lambert(albedo)));
  add_light(scene, PointLight{}, intensity, Transform::translation(lamp));
  add_camera(scene, distance, 30);
  constexpr int size = 33;
  const Rendered picture = render(scene, small(size, size));
  int lit = 0, dark = 0, missed = 0;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double edge = std::tan(15 * pi / 180);
      const Vec3d way = glm::normalize(Vec3d(edge * (2 * x + 1 - size) / size, edge * (size - 2 * y - 1) / size, -1));
      const double b = -distance * way.z, disc = b * b - (distance * distance - 1);
      double expected = 0;
      if (disc > 0) {
        const Vec3d p = Vec3d(0, 0, distance) + (b - std::sqrt(disc)) * way;
        const Vec3d to_lamp = lamp - p;
        const double cosine = glm::dot(p, glm::normalize(to_lamp));
        expected = albedo / pi * intensity * std::fmax(0, cosine) / glm::dot(to_lamp, to_lamp);
        ++(cosine > 0 ? lit : dark);
      } else {
        ++missed;
      }
      expect_gray(picture.mean(x, y), expected, at(x, y));
    }
  }
  EXPECT_GT(lit, 200);
  EXPECT_GT(dark, 20);
  EXPECT_GT(missed, 200);
}

/// In a white world a convex surface sends back its albedo, whichever way it is asked.
TEST(ClosedForms, FurnaceShowsTheAlbedo) {
  for (const bool has_interreflection : {false, true}) {
    Scene scene;
    add_shape(scene, "sphere", SolidTree(solid::Sphere{}), add_material(scene, lambert(0.625)));
    scene.surroundings.background = Color(1);
    scene.surroundings.lights = true;
    scene.render.interreflection = has_interreflection;
    add_camera(scene, 3, 30);
    const Rendered picture = render(scene, small(8, 8, 4));
    for (int i = 2; i < 6; ++i) expect_gray(picture.mean(i, i), 0.625, at(i, i));
    expect_gray(render(scene, small(1, 1, 1)).mean(0), 0.625, "alone");
  }
}

/// Seen from within: a surface that shines by 1/4, and reflects half of what it takes in.
Scene closed_furnace() {
  Scene scene;
  Material material = lambert(0.5);
  material.emission = Color(0.25);
  add_shape(scene, "hollow", SolidTree(solid::Sphere{Vec3d(0), 4}) - SolidTree(solid::Sphere{Vec3d(0), 3}),
            add_material(scene, material));
  scene.render.interreflection = true;
  add_camera(scene, 1, 90);
  return scene;
}

/// Within a closed surface that shines by e and reflects r of what it takes in: after n bounces e (1 + r + ... + r^n).
TEST(ClosedForms, ClosedFurnaceIsAGeometricSeries) {
  const Scene scene = closed_furnace();
  for (const int depth : {0, 1, 3}) {
    RenderSettings settings = small(6, 6, 2);
    settings.depth = depth;
    const Rendered picture = render(scene, settings);
    const double expected = 0.25 * (1 - std::pow(0.5, depth + 1)) / 0.5;
    for (int i = 0; i < 6; ++i) expect_gray(picture.mean(i, i), expected, std::to_string(depth) + " bounces");
  }
}

/// Chance that ends paths early takes nothing from the mean: e / (1 - r) after any number of bounces.
TEST(ClosedForms, RouletteIsUnbiased) {
  const Scene scene = closed_furnace();
  RenderSettings settings = small(8, 8, 256);
  settings.depth = 60;
  const Rendered picture = render(scene, settings);
  double mean = 0, variance = 0;
  for (std::size_t i = 0; i < 64; ++i) {
    const PixelSum& sum = picture.tile.sums[i];
    const double own = picture.mean(i).x;
    mean += own / 64;
    variance += (sum.luminance_squares / sum.samples - own * own) / sum.samples / (64 * 64);
  }
  EXPECT_GT(variance, 0);
  EXPECT_NEAR(mean, 0.5, 5 * std::sqrt(variance));
}

/// Glass and mirrors take nothing away and add nothing.
TEST(ClosedForms, GlassKeepsEnergy) {
  for (const bool has_interreflection : {false, true}) {
    Scene scene;
    add_shape(scene, "ball", SolidTree(solid::Sphere{}), add_material(scene, glass()));
    // Something to scatter light, out of sight, so that interreflection is asked for.
    add_shape(scene, "speck", SolidTree(solid::Sphere{Vec3d(0, 0, 900), 0x1p-10}), add_material(scene, lambert(1)));
    scene.surroundings.background = Color(1);
    scene.surroundings.lights = true;
    scene.render.interreflection = has_interreflection;
    add_camera(scene, 3, 45);
    RenderSettings settings = small(16, 16, 1);
    settings.depth = 12;
    settings.cut_off = 0;
    const Rendered picture = render(scene, settings);
    for (std::size_t i = 0; i < 256; ++i) {
      const double value = picture.mean(i).x;
      EXPECT_LE(value, 1 + few_roundings) << i;
      // What is still within after twelve times: nearly nothing but at the rim.
      EXPECT_GE(value, 1 - 0.02) << i;
    }
    EXPECT_GT(picture.counters[Effect::refraction], 100u);
  }
}

TEST(ClosedForms, MirrorsAndGlossyMetalsKeepEnergy) {
  for (const double roughness : {0.0, 0.2, 0.6, 1.0}) {
    for (const double metallic : {0.0, 0.5, 1.0}) {
      Scene scene;
      Material material = lambert(1);
      material.roughness = roughness;
      material.metallic = metallic;
      add_shape(scene, "ball", SolidTree(solid::Sphere{}), add_material(scene, material));
      scene.surroundings.background = Color(1);
      scene.surroundings.lights = true;
      add_camera(scene, 3, 30);
      RenderSettings settings = small(8, 8, 64);
      settings.cut_off = 0;
      const Rendered picture = render(scene, settings);
      for (std::size_t i = 0; i < 64; ++i) {
        const double value = picture.mean(i).x;
        EXPECT_LE(value, 1 + few_roundings) << roughness << " " << metallic;
        // Light that facets send to each other is not followed further.
        EXPECT_GE(value, roughness == 0  ? 1 - few_roundings
                         : roughness < 1 ? 0.6
                                         : 0.28)
            << roughness << " " << metallic;
      }
    }
  }
}

/// Straight on, facets with alpha = 1 have normals as likely as their cosine; with u = sin^2 of a facet's angle, even
/// in [0, 1], light leaves at the cosine c = 1 - 2u, and the share 2c / (1 + c) of it is seen: in all the integral of
/// c / (1 + c) over c from 0 to 1.
TEST(ClosedForms, RoughestMetalStraightOn) {
  Scene scene;
  Material material = mirror();
  material.roughness = 1;
  add_shape(scene, "plate", SolidTree(solid::Box{Vec3d(-9, -9, -1), Vec3d(9, 9, 0)}), add_material(scene, material));
  scene.surroundings = {Color(1), 1, true};
  add_camera(scene, 4, 0x1p-10);
  RenderSettings settings = small(1, 1, 4096);
  settings.cut_off = 0;
  EXPECT_NEAR(render(scene, settings).mean(0).x, 1 - std::log(2), 0.005);
}

/// Beer's law along the middle of a plate that reflects nothing.
TEST(ClosedForms, BeersLaw) {
  Scene scene;
  Material material = glass(1);
  material.absorption = {0.5, 1, 2};
  add_shape(scene, "plate", SolidTree(solid::Box{Vec3d(-9, -9, -1), Vec3d(9, 9, 1)}), add_material(scene, material));
  scene.surroundings.background = Color(1);
  add_camera(scene, 3, 1);
  const Vec3d color = render(scene, small(1, 1)).mean(0);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(color[i], std::exp(-2.0 * material.absorption[i]), few_roundings);
}

/// The form factor from a point to a rectangle across from it, of edges 2a and 2b in the distance h: four times that to
/// a quarter. Hottel, "Radiant Heat Transmission", 1954.
TEST(ClosedForms, AreaLightHasItsFormFactor) {
  constexpr double a = 1, b = 0.5, h = 2, radiance = 3, albedo = 0.8;
  Scene scene;
  add_shape(scene, "floor", SolidTree(solid::Box{Vec3d(-9, -9, -1), Vec3d(9, 9, 0)}),
            add_material(scene, lambert(albedo)));
  add_light(scene, AreaLight{2 * a, 2 * b}, radiance, Transform::translation({0, 0, h}));
  add_camera(scene, 1, 0x1p-10 * 180 / pi);
  const double x = a / h, y = b / h, rx = std::sqrt(1 + x * x), ry = std::sqrt(1 + y * y);
  const double factor = 4 / (2 * pi) * (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry));
  const Rendered picture = render(scene, small(1, 1, 4096));
  const PixelSum& sum = picture.tile.sums[0];
  const double mean = picture.mean(0).x;
  const double deviation = std::sqrt((sum.luminance_squares / sum.samples - mean * mean) / sum.samples);
  EXPECT_NEAR(mean, albedo * radiance * factor, 4 * deviation);
  // Even samples do far better than that: their error falls nearly as their number grows.
  EXPECT_NEAR(mean, albedo * radiance * factor, 1e-3);
  EXPECT_GT(picture.counters[Effect::soft_shadow], 0u);
}

/// A ceiling does not shadow the lamp that is in its very plane, be it a solid or a mesh.
TEST(ClosedForms, LampsShineFromCeilings) {
  constexpr float h = 2.3f;
  const auto light_at_middle = [](const std::optional<std::variant<MeshGeometry, SolidTree>>& ceiling) {
    Scene scene;
    const std::uint32_t white = add_material(scene, lambert(1));
    add_shape(scene, "floor", SolidTree(solid::Box{Vec3d(-9, -9, -1), Vec3d(9, 9, 0)}), white);
    if (ceiling) add_shape(scene, "ceiling", *ceiling, white);
    add_light(scene, AreaLight{1, 2}, 3, Transform::translation({0.1, 0, h}));
    add_light(scene, SpotLight{}, 3, Transform::translation({0.7, 0.3, h}));
    add_camera(scene, 1, 0x1p-10);
    return render(scene, small(1, 1, 64)).mean(0).x;
  };
  const double open = light_at_middle(std::nullopt);
  EXPECT_GT(open, 0.1);
  EXPECT_EQ(light_at_middle(SolidTree(solid::Box{{-9, -9, h}, {9, 9, h + 1.0}})), open);
  const std::vector<Vec3f> corners{{-9, -9, h}, {9, -9, h}, {0, 9, h}};
  const std::vector<TriangleMesh::Corners> triangles{{0, 1, 2}};
  EXPECT_EQ(light_at_middle(MeshGeometry{std::make_shared<const TriangleMesh>(corners, triangles), {}, {}}), open);
}

/// Half of a lamp that a wall hides gives half the light on the axis.
TEST(ClosedForms, HalfHiddenLampGivesHalf) {
  const auto light_at_middle = [](bool has_wall, double shadow_error) {
    Scene scene;
    const std::uint32_t white = add_material(scene, lambert(1));
    add_shape(scene, "floor", SolidTree(solid::Box{Vec3d(-9, -9, -1), Vec3d(9, 9, 0)}), white);
    if (has_wall) add_shape(scene, "wall", SolidTree(solid::Box{Vec3d(0, -9, 1.5), Vec3d(9, 9, 1.75)}), white);
    add_light(scene, AreaLight{2, 2}, 1, Transform::translation({0, 0, 3}));
    add_camera(scene, 1, 0x1p-10);
    RenderSettings settings = small(1, 1, 4096);
    settings.shadow_error = shadow_error;
    return render(scene, settings).mean(0).x;
  };
  const double whole = light_at_middle(false, 0);
  EXPECT_NEAR(light_at_middle(true, 0) / whole, 0.5, 0.01);
  for (const double error : {0x1p-10, 0x1p-8}) EXPECT_NEAR(light_at_middle(true, error), whole / 2, 4 * error);
}

/// A mirror shows what one would see from behind it.
TEST(ClosedForms, MirrorShowsWhatIsSeenFromBehindIt) {
  const auto scene_of = [](bool has_mirror) {
    Scene scene;
    const std::uint32_t shiny = add_material(scene, mirror());
    // The mirror is the plane x = 1, the ball left of it.
    add_shape(scene, "ball", SolidTree(solid::Sphere{Vec3d(-2, 0, 0), 1}), add_material(scene, lambert(0.5)));
    if (has_mirror) add_shape(scene, "mirror", SolidTree(solid::Box{Vec3d(1, -9, -9), Vec3d(2, 9, 9)}), shiny);
    add_light(scene, PointLight{}, 60, Transform::translation({-4, 3, 4}));
    return scene;
  };
  const auto seen_from = [](Scene scene, const Vec3d& eye, const Vec3d& target) {
    SceneCamera camera;
    const Vec3d back = glm::normalize(eye - target), right = glm::normalize(glm::cross(Vec3d(0, 1, 0), back)),
                up = glm::cross(back, right);
    Affine map;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto k = static_cast<glm::length_t>(i);
      map.rows[i] = {right[k], up[k], back[k], eye[k]};
    }
    camera.node = scene.graph.add(root_node, "camera", Transform::of(map));
    camera.field_of_view = 30;
    scene.cameras.push_back(camera);
    return render(scene, small(24, 24));
  };
  const Rendered in_mirror = seen_from(scene_of(true), {-3, 0, 8}, {1, 0, 3});
  const Rendered from_behind = seen_from(scene_of(false), {5, 0, 8}, {1, 0, 3});
  int lit = 0;
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 24; ++x) {
      const double seen = in_mirror.mean(x, y).x, expected = from_behind.mean(23 - x, y).x;
      // At the rim a ray's rounding decides whether it meets the ball.
      if ((seen > 0) != (expected > 0)) continue;
      EXPECT_NEAR(seen, expected, 1e-5) << at(x, y);
      lit += seen > 0;
    }
  }
  EXPECT_GT(lit, 20);
}

/// What is the same on both sides is drawn the same on both sides, to the bit.
TEST(ClosedForms, MirrorSymmetricSceneGivesMirrorSymmetricPicture) {
  Scene scene;
  const std::uint32_t material = add_material(scene, lambert(0.7));
  add_shape(scene, "left", SolidTree(solid::Sphere{Vec3d(-1.25, 0, 0), 1}), material);
  add_shape(scene, "right", SolidTree(solid::Sphere{Vec3d(1.25, 0, 0), 1}), material);
  add_shape(scene, "floor", SolidTree(solid::Box{Vec3d(-4, -2, -4), Vec3d(4, -1, 4)}), add_material(scene, mirror()));
  add_light(scene, PointLight{}, 50, Transform::translation({0, 5, 3}));
  add_camera(scene, 8, 40);
  constexpr int size = 32;
  const Rendered picture = render(scene, small(size, size));
  int lit = 0;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size / 2; ++x) {
      EXPECT_EQ(picture.mean(x, y), picture.mean(size - 1 - x, y)) << at(x, y);
      lit += picture.mean(x, y).x > 0;
    }
  }
  EXPECT_GT(lit, 50);
}

/// The share exp(-density d) of a wall is seen through fog of its own color.
TEST(ClosedForms, FogDimsWithDistance) {
  Scene scene;
  Material shining = lambert(0);
  shining.color = Color(0);
  shining.emission = Color(1);
  add_shape(scene, "wall", SolidTree(solid::Box{Vec3d(-9, -9, -1), Vec3d(9, 9, 0)}), add_material(scene, shining));
  scene.fog = {0.25, Color(0.5)};
  add_camera(scene, 4, 0x1p-10);
  const double left = std::exp(-0.25 * 4);
  expect_gray(render(scene, small(1, 1)).mean(0), left + 0.5 * (1 - left), "through fog");
}

/// Of a point in a corner of two walls as long as the light reaches, half of all directions are shut out.
TEST(ClosedForms, AmbientOcclusionInACorner) {
  Scene scene;
  const std::uint32_t white = add_material(scene, lambert(1));
  add_shape(scene, "floor", SolidTree(solid::Box{Vec3d(-100, -100, -1), Vec3d(100, 100, 0)}), white);
  add_shape(scene, "wall", SolidTree(solid::Box{Vec3d(0x1p-7, -100, 0), Vec3d(1, 100, 100)}), white);
  scene.ambient = {Color(1), 50};
  add_camera(scene, 2, 0x1p-10);
  const Rendered picture = render(scene, small(1, 1, 1024));
  EXPECT_NEAR(picture.mean(0).x, 0.5, 0.01);
  EXPECT_EQ(picture.counters[Effect::ambient_occlusion], 1024u);
  EXPECT_EQ(picture.counters[Effect::ambient], 0u);
}

}  // namespace
}  // namespace sightline::test
