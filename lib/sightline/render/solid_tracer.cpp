#include "sightline/render/solid_tracer.h"

#include <utility>

#include "sightline/query/tracer_slices.h"

namespace sightline {
namespace detail {

/// Compiled in a file a level. Null where the registry has no such structure.
template <Level level>
std::unique_ptr<SolidTracer> make_solid_tracer_at(std::string_view accelerator,
                                                  std::vector<std::shared_ptr<const Solid>> solids,
                                                  const SolidTracerSettings& settings);

}  // namespace detail

std::unique_ptr<SolidTracer> make_solid_tracer(std::string_view accelerator,
                                               std::vector<std::shared_ptr<const Solid>> solids, Level level,
                                               const SolidTracerSettings& settings) {
  const auto make = [&] {
    switch (level) {
      case Level::fast:
        return detail::make_solid_tracer_at<Level::fast>(accelerator, std::move(solids), settings);
      case Level::watertight:
        return detail::make_solid_tracer_at<Level::watertight>(accelerator, std::move(solids), settings);
      case Level::precise:
        return detail::make_solid_tracer_at<Level::precise>(accelerator, std::move(solids), settings);
      case Level::exact:
        break;
    }
    return detail::make_solid_tracer_at<Level::exact>(accelerator, std::move(solids), settings);
  };
  auto tracer = make();
  if (!tracer) detail::refuse_accelerator(accelerator);
  return tracer;
}

}  // namespace sightline
