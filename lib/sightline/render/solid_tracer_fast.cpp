#include "sightline/render/solid_tracer_of.h"

namespace sightline::detail {

template std::unique_ptr<SolidTracer> make_solid_tracer_at<Level::fast>(std::string_view,
                                                                        std::vector<std::shared_ptr<const Solid>>,
                                                                        const SolidTracerSettings&);

}  // namespace sightline::detail
