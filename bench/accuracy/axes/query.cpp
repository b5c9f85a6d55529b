#include <algorithm>
#include <memory>

#include "bench/accuracy/axes/axes.h"
#include "bench/accuracy/error_sum.h"
#include "bench/accuracy/oracle.h"
#include "sightline/io/file_error.h"
#include "sightline/query/tracer.h"
#include "sightline/query/workloads.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

using Mesh = std::shared_ptr<const TriangleMesh>;
using Rays = std::vector<Ray<float>>;

/// Whether the line passes the box, made larger by `slack` on all sides: in double, and never false where it does.
bool may_pass(const Aabb& box, const Ray<double>& ray, double slack) {
  double lo = 0, hi = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double a = box.lo[axis] - slack - ray.origin[axis], b = box.hi[axis] + slack - ray.origin[axis];
    const double d = ray.direction[axis];
    if (d == 0 && (a > 0 || b < 0)) return false;
    if (d == 0) continue;
    lo = std::max(lo, std::min(a / d, b / d)), hi = std::min(hi, std::max(a / d, b / d));
  }
  return lo <= hi;
}

struct TrueHit {
  bool is_hit = false;
  True t;
};

double size_of(const TriangleMesh& mesh) { return max_norm(Vec3d(mesh.bounds().extent())); }

std::vector<TrueHit> truths_of(const TriangleMesh& mesh, const Rays& rays) {
  const double slack = size_of(mesh) / 4096;
  std::vector<TrueHit> truths(rays.size());
  std::vector<Aabb> boxes;
  for (std::uint32_t id = 0; id < mesh.size(); ++id) boxes.push_back(mesh.bounds(id));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Ray<double> ray = to_double(rays[i]);
    for (std::uint32_t id = 0; id < mesh.size(); ++id) {
      if (!may_pass(boxes[id], ray, slack)) continue;
      const auto crossing = true_crossing(mesh[id], ray);
      if (!crossing || !(crossing->t.high > 0)) continue;
      if (!truths[i].is_hit || crossing->t < truths[i].t) truths[i] = {true, crossing->t};
    }
  }
  return truths;
}

/// A hit is wrong where there is none, or it is missed, or what was hit is not what is nearest: its triangle is missed
/// by the ray, or crossed farther than float can tell from the nearest crossing.
template <class T>
bool is_right(const Hit<T>& hit, const TrueHit& truth, const TriangleMesh& mesh, const Ray<double>& ray) {
  if (hit.is_hit() != truth.is_hit) return false;
  if (!hit.is_hit()) return true;
  const auto crossing = true_crossing(mesh[hit.prim_id], ray);
  return crossing && crossing->t.high <= truth.t.high * (1 + 0x1p-22);
}

template <class T>
Choice choice_of(const std::string& name, const std::shared_ptr<const Tracer>& tracer, const Rays& floats,
                 const std::vector<TrueHit>& truths, Level level) {
  auto rays = std::make_shared<std::vector<Ray<T>>>();
  for (const Ray<float>& ray : floats) rays->push_back({Vec3<T>(ray.origin), Vec3<T>(ray.direction)});
  auto hits = std::make_shared<std::vector<Hit<T>>>(rays->size());
  const TriangleMesh& mesh = tracer->mesh();
  TraversalStats stats;
  tracer->closest_hits(std::span<const Ray<T>>(*rays), std::span(*hits), stats, level);
  ErrorSum sum;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const Ray<double> ray = to_double(floats[i]);
    const bool right = is_right((*hits)[i], truths[i], mesh, ray);
    sum.decide(right);
    if (right && truths[i].is_hit) {
      sum.add(truths[i].t.off(static_cast<double>((*hits)[i].t)) * glm::length(ray.direction) / size_of(mesh));
    }
  }
  const auto pass = [tracer, rays, hits, level] {
    tracer->closest_hits(std::span<const Ray<T>>(*rays), std::span(*hits), level);
    return static_cast<double>(hits->back().t);
  };
  const double per_ray = 1 / static_cast<double>(truths.size());
  return {name, sum.errors(), pass, {{"candidates/ray", per_ray * static_cast<double>(stats.candidates)}}};
}

Panel panel_of(const Effort& effort, const std::string& scene, const Mesh& mesh) {
  effort.say("exact hits of " + scene);
  Rays rays = edge_rays(*mesh, effort.count(4'000, 1'000), effort.seed);
  const Rays more = random_rays(mesh->bounds(), rays.size() / 2, effort.seed);
  rays.insert(rays.end(), more.begin(), more.end());
  const auto truths = truths_of(*mesh, rays);
  Panel panel{scene,
              scene + ", two thirds of the rays at edges and corners; wrong is another hit than exact numbers give",
              "ray",
              "of the hit point, as a share of the scene's size",
              ErrorKind::wrong,
              static_cast<double>(rays.size())};
  for (const AcceleratorInfo& info : accelerator_infos()) {
    if (info.name == "brute-force") continue;  // no choice for many triangles
    const std::shared_ptr<const Tracer> tracer = make_tracer(info.name, mesh);
    const std::string name(info.name);
    if (!tracer->is_lazy())
      panel.choices.push_back(choice_of<float>(name + " fast", tracer, rays, truths, Level::fast));
    panel.choices.push_back(choice_of<float>(name + " watertight", tracer, rays, truths, Level::watertight));
    panel.choices.push_back(choice_of<double>(name + " precise", tracer, rays, truths, Level::precise));
    panel.choices.push_back(choice_of<double>(name + " exact", tracer, rays, truths, Level::exact));
  }
  return panel;
}

std::vector<Panel> panels(const Effort& effort) {
  std::vector<Panel> all{panel_of(effort, "teapot", load_scene("teapot", effort.data_dir))};
  try {
    all.push_back(panel_of(effort, "dragon:4", load_scene("dragon:4", effort.data_dir)));
  } catch (const FileError&) {
    effort.say("without the dragon, which data/fetch gets");
  }
  return all;
}

}  // namespace

Axis query_axis() { return {"query", "at which level a ray is asked, on every structure", panels}; }

}  // namespace sightline::bench
