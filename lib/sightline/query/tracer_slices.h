#pragma once
/// The registry is cut into slices, each compiled on its own (tracer_slice.cpp).

#include <memory>
#include <string_view>
#include <vector>

#include "sightline/query/instance_tracer.h"
#include "sightline/query/tracer.h"

namespace sightline::detail {

inline constexpr int slice_count = 4;

/// Null when the name is not in the slice.
template <int Slice>
std::unique_ptr<Tracer> make_tracer_in_slice(std::string_view accelerator,
                                             const std::shared_ptr<const TriangleMesh>& mesh,
                                             const TracerSettings& settings);
template <int Slice>
std::unique_ptr<InstanceTracer> make_instance_tracer_in_slice(std::string_view accelerator,
                                                              const std::shared_ptr<const Instances>& instances,
                                                              const std::vector<std::shared_ptr<const Tracer>>& meshes,
                                                              const TracerSettings& settings);

/// \throws std::invalid_argument, which lists what is known.
[[noreturn]] void refuse_accelerator(std::string_view accelerator);

/// What make<Slice>() makes in the first slice in which that is not null.
template <int Slice = 0, class Make>
auto in_slices(std::string_view accelerator, const Make& make) -> decltype(make.template operator()<Slice>()) {
  if constexpr (Slice < slice_count) {
    if (auto made = make.template operator()<Slice>()) return made;
    return in_slices<Slice + 1>(accelerator, make);
  } else {
    refuse_accelerator(accelerator);
  }
}

}  // namespace sightline::detail
