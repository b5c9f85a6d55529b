#include "bench/render/ladder_scenes.h"

#include <cmath>
#include <functional>
#include <numbers>

#include "bench/solids/scene.h"
#include "sightline/scene/simple_meshes.h"

namespace sightline::bench {
namespace {

constexpr double ball_radius = 1.2, camera_distance = 7;
const Vec3d lamp_place(3, 6, 4);
constexpr std::uint32_t ball_geometry = 0, ball_material = 1;

std::uint32_t add_gray(Scene& scene, const std::string& name) {
  Material material;
  material.name = name;
  material.color = Color(0.7f);
  scene.materials.push_back(material);
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

NodeId add(Scene& scene, const std::string& name, const MeshGeometry& mesh, std::uint32_t material, const Vec3d& at) {
  scene.geometries.push_back({name, mesh});
  const NodeId node = scene.graph.add(root_node, name, Transform::translation(at));
  scene.graph.set_geometry(node, static_cast<std::uint32_t>(scene.geometries.size() - 1));
  scene.graph.set_material(node, material);
  return node;
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// Turns -z to the middle of the scene.
Transform facing_down_from(const Vec3d& place) {
  const double yaw = degrees(std::atan2(place.x, place.z));
  const double pitch = degrees(std::atan2(place.y, std::hypot(place.x, place.z)));
  return Transform::translation(place) * Transform::rotation({0, 1, 0}, yaw) * Transform::rotation({1, 0, 0}, -pitch);
}

/// A scene that rungs change.
struct Draft {
  Scene scene;
  NodeId ball = root_node;

  Material& material() { return scene.materials[ball_material]; }
  Light& lamp() { return scene.lights[0]; }
  SceneCamera& camera() { return scene.cameras[0]; }

  std::uint32_t add_texture(std::variant<std::string, std::filesystem::path> source, bool is_data = false) {
    scene.textures.push_back({"texture", std::move(source), is_data, nullptr});
    return static_cast<std::uint32_t>(scene.textures.size() - 1);
  }
};

Draft draft() {
  Draft draft;
  Scene& scene = draft.scene;
  const std::uint32_t gray = add_gray(scene, "gray");
  add_gray(scene, "ball");
  draft.ball = add(scene, "ball", make_sphere(ball_radius, 64), ball_material, {0, ball_radius, 0});
  add(scene, "floor", make_quad(24, 24, 1), gray, {0, 0, 0});
  add(scene, "small ball", make_sphere(0.6, 64), gray, {-2, 0.6, 0.6});
  add(scene, "box", make_box({-0.5, 0, -0.5}, {0.5, 1.2, 0.5}), gray, {2, 0, 0.3});

  Light lamp;
  lamp.name = "lamp";
  lamp.node = scene.graph.add(root_node, "lamp", facing_down_from(lamp_place));
  lamp.kind = PointLight{};
  lamp.intensity = std::numbers::pi * glm::dot(lamp_place, lamp_place);
  scene.lights.push_back(lamp);

  SceneCamera camera;
  camera.name = "view";
  camera.node = scene.graph.add(root_node, "view",
                                Transform::translation({0, 0.8, 0}) * facing_down_from({0, 1.8, camera_distance}));
  camera.field_of_view = 35;
  scene.cameras.push_back(camera);
  return draft;
}

class Builder {
 public:
  explicit Builder(const std::filesystem::path& data_dir) : images_(data_dir / "scenes" / "images") {}

  using Change = std::function<void(Draft&)>;

  /// On the rung named `over`, whose change it goes on from.
  Rung& add(std::string_view name, std::string_view over, Effects adds, std::string what, const Change& change) {
    Draft own = over.empty() ? draft() : drafts_[index_of_rung(over)];
    change(own);
    Rung rung{std::string(name), std::string(over), std::nullopt, adds, std::move(what), nullptr, 1, false};
    if (!over.empty()) rung.samples = rungs_[index_of_rung(over)].samples;
    rung.scene = std::make_shared<const Scene>(own.scene);
    drafts_.push_back(std::move(own));
    rungs_.push_back(std::move(rung));
    return rungs_.back();
  }
  Rung& add(Effect effect, std::string_view over, std::string what, const Change& change) {
    Rung& rung = add(effect_names[sightline::index_of(effect)], over, {effect}, std::move(what), change);
    rung.effect = effect;
    return rung;
  }
  Rung& add(Effect effect, std::string what, const Change& change) {
    return add(effect, base_rung, std::move(what), change);
  }
  std::filesystem::path image(const char* name) const { return images_ / name; }
  std::vector<Rung> finish() { return std::move(rungs_); }

 private:
  std::size_t index_of_rung(std::string_view name) const {
    std::size_t i = 0;
    while (rungs_.at(i).name != name) ++i;
    return i;
  }

  std::filesystem::path images_;
  std::vector<Draft> drafts_;
  std::vector<Rung> rungs_;
};

void add_light(Builder& builder) {
  builder.add("unlit", "", {Effect::meshes, Effect::ambient}, "light from everywhere, that nothing shuts out",
              [](Draft& d) {
                d.scene.lights.clear();
                d.scene.ambient.color = Color(0.4f);
              });
  Rung& base = builder.add(base_rung, "unlit", {Effect::direct_light, Effect::hard_shadow}, "a point light",
                           [](Draft& d) { d = draft(); });
  base.effect = Effect::hard_shadow;
  builder.add(again_rung, base_rung, {}, "the same, to see what is noise", [](Draft&) {});
  builder.add(Effect::soft_shadow, "a square lamp, sixteen rays to it", [](Draft& d) {
    constexpr double side = 2;
    d.lamp().kind = AreaLight{side, side};
    d.lamp().intensity /= side * side;
  });
  builder.add(Effect::ambient, "light from everywhere as well", [](Draft& d) { d.scene.ambient.color = Color(0.2f); });
  builder.add(Effect::ambient_occlusion, effect_names[index_of(Effect::ambient)], "which what is near shuts out",
              [](Draft& d) { d.scene.ambient.occlusion_distance = 2; });
  builder.add(Effect::environment, "a sky that lights", [](Draft& d) {
    d.scene.surroundings.background = SkyGradient{Color(0.3f, 0.4f, 0.6f), Color(0.6f), Color(0.2f)};
    d.scene.surroundings.lights = true;
  });
  builder.add(Effect::interreflection, "light by way of up to eight surfaces",
              [](Draft& d) { d.scene.render.interreflection = true; });
  builder.add(Effect::fog, "in all of space", [](Draft& d) { d.scene.fog = {0.05, Color(0.5f)}; });
}

void add_surfaces(Builder& builder) {
  builder.add(Effect::emission, "the ball glows", [](Draft& d) { d.material().emission = Color(0.3f); });
  builder.add(Effect::mirror, "the ball is a mirror", [](Draft& d) {
    d.material().metallic = 1;
    d.material().roughness = 0;
  });
  builder.add(Effect::glossy, "the ball is brushed metal", [](Draft& d) {
    d.material().metallic = 1;
    d.material().roughness = 0.4;
  });
  builder.add(Effect::refraction, effect_names[index_of(Effect::mirror)], "the ball is glass", [](Draft& d) {
    d.material().color = Color(1);
    d.material().metallic = 0;
    d.material().transmission = 1;
  });
  builder.add(Effect::absorption, effect_names[index_of(Effect::refraction)], "of green glass", [](Draft& d) {
    d.material().absorption = {0.8f, 0.1f, 0.5f};
  });
  builder.add(Effect::procedural_texture, "the ball is of wood",
              [](Draft& d) { d.material().color_texture = d.add_texture(std::string("wood:texture_frequency=3")); });
  builder.add(Effect::image_texture, "the ball has a map on it",
              [&](Draft& d) { d.material().color_texture = d.add_texture(builder.image("map.png")); });
  builder.add(Effect::normal_map, "the ball is of bricks",
              [&](Draft& d) { d.material().normal_map = d.add_texture(builder.image("bricks_normal.png"), true); });
}

void add_shapes(Builder& builder) {
  builder.add(Effect::solids, "in place of the ball, box & sphere - three cylinders",
              [](Draft& d) { d.scene.geometries[ball_geometry].shape = widget(Vec3d(0), ball_radius); });
  builder.add(Effect::instances, "the meshes are not put into one", [](Draft&) {}).has_instances = true;
}

void add_camera(Builder& builder) {
  const std::string_view smooth = effect_names[index_of(Effect::antialiasing)];
  builder.add(Effect::antialiasing, "four samples of a pixel", [](Draft&) {}).samples = 4;
  builder.add(Effect::depth_of_field, smooth, "a lens", [](Draft& d) {
    d.camera().aperture = 0.3;
    d.camera().focus_distance = camera_distance;
  });
  builder.add(Effect::motion_blur, smooth, "the ball moves", [](Draft& d) {
    Animation animation;
    animation.name = "roll";
    Channel channel;
    channel.node = d.ball;
    channel.translation = {{0, 1}, {{-0.2, ball_radius, 0}, {0.2, ball_radius, 0}}};
    animation.channels.push_back(channel);
    d.scene.animations.push_back(animation);
    d.camera().shutter = {0, 0.9};
  });
}

}  // namespace

RenderSettings Rung::settings(int width, int height, Level level) const {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.level = level;
  settings.samples = samples;
  settings.threads = 1;
  if (has_instances) settings.flatten_up_to = 0;
  return settings;
}

std::vector<Rung> make_ladder(const std::filesystem::path& data_dir) {
  Builder builder(data_dir);
  add_light(builder);
  add_surfaces(builder);
  add_shapes(builder);
  add_camera(builder);
  return builder.finish();
}

}  // namespace sightline::bench
