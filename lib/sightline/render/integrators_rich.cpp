#include "sightline/render/integrator_run.h"

namespace sightline::detail {

template void run_integrator<whitted>(const RenderScene&, TileBuffer&, std::span<const std::uint32_t>, SampleRange,
                                      FactsAsked, RenderCounters&, StageTimes*);
template void run_integrator<open_air>(const RenderScene&, TileBuffer&, std::span<const std::uint32_t>, SampleRange,
                                       FactsAsked, RenderCounters&, StageTimes*);
template void run_integrator<diffuse_paths>(const RenderScene&, TileBuffer&, std::span<const std::uint32_t>,
                                            SampleRange, FactsAsked, RenderCounters&, StageTimes*);
template void run_integrator<glossy>(const RenderScene&, TileBuffer&, std::span<const std::uint32_t>, SampleRange,
                                     FactsAsked, RenderCounters&, StageTimes*);

}  // namespace sightline::detail
