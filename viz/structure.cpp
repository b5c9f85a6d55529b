#include "viz/structure.h"

#include <algorithm>

#include "sightline/scene/camera.h"

namespace sightline::viz {
namespace {

constexpr std::size_t many_flat_cells = 130;

}  // namespace

void wake_lazy_cells(const Tracer& tracer) {
  if (!tracer.is_lazy()) return;
  const std::vector<Ray<float>> rays = primary_rays(Camera::facing(tracer.mesh().bounds(), 160, 120));
  std::vector<Hit<float>> hits(rays.size());
  tracer.closest_hits(rays, hits);
}

void suit_filter(const Tracer& tracer, CellFilter& filter) {
  std::size_t cells = 0;
  int deepest = 0;
  tracer.for_each_cell([&](const Cell& cell) {
    ++cells;
    deepest = std::max(deepest, cell.depth);
  });
  if (deepest <= 1 && cells > many_flat_cells) {
    filter.shallowest = deepest;
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
