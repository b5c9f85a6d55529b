#include "viz/render_tool/source.h"

#include <cstdio>
#include <ostream>
#include <string>

#include "sightline/render/bill.h"

namespace sightline::render_tool {

std::unique_ptr<PictureSource> source_of(std::shared_ptr<const Scene> scene, const RenderSettings& settings) {
  return std::make_unique<Renderer>(std::move(scene), settings);
}

void print_plan(const PictureSource& source, std::ostream& out) {
  const auto& renderer = dynamic_cast<const Renderer&>(source);
  out << plan_text(renderer, sample_bill(renderer));
}

std::string bill_of(const PictureSource& source, const RenderCounters& counters, double seconds) {
  const auto& renderer = dynamic_cast<const Renderer&>(source);
  char line[96];
  std::snprintf(line, sizeof line, "%.3g s, %llu samples; shares of time are those of a part of them\n", seconds,
                static_cast<unsigned long long>(counters.camera_rays));
  return line + plan_text(renderer, {counters, sample_bill(renderer).times, counters.camera_rays});
}

}  // namespace sightline::render_tool
