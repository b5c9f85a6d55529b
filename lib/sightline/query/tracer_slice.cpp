/// Compiled once a slice, with SIGHTLINE_SLICE set by the build: every slice_count-th structure of the registry.

#include "sightline/accel/registry.h"
#include "sightline/query/instance_tracer_of.h"
#include "sightline/query/tracer_of.h"
#include "sightline/query/tracer_slices.h"

namespace sightline::detail {
namespace {

/// Calls use<A>() for the structure of that name, if it is in this slice.
template <class Use>
void with_structure(std::string_view accelerator, Use&& use) {
  Accelerators::for_each([&]<class A>(auto index) {
    if constexpr (decltype(index)::value % slice_count == SIGHTLINE_SLICE) {
      if (A::name == accelerator) use.template operator()<A>();
    }
  });
}

}  // namespace

template <>
std::unique_ptr<Tracer> make_tracer_in_slice<SIGHTLINE_SLICE>(std::string_view accelerator,
                                                              const std::shared_ptr<const TriangleMesh>& mesh,
                                                              const TracerSettings& settings) {
  std::unique_ptr<Tracer> tracer;
  with_structure(accelerator, [&]<class A>() { tracer = make_tracer_of<A>(mesh, settings); });
  return tracer;
}

template <>
std::unique_ptr<InstanceTracer> make_instance_tracer_in_slice<SIGHTLINE_SLICE>(
    std::string_view accelerator, const std::shared_ptr<const Instances>& instances,
    const std::vector<std::shared_ptr<const Tracer>>& meshes, const TracerSettings& settings) {
  std::unique_ptr<InstanceTracer> tracer;
  with_structure(accelerator, [&]<class A>() { tracer = make_instance_tracer_of<A>(instances, meshes, settings); });
  return tracer;
}

}  // namespace sightline::detail
