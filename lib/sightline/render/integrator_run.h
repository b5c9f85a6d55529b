#pragma once

#include "sightline/render/integrator_of.h"
#include "sightline/render/integrator_sets.h"

namespace sightline::detail {

template <Effects has>
void run_integrator(const RenderScene& scene, TileBuffer& tile, std::span<const std::uint32_t> pixels,
                    SampleRange range, FactsAsked facts, RenderCounters& counters, StageTimes* times) {
  Integrator<has>(scene, counters, times).add_samples(tile, pixels, range, facts);
}

}  // namespace sightline::detail
