#include "sightline/query/tracer.h"

#include <stdexcept>

#include "sightline/accel/registry.h"
#include "sightline/query/stream.h"
#include "sightline/query/tracer_slices.h"

namespace sightline {
namespace {

template <class A>
AcceleratorInfo info_of() {
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
            return detail::number_text(defaults.*member);
          }
        },
        field.member);
    info.options.push_back({field.name, value, detail::allowed_text(field), field.help});
  }
  return info;
}

}  // namespace

void detail::refuse_accelerator(std::string_view accelerator) {
  std::string known;
  for (const AcceleratorInfo& info : accelerator_infos()) known += (known.empty() ? "" : ", ") + std::string(info.name);
  throw std::invalid_argument("unknown accelerator '" + std::string(accelerator) + "'; expected one of " + known);
}

std::unique_ptr<Tracer> make_tracer(std::string_view accelerator, std::shared_ptr<const TriangleMesh> mesh,
                                    const TracerSettings& settings) {
  return detail::in_slices(
      accelerator, [&]<int Slice>() { return detail::make_tracer_in_slice<Slice>(accelerator, mesh, settings); });
}

std::span<const AcceleratorInfo> accelerator_infos() {
  static const std::vector<AcceleratorInfo> infos = [] {
    std::vector<AcceleratorInfo> list;
    Accelerators::for_each([&]<class A>(auto) { list.push_back(info_of<A>()); });
    return list;
  }();
  return infos;
}

}  // namespace sightline
