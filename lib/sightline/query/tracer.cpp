#include "sightline/query/tracer.h"

#include <stdexcept>

#include "sightline/accel/registry.h"
#include "sightline/query/accelerator_info_of.h"
#include "sightline/query/structure_plugin.h"
#include "sightline/query/tracer_slices.h"

namespace sightline {
namespace {

std::vector<AcceleratorInfo>& known_infos() {
  static std::vector<AcceleratorInfo> infos = [] {
    std::vector<AcceleratorInfo> list;
    Accelerators::for_each([&]<class A>(auto) { list.push_back(detail::accelerator_info_of<A>()); });
    return list;
  }();
  return infos;
}

}  // namespace

void detail::refuse_accelerator(std::string_view accelerator) {
  std::string known;
  for (const AcceleratorInfo& info : accelerator_infos()) known += (known.empty() ? "" : ", ") + std::string(info.name);
  throw std::invalid_argument("unknown accelerator '" + std::string(accelerator) + "'; expected one of " + known);
}

std::unique_ptr<Tracer> make_tracer(std::string_view accelerator, std::shared_ptr<const TriangleMesh> mesh,
                                    const TracerSettings& settings) {
  if (const StructurePlugin* plugin = detail::loaded_structure(accelerator))
    return plugin->make(std::move(mesh), settings);
  return detail::in_slices(
      accelerator, [&]<int Slice>() { return detail::make_tracer_in_slice<Slice>(accelerator, mesh, settings); });
}

std::span<const AcceleratorInfo> accelerator_infos() { return known_infos(); }

void detail::add_info(AcceleratorInfo info) { known_infos().push_back(std::move(info)); }

}  // namespace sightline
