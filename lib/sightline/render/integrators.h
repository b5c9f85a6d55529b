#pragma once
/// The integrators that are compiled, each for a set of effects.

#include <span>
#include <string_view>

#include "sightline/render/picture_source.h"
#include "sightline/render/render_scene.h"
#include "sightline/render/stage_clock.h"

namespace sightline {

/// What integrators leave out where they do not know it. Other effects cost them a comparison, if that.
inline constexpr Effects compiled_effects{Effect::hard_shadow,
                                          Effect::soft_shadow,
                                          Effect::mirror,
                                          Effect::glossy,
                                          Effect::refraction,
                                          Effect::absorption,
                                          Effect::emission,
                                          Effect::procedural_texture,
                                          Effect::image_texture,
                                          Effect::normal_map,
                                          Effect::ambient,
                                          Effect::ambient_occlusion,
                                          Effect::environment,
                                          Effect::interreflection,
                                          Effect::fog,
                                          Effect::depth_of_field};

struct CompiledIntegrator {
  /// `times` may be null.
  using Run = void (*)(const RenderScene& scene, TileBuffer& tile, std::span<const std::uint32_t> pixels,
                       SampleRange range, FactsAsked facts, RenderCounters& counters, StageTimes* times);

  std::string_view name;
  Effects knows;  ///< Of compiled_effects.
  Run run;
};

/// By how much they know; the last one knows all.
std::span<const CompiledIntegrator> compiled_integrators();

/// The first, and so the smallest, that knows all of `needed`.
const CompiledIntegrator& integrator_for(Effects needed);

}  // namespace sightline
