#pragma once
/// Makes a structure, any class that satisfies the contract, one that programs can load:
///     extern "C" const sightline::StructurePlugin sightline_structure = sightline::structure_plugin_of<MyTree>();

#include "sightline/query/accelerator_info_of.h"
#include "sightline/query/structure_plugin.h"
#include "sightline/query/tracer_of.h"

namespace sightline {

template <Accelerator A>
constexpr StructurePlugin structure_plugin_of() {
  return {plugin_build, detail::accelerator_info_of<A>,
          [](std::shared_ptr<const TriangleMesh> mesh, const TracerSettings& settings) {
            return detail::make_tracer_of<A>(std::move(mesh), settings);
          }};
}

}  // namespace sightline
