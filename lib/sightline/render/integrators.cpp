#include "sightline/render/integrators.h"

#include <algorithm>
#include <array>

#include "sightline/render/integrator_sets.h"

namespace sightline {
namespace {

using namespace detail;

template <Effects has>
constexpr CompiledIntegrator compiled(std::string_view name) {
  return {name, has, run_integrator<has>};
}

constexpr std::array<CompiledIntegrator, 11> integrators{compiled<plain>("plain"),
                                                         compiled<patterned>("patterned"),
                                                         compiled<textured>("textured"),
                                                         compiled<mirroring>("mirroring"),
                                                         compiled<soft>("soft"),
                                                         compiled<diffuse_paths>("diffuse paths"),
                                                         compiled<whitted>("Whitted"),
                                                         compiled<glossy>("glossy"),
                                                         compiled<open_air>("open air"),
                                                         compiled<distributed>("distributed"),
                                                         compiled<compiled_effects>("all effects")};
static_assert(std::is_sorted(integrators.begin(), integrators.end(),
                             [](const auto& a, const auto& b) { return a.knows.count() < b.knows.count(); }));

}  // namespace

std::span<const CompiledIntegrator> compiled_integrators() { return integrators; }

const CompiledIntegrator& integrator_for(Effects needed) {
  return *std::find_if(integrators.begin(), integrators.end(),
                       [&](const CompiledIntegrator& one) { return one.knows.has_all(needed & compiled_effects); });
}

}  // namespace sightline
