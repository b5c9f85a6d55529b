#include <algorithm>
#include <memory>

#include "bench/accuracy/axes/axes.h"
#include "sightline/query/accelerator_spec.h"
#include "sightline/query/tracer.h"
#include "sightline/query/workloads.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

struct Way {
  const char* name;
  const char* spec;
};
constexpr Way ways[] = {
    {"bih, halves", "bih:quality=fast"},
    {"bih, 16 bins", "bih:quality=balanced"},
    {"bih, 64 bins", "bih:quality=best"},
    {"box-tree, widest axis", "box-tree:quality=fast"},
    {"box-tree, 8 bins", "box-tree:bins=8"},
    {"box-tree, 16 bins", "box-tree:bins=16"},
    {"box-tree, 32 bins", "box-tree:bins=32"},
    {"box-tree, 64 bins", "box-tree:bins=64"},
    {"box-tree, sweep", "box-tree:quality=best"},
    {"box-tree, splits", "box-tree:quality=best,splits=50"},
    {"wide-tree, widest axis", "wide-tree:quality=fast"},
    {"wide-tree, 8 bins", "wide-tree:bins=8"},
    {"wide-tree, 64 bins", "wide-tree:bins=64"},
    {"wide-tree, sweep", "wide-tree:quality=best"},
    {"wide-tree, splits", "wide-tree:quality=best,splits=50"},
    {"kd-tree, widest axis", "kd-tree:quality=fast"},
    {"kd-tree, sweep", "kd-tree:quality=balanced"},
    {"kd-tree, best", "kd-tree:quality=best"},
};

std::vector<Panel> panels(const Effort& effort) {
  const auto mesh = load_scene("teapot", effort.data_dir);
  const auto rays = std::make_shared<const std::vector<Ray<float>>>(
      random_rays(mesh->bounds(), effort.count(10'000, 2'000), effort.seed));
  const auto hits = std::make_shared<std::vector<Hit<float>>>(rays->size());
  const double count = static_cast<double>(rays->size()), triangles = mesh->size();
  Panel asking{"rays", "", "ray", "", ErrorKind::maximum, count}, building = asking;
  asking.description =
      "rays through the teapot; error: nodes, leaves and candidates a ray beyond the least, as a share";
  building.name = "building";
  building.description = "building by one thread, for the same errors";
  building.unit = "triangle", building.units = triangles;
  std::vector<double> steps;
  for (const Way& way : ways) {
    effort.say(way.name);
    AcceleratorSpec spec = parse_accelerators(way.spec).front();
    spec.settings.threads = 1;
    const std::shared_ptr<const Tracer> tracer = make_tracer(spec.accelerator, mesh, spec.settings);
    TraversalStats stats;
    tracer->closest_hits(std::span(*rays), std::span(*hits), stats);
    steps.push_back(static_cast<double>(stats.nodes + stats.leaves + stats.candidates) / count);
    const double bytes = static_cast<double>(tracer->structure_bytes() + tracer->leaf_bytes()) / triangles;
    asking.choices.push_back({way.name,
                              {},
                              [tracer, rays, hits] {
                                tracer->closest_hits(std::span<const Ray<float>>(*rays), std::span(*hits));
                                return static_cast<double>(hits->back().t);
                              },
                              {{"steps/ray", steps.back()}, {"bytes/triangle", bytes}}});
    building.choices.push_back({way.name,
                                {},
                                [mesh, spec] {
                                  const auto built = make_tracer(spec.accelerator, mesh, spec.settings);
                                  return static_cast<double>(built->structure_bytes());
                                },
                                {{"steps/ray", steps.back()}, {"bytes/triangle", bytes}}});
  }
  const double least = *std::ranges::min_element(steps);
  for (Panel* panel : {&asking, &building}) {
    for (std::size_t i = 0; i < steps.size(); ++i) panel->choices[i].errors.maximum = steps[i] / least - 1;
  }
  return {asking, building};
}

}  // namespace

Axis build_axis() { return {"build", "how carefully a structure is built", panels}; }

}  // namespace sightline::bench
