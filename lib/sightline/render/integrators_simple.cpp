#include "sightline/render/integrator_run.h"

namespace sightline::detail {

template void run_integrator<plain>(const RenderScene&, TileBuffer&, std::span<const std::uint32_t>, SampleRange,
                                    FactsAsked, RenderCounters&, StageTimes*);
template void run_integrator<patterned>(const RenderScene&, TileBuffer&, std::span<const std::uint32_t>, SampleRange,
                                        FactsAsked, RenderCounters&, StageTimes*);
template void run_integrator<textured>(const RenderScene&, TileBuffer&, std::span<const std::uint32_t>, SampleRange,
                                       FactsAsked, RenderCounters&, StageTimes*);
template void run_integrator<mirroring>(const RenderScene&, TileBuffer&, std::span<const std::uint32_t>, SampleRange,
                                        FactsAsked, RenderCounters&, StageTimes*);
template void run_integrator<soft>(const RenderScene&, TileBuffer&, std::span<const std::uint32_t>, SampleRange,
                                   FactsAsked, RenderCounters&, StageTimes*);

}  // namespace sightline::detail
