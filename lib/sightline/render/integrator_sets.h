#pragma once
/// For which sets of effects integrators are compiled.

#include "sightline/render/integrators.h"

namespace sightline::detail {

inline constexpr Effects textures{Effect::procedural_texture, Effect::image_texture, Effect::normal_map};
inline constexpr Effects glows{Effect::emission, Effect::ambient};

inline constexpr Effects plain{Effect::hard_shadow};
inline constexpr Effects patterned{Effect::hard_shadow, Effect::procedural_texture};
inline constexpr Effects textured = plain | textures | glows;
inline constexpr Effects mirroring = textured | Effects{Effect::mirror};
inline constexpr Effects soft = textured | Effects{Effect::soft_shadow};
inline constexpr Effects whitted = mirroring | Effects{Effect::refraction, Effect::absorption};
inline constexpr Effects open_air = soft | Effects{Effect::ambient_occlusion, Effect::environment, Effect::fog};
inline constexpr Effects diffuse_paths = soft | Effects{Effect::interreflection};
inline constexpr Effects glossy = soft | Effects{Effect::mirror, Effect::glossy};
inline constexpr Effects distributed = whitted | glossy | open_air | Effects{Effect::depth_of_field};

/// Compiled in integrators_*.cpp.
template <Effects has>
void run_integrator(const RenderScene& scene, TileBuffer& tile, std::span<const std::uint32_t> pixels,
                    SampleRange range, FactsAsked facts, RenderCounters& counters, StageTimes* times);

}  // namespace sightline::detail
