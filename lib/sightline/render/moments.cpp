#include "sightline/render/moments.h"

#include <algorithm>
#include <stdexcept>

#include "sightline/render/sky.h"
#include "sightline/scene/animation.h"
#include "sightline/texture/tangent_frame.h"

namespace sightline {
namespace {

Scene posed_at(const Scene& scene, double time) {
  Scene posed = scene;
  std::vector<NodePose> poses;
  for (const Animation& animation : scene.animations) AnimationController(animation).pose(time, poses);
  sightline::apply(poses, posed.graph);
  return posed;
}

bool has_same_pose(const SceneGraph& a, const SceneGraph& b) {
  for (NodeId node = 0; node < a.size(); ++node) {
    if (!(a.local(node).matrix() == b.local(node).matrix())) return false;
  }
  return true;
}

Lens lens_of(const Scene& posed, const RenderSettings& settings, const Aabb& bounds) {
  Lens lens;
  const SceneCamera* const given = camera_of(posed, settings);
  if (!given) {
    lens.camera =
        Camera::facing(bounds.is_empty() ? Aabb{Vec3f(-1), Vec3f(1)} : bounds, settings.width, settings.height);
    return lens;
  }
  const Transform world = posed.graph.world(given->node);
  const Vec3d eye = world.point(Vec3d(0));
  Vec3d forward = world.vector({0, 0, -1}), up = world.vector({0, 1, 0});
  if (!normalize_safely(forward)) forward = {0, 0, -1};
  if (!normalize_safely(up)) up = {0, 1, 0};
  lens.camera = Camera::looking_at(eye, eye + forward, up, given->field_of_view, settings.width, settings.height);
  lens.camera.forward = forward;  // without the roundings of eye + forward
  lens.radius = given->aperture / 2;
  lens.focus_distance = given->focus_distance;
  return lens;
}

bool has_light(const Scene& scene, const TraceWorld& world) {
  if (!lamps_of(scene).empty() || scene.ambient.color != Color(0)) return true;
  if (scene.surroundings.lights && !Sky(scene.surroundings).is_black()) return true;
  for (std::uint32_t i = 0; i < world.size(); ++i) {
    const std::uint32_t material = world.origin(i).material;
    if (material != no_item && scene.materials[material].emission != Color(0)) return true;
  }
  return false;
}

/// What one needs to see a scene that says nothing of light.
void light_up(Moment& moment) {
  const Camera& camera = moment.lens.camera;
  Lamp lamp;
  lamp.kind = Lamp::Kind::directional;
  lamp.axis = glm::normalize(0.6 * glm::normalize(camera.right) - 0.8 * glm::normalize(camera.up) +
                             0.9 * glm::normalize(camera.forward));
  lamp.strength = Color(2.4f);
  moment.lamps.push_back(lamp);
  moment.posed.ambient.color = Color(0.2f);
  if (Sky(moment.posed.surroundings).is_black()) {
    moment.posed.surroundings.background =
        SkyGradient{Color(0.42f, 0.52f, 0.66f), Color(0.72f, 0.77f, 0.82f), Color(0.35f, 0.36f, 0.38f)};
    moment.posed.surroundings.intensity = 1;
  }
}

bool is_transparent(const Scene& scene, std::uint32_t material) {
  return material != no_item && MaterialTable::of(scene.materials[material]).is_transparent;
}

/// Whether a part of the solid has a transparent material of its own.
bool has_transparent_part(const Scene& scene, const SolidTree& tree) {
  if (tree.kind != SolidTree::Kind::primitive) {
    return std::any_of(tree.args.begin(), tree.args.end(),
                       [&](const SolidTree& arg) { return has_transparent_part(scene, arg); });
  }
  return is_transparent(scene, material_named(scene, tree.material, no_item));
}

/// \param before the moment before, of which is taken what has not moved; may be null.
std::unique_ptr<Moment> moment_of(Scene posed, const RenderSettings& settings, const Moment* before) {
  auto moment = std::make_unique<Moment>();
  moment->posed = std::move(posed);
  const Scene& scene = moment->posed;
  WorldSettings of_world;
  if (!settings.accelerator.empty()) of_world.accelerator = of_world.solid_accelerator = settings.accelerator;
  of_world.options = settings.options;
  of_world.flatten_up_to = settings.flatten_up_to;
  of_world.level = settings.level;
  of_world.threads = settings.threads;
  moment->world = std::make_unique<TraceWorld>(scene, of_world, SceneFilter{}, before ? before->world.get() : nullptr);
  moment->surfaces = std::make_unique<Surfaces>(scene, *moment->world);
  moment->lens = lens_of(scene, settings, moment->world->bounds());
  moment->lamps = lamps_of(scene);
  if (!has_light(scene, *moment->world)) light_up(*moment);
  for (const Lamp& lamp : moment->lamps) moment->area_lamps += lamp.is_area();

  // R1
  const auto lets_light_through = [&](const SceneOrigin& origin) {
    const auto* solid = std::get_if<SolidTree>(&scene.geometries[scene.graph.geometry(origin.node)].shape);
    return is_transparent(scene, origin.material) || (solid && has_transparent_part(scene, *solid));
  };
  bool is_any = false;
  for (std::uint32_t i = 0; i < moment->world->size(); ++i)
    is_any = is_any || lets_light_through(moment->world->origin(i));
  if (is_any) {
    moment->clear =
        std::make_unique<TraceWorld>(scene, of_world, lets_light_through, before ? before->clear.get() : nullptr);
    moment->opaque = std::make_unique<TraceWorld>(
        scene, of_world, [&](const SceneOrigin& origin) { return !lets_light_through(origin); },
        before ? before->opaque.get() : nullptr);
    moment->clear_surfaces = std::make_unique<Surfaces>(scene, *moment->clear);
  }
  return moment;
}

}  // namespace

const SceneCamera* camera_of(const Scene& scene, const RenderSettings& settings) {
  if (settings.camera.empty()) return scene.cameras.empty() ? nullptr : &scene.cameras[0];
  std::string known;
  for (const SceneCamera& camera : scene.cameras) {
    if (camera.name == settings.camera) return &camera;
    known += (known.empty() ? "" : ", ") + camera.name;
  }
  throw std::invalid_argument("camera: expected " +
                              (known.empty() ? "none, since the scene has none" : "one of " + known) + ", found '" +
                              settings.camera + "'");
}

std::vector<std::unique_ptr<Moment>> moments_of(const Scene& scene, const RenderSettings& settings,
                                                std::uint32_t samples) {
  const SceneCamera* const camera = camera_of(scene, settings);
  const double open = settings.time + (camera ? camera->shutter[0] : 0);
  const double shut = settings.time + (camera ? camera->shutter[1] : 0);
  const std::uint32_t most = shut > open ? std::min(samples, most_moments) : 1;
  std::vector<Scene> poses;
  for (std::uint32_t i = 0; i < most; ++i) {
    poses.push_back(posed_at(scene, most == 1 ? open : open + (shut - open) * (i + 0.5) / most));
  }
  if (std::all_of(poses.begin(), poses.end(),
                  [&](const Scene& pose) { return has_same_pose(pose.graph, poses[0].graph); })) {
    poses.erase(poses.begin() + 1, poses.end());
  }
  std::vector<std::unique_ptr<Moment>> moments;
  for (Scene& pose : poses) {
    moments.push_back(moment_of(std::move(pose), settings, moments.empty() ? nullptr : moments.back().get()));
  }
  return moments;
}

}  // namespace sightline
