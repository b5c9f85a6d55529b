#include "sightline/render/renderer.h"

#include <stdexcept>

#include "sightline/render/moments.h"

namespace sightline {
namespace {

/// Rays to an area light at each surface, where its pixel has too few samples to show its shadow evenly.
constexpr std::uint32_t few_samples = 16;

void require(bool is_fine, const char* what, const char* expected) {
  if (!is_fine) throw std::invalid_argument(std::string(what) + ": expected " + expected);
}

/// Materials that something in a moment's world is made of.
std::vector<std::uint8_t> used_materials(const Moment& moment) {
  std::vector<std::uint8_t> is_used(moment.posed.materials.size());
  const auto use = [&](std::uint32_t material) {
    if (material != no_item) is_used[material] = 1;
  };
  const TraceWorld& world = *moment.world;
  for (std::uint32_t i = 0; i < world.size(); ++i) {
    if (!world.is_solid(i)) {
      use(world.origin(i).material);
      continue;
    }
    const Solid& solid = world.solid(i);
    for (const std::uint32_t primitive : primitives_in(solid)) {
      use(moment.surfaces->material(i, solid.primitives()[primitive].material));
    }
  }
  return is_used;
}

}  // namespace

Renderer::Renderer(std::shared_ptr<const Scene> scene, const RenderSettings& settings) : settings_(settings) {
  require(settings.width > 0 && settings.height > 0 && settings.width <= 1 << 16 && settings.height <= 1 << 16, "size",
          "1x1 to 65536x65536");
  require(settings.error_bound >= 0, "error bound", "a number of at least 0");
  require(settings.depth.value_or(0) >= 0, "depth", "at least 0");
  require(settings.cut_off.value_or(0) >= 0, "cut-off", "a number of at least 0");
  require(settings.shadow_error.value_or(0) >= 0, "shadow error", "a number of at least 0");
  const RenderHints& hints = scene->render;
  if (settings_.samples == 0) settings_.samples = hints.samples;
  if (settings_.light_samples == 0) {
    settings_.light_samples = std::max(1u, few_samples / std::min(few_samples, settings_.samples));
  }
  std::vector<std::unique_ptr<Moment>> moments = moments_of(*scene, settings_, settings_.samples);
  const Moment& first = *moments[0];
  ready_.materials = std::make_unique<const MaterialTable>(first.posed, used_materials(first));
  auto sky = std::make_unique<Sky>(first.posed.surroundings);
  ready_.ambient = first.posed.ambient;
  ready_.fog = first.posed.fog;
  ready_.depth = settings.depth ? static_cast<std::uint32_t>(*settings.depth) : hints.depth;
  ready_.cut_off = settings.cut_off.value_or(hints.cut_off);
  ready_.light_samples = settings_.light_samples;
  const double shadow_error = settings.shadow_error.value_or(hints.shadow_error);
  ready_.shadow_error2 = shadow_error * shadow_error * settings_.samples;
  ready_.seed = settings.seed;
  ready_.has_sky = !sky->is_black();
  ready_.sky_lights = first.posed.surroundings.lights;
  ready_.has_footprints = settings.filters_textures;

  plan_.analysis = analyze(first, *ready_.materials, *sky, moments.size() > 1, settings_.samples);
  ready_.effects = plan_.analysis.effects;
  if (ready_.effects.has(Effect::environment)) sky->distribute();
  ready_.sky = std::move(sky);
  integrator_ = &(settings.knows_all ? compiled_integrators().back() : integrator_for(ready_.effects));
  plan_.integrator = integrator_->name;
  plan_.unused = integrator_->knows;
  plan_.shadows = ready_.effects & Effects{Effect::meshes, Effect::instances, Effect::solids, Effect::refraction};
  for (std::size_t i = 0; i < effect_count; ++i) {
    if (ready_.effects.has(static_cast<Effect>(i))) plan_.unused.remove(static_cast<Effect>(i));
  }
  for (auto& moment : moments) ready_.moments.push_back(std::move(moment));
  fingerprint_ = fingerprint_of(ready_, settings_);
}

}  // namespace sightline
