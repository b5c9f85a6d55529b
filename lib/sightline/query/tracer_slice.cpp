/// Compiled once a slice, with SIGHTLINE_SLICE set by the build: every slice_count-th structure of the registry.

#include "sightline/accel/registry.h"
#include "sightline/query/tracer_of.h"

namespace sightline::detail {

template <>
std::unique_ptr<Tracer> make_tracer_in_slice<SIGHTLINE_SLICE>(std::string_view accelerator,
                                                              std::shared_ptr<const TriangleMesh> mesh,
                                                              const TracerSettings& settings) {
  std::unique_ptr<Tracer> tracer;
  Accelerators::for_each([&]<class A>(auto index) {
    if constexpr (decltype(index)::value % slice_count == SIGHTLINE_SLICE) {
      if (A::name == accelerator) tracer = make_tracer_of<A>(mesh, settings);
    }
  });
  return tracer;
}

}  // namespace sightline::detail
