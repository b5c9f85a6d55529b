#pragma once

#include <array>

#include "sightline/render/render_counters.h"

namespace sightline {

/// Effects whose counters are of rays; the others' are of evaluations.
inline constexpr std::array traced_effects{Effect::hard_shadow, Effect::soft_shadow,    Effect::mirror,
                                           Effect::glossy,      Effect::refraction,     Effect::ambient_occlusion,
                                           Effect::environment, Effect::interreflection};

/// All that were traced, the camera's among them.
inline std::uint64_t rays_of(const RenderCounters& counters) {
  std::uint64_t rays = counters.camera_rays;
  for (const Effect effect : traced_effects) rays += counters[effect];
  return rays;
}

}  // namespace sightline
