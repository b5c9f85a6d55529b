#include "viz/structure.h"

#include "sightline/scene/camera.h"

namespace sightline::viz {
namespace {

constexpr std::size_t many_parts = 130;

}  // namespace

void wake_lazy_cells(const Tracer& tracer) {
  if (!tracer.is_lazy()) return;
  const std::vector<Ray<float>> rays = primary_rays(Camera::facing(tracer.mesh().bounds(), 160, 120));
  std::vector<Hit<float>> hits(rays.size());
  tracer.closest_hits(rays, hits);
}

void suit_filter(const Tracer& tracer, CellFilter& filter) {
  std::size_t parts = 0;
  tracer.for_each_cell([&](const Cell& cell) { parts += cell.depth == 1; });
  if (parts > many_parts) {
    filter.shallowest = 1;
    filter.slice = Slice{2, 0.5};
  }
}

Caption caption_of(const Tracer& tracer, const std::string& scene) {
  Caption caption{std::string(tracer.name()) + " on " + scene, {}};
  for (const AcceleratorInfo& info : accelerator_infos()) {
    if (info.name == tracer.name()) caption.subtitle = info.description;
  }
  return caption;
}

}  // namespace sightline::viz
