#include "viz/render_tool/source.h"

#include <ostream>
#include <sstream>
#include <stdexcept>

namespace sightline::render_tool {

std::unique_ptr<PictureSource> source_of(std::shared_ptr<const Scene>, const RenderSettings&) {
  throw std::runtime_error("this build has no renderer");
}

void print_plan(const PictureSource&, std::ostream& out) { out << "this build has no renderer\n"; }

std::string bill_of(const PictureSource&, const RenderCounters& counters, double seconds) {
  std::ostringstream text;
  text << "seconds " << seconds << "\ncamera rays " << counters.camera_rays << '\n';
  for (std::size_t i = 0; i < effect_count; ++i) text << effect_names[i] << ' ' << counters.counts[i] << '\n';
  text << "rays cut off " << counters.rays_cut_off << '\n';
  return text.str();
}

}  // namespace sightline::render_tool
