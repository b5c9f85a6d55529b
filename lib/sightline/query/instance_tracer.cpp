#include "sightline/query/instance_tracer.h"

#include <stdexcept>
#include <string>

#include "sightline/query/tracer_slices.h"

namespace sightline {

std::unique_ptr<InstanceTracer> make_instance_tracer(std::string_view accelerator,
                                                     std::shared_ptr<const Instances> instances,
                                                     std::vector<std::shared_ptr<const Tracer>> meshes,
                                                     const TracerSettings& settings) {
  if (meshes.size() != instances->meshes().size()) {
    throw std::invalid_argument("instances: expected tracers of " + std::to_string(instances->meshes().size()) +
                                " meshes, found " + std::to_string(meshes.size()));
  }
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (&meshes[i]->mesh() == instances->meshes()[i].get()) continue;
    throw std::invalid_argument("instances: expected a tracer of mesh " + std::to_string(i) + ", found one of another");
  }
  return detail::in_slices(accelerator, [&]<int Slice>() {
    return detail::make_instance_tracer_in_slice<Slice>(accelerator, instances, meshes, settings);
  });
}

}  // namespace sightline
