#pragma once

#include <array>
#include <cstdint>

#include "sightline/render/effect.h"

namespace sightline {

/// How often each effect was simulated: rays of those that trace rays, evaluations of the others. Of a picture all are
/// sums over its tiles, so they do not depend on how these are shared out.
struct RenderCounters {
  std::array<std::uint64_t, effect_count> counts{};
  std::uint64_t camera_rays = 0;
  std::uint64_t rays_cut_off = 0;        ///< Not traced, because they could add too little (Hall).
  std::uint64_t shadow_trials = 0;       ///< Rays to area lamps that told whether later ones are needed,
  std::uint64_t shadow_rays_spared = 0;  ///< and those that were not.

  std::uint64_t& operator[](Effect effect) { return counts[index_of(effect)]; }
  std::uint64_t operator[](Effect effect) const { return counts[index_of(effect)]; }

  RenderCounters& operator+=(const RenderCounters& others) {
    for (std::size_t i = 0; i < effect_count; ++i) counts[i] += others.counts[i];
    camera_rays += others.camera_rays;
    rays_cut_off += others.rays_cut_off;
    shadow_trials += others.shadow_trials;
    shadow_rays_spared += others.shadow_rays_spared;
    return *this;
  }
  friend bool operator==(const RenderCounters&, const RenderCounters&) = default;
};

}  // namespace sightline
