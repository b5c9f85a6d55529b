/// What a scene calls for is simulated, and nothing else.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>

#include "sightline/render/moments.h"
#include "sightline/scene/round_meshes.h"
#include "sightline/scene/scenes.h"
#include "sightline/scene/simple_meshes.h"
#include "tests/render/little_scenes.h"

namespace sightline::test {
namespace {

Scene ball_on_floor(const Material& of_ball) {
  Scene scene;
  add_shape(scene, "ball", SolidTree(solid::Sphere{}), add_material(scene, of_ball));
  add_shape(scene, "floor", SolidTree(solid::Box{Vec3d(-4, -2, -4), Vec3d(4, -1, 4)}),
            add_material(scene, lambert(0.5)));
  add_light(scene, PointLight{}, 50, Transform::translation({2, 5, 3}));
  add_camera(scene, 8, 40);
  return scene;
}

Effects effects_of(const Scene& scene, const RenderSettings& settings = small(8, 8)) {
  return Renderer(std::make_shared<const Scene>(scene), settings).plan().analysis.effects;
}

TEST(Plan, PlainSceneCallsForLightAndShadow) {
  EXPECT_EQ(effects_of(ball_on_floor(lambert(0.5))),
            (Effects{Effect::solids, Effect::direct_light, Effect::hard_shadow}));
}

TEST(Plan, RemovingTheLastGlassRemovesRefraction) {
  Scene scene = ball_on_floor(glass());
  const NodeId second = add_shape(scene, "second", SolidTree(solid::Sphere{Vec3d(2, 0, 0), 0.5}), 0);
  ASSERT_TRUE(effects_of(scene).has(Effect::refraction));
  scene.graph.set_visible(second, false);
  EXPECT_TRUE(effects_of(scene).has(Effect::refraction));
  scene.graph.set_visible(scene.graph.find("/ball"), false);
  EXPECT_FALSE(effects_of(scene).has(Effect::refraction));
  EXPECT_FALSE(effects_of(scene).has(Effect::mirror));

  scene.graph.set_visible(second, true);
  EXPECT_TRUE(effects_of(scene).has(Effect::refraction));
  scene.graph.set_material(second, 1);
  EXPECT_FALSE(effects_of(scene).has(Effect::refraction)) << "glass is still in the list, but nothing is made of it";
}

/// An operand's material counts where the operand is left in the solid.
TEST(Plan, OperandsAskForTheirMaterials) {
  Scene scene = ball_on_floor(lambert(0.5));
  add_material(scene, glass());
  SolidTree cut = solid::Sphere{Vec3d(3, 0, 0), 1};
  SolidTree bite = solid::Sphere{Vec3d(3, 0, 1), 0.5};
  bite.material = "glass";
  const NodeId node = add_shape(scene, "cut", cut - bite, 0);
  EXPECT_TRUE(effects_of(scene).has(Effect::refraction));
  SolidTree far_bite = solid::Sphere{Vec3d(30, 0, 1), 0.5};
  far_bite.material = "glass";
  scene.geometries[scene.graph.geometry(node)].shape = cut - far_bite;
  EXPECT_FALSE(effects_of(scene).has(Effect::refraction)) << "what is subtracted from nothing is gone";
}

TEST(Plan, UnboundTexturesAreNotOpened) {
  Scene scene = ball_on_floor(lambert(0.5));
  scene.textures.push_back({"missing", std::filesystem::path("no/such/image.png"), false, nullptr});
  Material unused = lambert(0.5);
  unused.color_texture = 0;
  add_material(scene, unused);
  EXPECT_FALSE(effects_of(scene).has(Effect::image_texture));
  scene.graph.set_material(scene.graph.find("/ball"), static_cast<std::uint32_t>(scene.materials.size() - 1));
  EXPECT_THROW(effects_of(scene), std::runtime_error);
}

TEST(Plan, EachEffectIsCalledForByWhatNeedsIt) {
  const auto added = [&](const std::function<void(Scene&)>& change, std::uint32_t samples = 1) {
    Scene scene = ball_on_floor(lambert(0.5));
    change(scene);
    Effects effects = effects_of(scene, small(8, 8, samples));
    for (const Effect usual : {Effect::solids, Effect::direct_light, Effect::hard_shadow}) effects.remove(usual);
    return effects;
  };
  EXPECT_EQ(added([](Scene&) {}, 4), (Effects{Effect::antialiasing}));
  EXPECT_EQ(added([](Scene& s) { s.materials[0].roughness = 0; }), (Effects{Effect::mirror}));
  EXPECT_EQ(added([](Scene& s) { s.materials[0].roughness = 0.3; }), (Effects{Effect::glossy}));
  EXPECT_EQ(added([](Scene& s) { s.materials[0].emission = Color(1); }), (Effects{Effect::emission}));
  EXPECT_EQ(added([](Scene& s) { s.fog.density = 1; }), (Effects{Effect::fog}));
  EXPECT_EQ(added([](Scene& s) { s.ambient.color = Color(1); }), (Effects{Effect::ambient}));
  EXPECT_EQ(added([](Scene& s) { s.ambient = {Color(1), 2}; }), (Effects{Effect::ambient_occlusion}));
  EXPECT_EQ(added([](Scene& s) { s.surroundings = {Color(1), 1, true}; }), (Effects{Effect::environment}));
  EXPECT_EQ(added([](Scene& s) { s.surroundings = {Color(1), 1, false}; }), Effects{});
  EXPECT_EQ(added([](Scene& s) { s.surroundings = {Color(0), 1, true}; }), Effects{});
  EXPECT_EQ(added([](Scene& s) { s.render.interreflection = true; }), (Effects{Effect::interreflection}));
  EXPECT_EQ(added([](Scene& s) { s.materials[0].dents.emplace(); }), (Effects{Effect::normal_map}));
  EXPECT_EQ(added([](Scene& s) { s.cameras[0].aperture = 1, s.cameras[0].focus_distance = 8; }, 4),
            (Effects{Effect::depth_of_field, Effect::antialiasing}));
  EXPECT_EQ(added([](Scene& s) { s.cameras[0].aperture = 1, s.cameras[0].focus_distance = 8; }), Effects{});
  EXPECT_EQ(added([](Scene& s) { s.lights[0].kind = AreaLight{}; }), (Effects{Effect::soft_shadow}));
  EXPECT_EQ(added([](Scene& s) {
              s.textures.push_back({"wood", std::string("wood"), false, nullptr});
              s.materials[0].color_texture = 0;
            }),
            (Effects{Effect::procedural_texture}));
}

TEST(Plan, MotionIsBlurredWhereSomethingMovesWhileTheShutterIsOpen) {
  Scene scene = ball_on_floor(lambert(0.5));
  Animation animation;
  Channel channel;
  channel.node = scene.graph.find("/ball");
  channel.translation.times = {0, 1};
  channel.translation.values = {Vec3d(0), Vec3d(1, 0, 0)};
  animation.channels = {channel};
  animation.is_loop = false;
  scene.animations = {animation};
  EXPECT_FALSE(effects_of(scene, small(8, 8, 4)).has(Effect::motion_blur));
  scene.cameras[0].shutter = {0, 1};
  EXPECT_TRUE(effects_of(scene, small(8, 8, 4)).has(Effect::motion_blur));
  EXPECT_FALSE(effects_of(scene, small(8, 8, 1)).has(Effect::motion_blur));
  scene.cameras[0].shutter = {2, 3};
  EXPECT_FALSE(effects_of(scene, small(8, 8, 4)).has(Effect::motion_blur)) << "it has stopped";
}

/// The smallest integrator that knows what is needed runs, and says what else it knows.
TEST(Plan, SmallestIntegratorRuns) {
  const Renderer plain(std::make_shared<const Scene>(ball_on_floor(lambert(0.5))), small(8, 8));
  EXPECT_EQ(plain.plan().integrator, "plain");
  EXPECT_EQ(plain.plan().unused, Effects{});
  for (const CompiledIntegrator& one : compiled_integrators()) {
    const CompiledIntegrator& chosen = integrator_for(one.knows);
    EXPECT_TRUE(chosen.knows.has_all(one.knows));
    EXPECT_LE(chosen.knows.count(), one.knows.count());
  }
  EXPECT_EQ(integrator_for(compiled_effects).name, compiled_integrators().back().name);
}

/// What was asked for by the scenes of data/, at a size that suits a test.
class EveryScene : public testing::TestWithParam<std::string> {
 protected:
  static std::filesystem::path data() { return std::filesystem::path(SIGHTLINE_SOURCE_DIR) / "data"; }
  static RenderSettings settings() {
    RenderSettings settings = small(48, 36, 2);
    settings.light_samples = 1;
    return settings;
  }
};

TEST_P(EveryScene, CountersOfUnusedEffectsAreZeroAndUsedOnesAreNot) {
  const Renderer renderer(std::make_shared<const Scene>(make_scene((data() / "scenes" / GetParam()).string(), data())),
                          settings());
  const Rendered picture = render(renderer);
  int used = 0;
  for (std::size_t i = 0; i < effect_count; ++i) {
    const auto effect = static_cast<Effect>(i);
    if (!renderer.plan().analysis.effects.has(effect)) {
      EXPECT_EQ(picture.counters[effect], 0u) << effect_names[i];
    } else {
      ++used;
    }
  }
  EXPECT_GT(used, 0);
}

/// Bit by bit what the integrator that knows all effects makes of it.
TEST_P(EveryScene, SpecializedEqualsSuperset) {
  const auto scene = std::make_shared<const Scene>(make_scene((data() / "scenes" / GetParam()).string(), data()));
  RenderSettings all = settings();
  all.knows_all = true;
  const Renderer special(scene, settings()), superset(scene, all);
  const Rendered a = render(special), b = render(superset);
  EXPECT_EQ(a.tile.sums, b.tile.sums);
  EXPECT_EQ(a.counters, b.counters);
}

std::vector<std::string> scene_files() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(SIGHTLINE_SOURCE_DIR) / "data" / "scenes")) {
    // Of materials alone; and one of millions of triangles.
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() == ".json" && name != "materials.json" && name != "many-teapots.json") {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Data, EveryScene, testing::ValuesIn(scene_files()), [](const auto& scene) {
  std::string name = scene.param.substr(0, scene.param.size() - 5);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

/// The same bits whatever the tiles, and in whatever parts samples come.
TEST(Renderer, PictureDoesNotDependOnTiles) {
  Scene scene = ball_on_floor(glass());
  scene.lights[0].kind = AreaLight{2, 2};
  scene.surroundings = {SkyGradient{Color(0.2f, 0.4f, 1), Color(1), Color(0.1f)}, 1, true};
  const Renderer renderer(std::make_shared<const Scene>(scene), small(37, 29, 6));
  const Rendered whole = render(renderer);
  RenderCounters counters;
  for (int y = 0; y < 29; y += 7) {
    for (int x = 0; x < 37; x += 11) {
      TileBuffer tile({x, y, std::min(11, 37 - x), std::min(7, 29 - y)});
      std::vector<std::uint32_t> pixels = all_pixels(tile.rect);
      std::reverse(pixels.begin(), pixels.end());
      renderer.add_samples(tile, pixels, {0, 1}, FactsAsked::none, counters);
      renderer.add_samples(tile, pixels, {1, 6}, FactsAsked::none, counters);
      for (std::size_t i = 0; i < tile.sums.size(); ++i) {
        const std::size_t at = static_cast<std::size_t>(y + static_cast<int>(i) / tile.rect.width) * 37 +
                               static_cast<std::size_t>(x + static_cast<int>(i) % tile.rect.width);
        ASSERT_EQ(tile.sums[i], whole.tile.sums[at]) << at;
      }
    }
  }
  EXPECT_EQ(counters, whole.counters);
}

/// Structures only find what is there: the picture is the same with each, and with two levels of them.
TEST(Renderer, PictureDoesNotDependOnTheStructure) {
  Scene scene = ball_on_floor(mirror());
  const std::uint32_t material = add_material(scene, lambert(0.6));
  for (int i = 0; i < 5; ++i) {
    add_shape(scene, "mesh" + std::to_string(i), make_sphere_geometry(), material,
              Transform::translation({1.5 * i - 3, 1.5, -1}) * Transform::scaling(Vec3d(0.5)));
  }
  const Rendered first = render(scene, small(32, 24));
  for (const AcceleratorInfo& info : accelerator_infos()) {
    RenderSettings settings = small(32, 24);
    settings.accelerator = info.name;
    EXPECT_EQ(render(scene, settings).tile.sums, first.tile.sums) << info.name;
    settings.flatten_up_to = 0;
    EXPECT_EQ(render(scene, settings).tile.sums, first.tile.sums) << info.name << " of instances";
  }
}

TEST(Renderer, FactsAreThoseOfTheFirstSample) {
  const Renderer renderer(std::make_shared<const Scene>(ball_on_floor(lambert(0.5))), small(9, 9));
  const Rendered seen = render(renderer, FactsAsked::with_work);
  const PixelFacts& middle = seen.tile.facts[4 * 9 + 4];
  EXPECT_FLOAT_EQ(middle.depth, 7);
  EXPECT_EQ(middle.normal, Vec3f(0, 0, 1));
  EXPECT_EQ(renderer.scene().moments[0]->posed.graph.path(middle.object), "/ball");
  EXPECT_GT(middle.work, 0u);
  EXPECT_EQ(seen.tile.facts[0].object, PixelFacts::no_object);
  EXPECT_EQ(seen.tile.sums, render(renderer).tile.sums);
}

TEST(Renderer, FingerprintFollowsWhatThePictureDependsOn) {
  const auto print = [](const Scene& scene, const RenderSettings& settings = small(8, 8)) {
    return Renderer(std::make_shared<const Scene>(scene), settings).fingerprint();
  };
  const Scene scene = ball_on_floor(lambert(0.5));
  const std::uint64_t base = print(scene);
  EXPECT_EQ(print(scene), base);
  const auto differs = [&](const std::function<void(Scene&)>& change) {
    Scene changed = scene;
    change(changed);
    return print(changed) != base;
  };
  EXPECT_TRUE(differs([](Scene& s) { s.materials[0].color.x += 0.01f; }));
  EXPECT_TRUE(differs([](Scene& s) { s.lights[0].intensity = 51; }));
  EXPECT_TRUE(differs([](Scene& s) { s.cameras[0].field_of_view = 41; }));
  EXPECT_TRUE(differs([](Scene& s) { s.geometries[0].shape = SolidTree(solid::Sphere{Vec3d(0), 1.5}); }));
  EXPECT_TRUE(differs([](Scene& s) { s.graph.set_local(s.graph.find("/ball"), Transform::translation({0.5, 0, 0})); }));
  EXPECT_TRUE(differs([](Scene& s) { s.fog.density = 0.1; }));
  RenderSettings seeded = small(8, 8);
  seeded.seed = 1;
  EXPECT_NE(print(scene, seeded), base);
  RenderSettings threaded = small(8, 8);
  threaded.threads = 2;
  EXPECT_EQ(print(scene, threaded), base);
}

TEST(Renderer, RefusesBadSettings) {
  const auto scene = std::make_shared<const Scene>(ball_on_floor(lambert(0.5)));
  const auto refuses = [&](const std::function<void(RenderSettings&)>& change) {
    RenderSettings settings = small(8, 8);
    change(settings);
    EXPECT_THROW(Renderer(scene, settings), std::invalid_argument);
  };
  refuses([](RenderSettings& s) { s.width = 0; });
  refuses([](RenderSettings& s) { s.height = -1; });
  refuses([](RenderSettings& s) { s.camera = "none"; });
  refuses([](RenderSettings& s) { s.depth = -1; });
  refuses([](RenderSettings& s) { s.cut_off = std::nan(""); });
  refuses([](RenderSettings& s) { s.error_bound = std::nan(""); });
  refuses([](RenderSettings& s) { s.shadow_error = -1; });
  refuses([](RenderSettings& s) { s.accelerator = "octree"; });
}

/// W3: what has not moved is built once for all moments, and seen as if it were not.
TEST(Renderer, MomentsShareWhatStandsStill) {
  const auto moving = [](const char* name) {
    Scene scene = ball_on_floor(lambert(0.5));
    add_shape(scene, "first", make_box(Vec3d(-1), Vec3d(1)));
    const auto box = scene.geometries.back().shape;
    add_shape(scene, "second", box, no_item, Transform::translation({0, 2, 0}));
    scene.cameras[0].shutter = {0, 1};
    Channel channel;
    channel.node = scene.graph.find(name);
    channel.translation = {{0, 1}, {Vec3d(0), Vec3d(0.5, 0, 0)}};
    scene.animations.push_back({"motion", {channel}, false});
    return scene;
  };
  const auto moments = [](const Scene& scene, std::uint64_t flatten_up_to) {
    RenderSettings settings = small(8, 8, 4);
    settings.flatten_up_to = flatten_up_to;
    return moments_of(scene, settings, 4);
  };
  for (const std::uint64_t flatten_up_to : {std::uint64_t{0}, std::uint64_t{1} << 20}) {
    const auto ball_moves = moments(moving("/ball"), flatten_up_to),
               box_moves = moments(moving("/first"), flatten_up_to);
    ASSERT_EQ(ball_moves.size(), 4u);
    ASSERT_EQ(box_moves.size(), 4u);
    for (std::size_t i = 1; i < 4; ++i) {
      EXPECT_TRUE(ball_moves[i]->world->shares_meshes_with(*ball_moves[0]->world));
      EXPECT_EQ(box_moves[i]->world->shares_meshes_with(*box_moves[0]->world), flatten_up_to == 0);
    }
  }
  const auto picture = [&](std::uint64_t flatten_up_to) {
    RenderSettings settings = small(16, 12, 4);
    settings.flatten_up_to = flatten_up_to;
    return render(moving("/first"), settings).tile.sums;
  };
  EXPECT_EQ(picture(0), picture(std::uint64_t{1} << 20));
}

}  // namespace
}  // namespace sightline::test
