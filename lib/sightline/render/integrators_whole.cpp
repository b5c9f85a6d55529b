#include "sightline/render/integrator_run.h"

namespace sightline::detail {

template void run_integrator<distributed>(const RenderScene&, TileBuffer&, std::span<const std::uint32_t>, SampleRange,
                                          FactsAsked, RenderCounters&, StageTimes*);
template void run_integrator<compiled_effects>(const RenderScene&, TileBuffer&, std::span<const std::uint32_t>,
                                               SampleRange, FactsAsked, RenderCounters&, StageTimes*);

}  // namespace sightline::detail
