#pragma once
/// What a structure says of itself, whichever it is.

#include "sightline/query/stream.h"
#include "sightline/query/tracer.h"

namespace sightline::detail {

template <Accelerator A>
AcceleratorInfo accelerator_info_of() {
  AcceleratorInfo info{A::name, A::description, A::node_bytes, Steppable<A, float>, {}};
  const typename A::Options defaults;
  for (const auto& field : A::Options::fields()) {
    const std::string value = std::visit(
        [&]<class M>(M A::Options::*member) -> std::string {
          if constexpr (std::is_same_v<M, bool>) {
            return defaults.*member ? "true" : "false";
          } else if constexpr (std::is_same_v<M, Quality>) {
            return std::string(quality_names[static_cast<std::size_t>(defaults.*member)]);
          } else {
            return number_text(defaults.*member);
          }
        },
        field.member);
    info.options.push_back({field.name, value, allowed_text(field), field.help});
  }
  return info;
}

}  // namespace sightline::detail
