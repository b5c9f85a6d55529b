#include <memory>
#include <numbers>
#include <variant>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/error_sum.h"
#include "sightline/query/tracer.h"
#include "sightline/query/workloads.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

using Mesh = std::shared_ptr<const TriangleMesh>;

double volume_of(const Aabb& box) {
  const Vec3d extent = box.is_empty() ? Vec3d(0) : Vec3d(box.hi) - Vec3d(box.lo);
  return extent.x * extent.y * extent.z;
}
double volume_of(const Sphere& ball) { return 4 / 3.0 * std::numbers::pi * std::pow(double(ball.radius), 3); }
double volume_of(const Cylinder& cylinder) {
  return std::numbers::pi * double(cylinder.radius) * cylinder.radius * (2 * double(cylinder.half_length));
}
double volume_of(const Polyhedron&) { return 0; }

/// Of all leaves together.
double leaf_volume(const Tracer& tracer) {
  double all = 0;
  tracer.for_each_cell([&](const Cell& cell) {
    if (cell.is_leaf) all += std::visit([](const auto& region) { return volume_of(region); }, cell.region);
  });
  return all;
}

/// Leaves that a ray was led to although its line crosses none of their triangles.
std::size_t vain_leaves(const Tracer& tracer, const Ray<double>& ray) {
  WalkRecorder walk;
  tracer.record(ray, walk);
  const TriangleRay test = tracer.mesh().prepare(ray);
  std::size_t vain = 0;
  for (const auto& step : walk.steps) {
    if (step.event != WalkRecorder::Event::leaf) continue;
    bool is_crossed = false;
    for (const std::uint32_t id : tracer.leaf_order().subspan(step.range.first, step.range.count)) {
      Crossing crossing;
      is_crossed |= test.intersect(tracer.mesh()[id], crossing);
    }
    vain += !is_crossed;
  }
  return vain;
}

Panel panel_of(const Effort& effort, const std::string& scene, std::size_t count) {
  const Mesh mesh = load_scene(scene, effort.data_dir);
  auto rays = std::make_shared<const std::vector<Ray<float>>>(random_rays(mesh->bounds(), count, effort.seed));
  auto hits = std::make_shared<std::vector<Hit<float>>>(rays->size());
  Panel panel{scene,
              scene +
                  " in trees that differ in their volumes alone, leaves of at most 4; in vain: leaves that a ray is "
                  "led to although it crosses none of their triangles, per million rays",
              "ray",
              "",
              ErrorKind::wrong,
              static_cast<double>(rays->size()),
              {},
              "leaves in vain"};
  double boxes = 0;
  for (const std::string name : {"box-tree", "sphere-tree", "cylinder-tree"}) {
    const std::shared_ptr<const Tracer> tracer = make_tracer(name, mesh, {{{"max_leaf_size", "4"}}});
    std::size_t vain = 0;
    for (const Ray<float>& ray : *rays) vain += vain_leaves(*tracer, to_double(ray));
    TraversalStats stats;
    tracer->closest_hits(std::span(*rays), std::span(*hits), stats);
    const double per_ray = 1 / static_cast<double>(rays->size()), volume = leaf_volume(*tracer);
    if (boxes == 0) boxes = volume;
    Errors errors;
    errors.wrong_per_million = ErrorSum::million * per_ray * static_cast<double>(vain);
    panel.choices.push_back({name,
                             errors,
                             [tracer, rays, hits] {
                               tracer->closest_hits(std::span<const Ray<float>>(*rays), std::span(*hits));
                               return static_cast<double>(hits->back().t);
                             },
                             {{"leaves' volume over boxes'", volume / boxes},
                              {"nodes/ray", per_ray * static_cast<double>(stats.nodes)},
                              {"candidates/ray", per_ray * static_cast<double>(stats.candidates)}}});
  }
  return panel;
}

}  // namespace

Axis volume_axis() {
  return {"volume", "what a hierarchy's bounding volumes are", [](const Effort& effort) {
            return std::vector{panel_of(effort, "teapot", effort.count(10'000, 2'000)),
                               panel_of(effort, "sticks:2000", effort.count(1'000, 200))};
          }};
}

}  // namespace sightline::bench
