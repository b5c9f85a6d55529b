#include "sightline/render/trace_world.h"

#include <algorithm>
#include <array>
#include <utility>

#include "sightline/math/raw_array.h"

namespace sightline {
namespace {

/// Rays that are traced together, so that what is found of them stays near.
constexpr std::size_t batch = 64;

std::uint64_t sum_of(const TraversalStats& stats) { return stats.nodes + stats.leaves + stats.candidates; }

bool have_stood_still(const Instances& before, const Instances& now) {
  if (!before.have_moved_to(now)) return false;
  for (std::uint32_t i = 0; i < now.size(); ++i) {
    if (!(before.placements()[i].to_world() == now.placements()[i].to_world())) return false;
  }
  return true;
}

}  // namespace

TraceWorld::TraceWorld(const Scene& scene, const WorldSettings& settings, const SceneFilter& takes,
                       const TraceWorld* before)
    : level_(settings.level) {
  SceneInstances meshes = instances_of(scene, takes);
  SceneSolids solids = solids_of(scene, takes);
  instances_ = std::make_shared<const Instances>(std::move(meshes.instances));
  origins_ = std::move(meshes.origins);
  origins_.insert(origins_.end(), solids.origins.begin(), solids.origins.end());

  first_solid_ = instances_->size();
  for (const auto& solid : solids.solids) solid_list_.push_back(solid.get());

  TracerSettings of_meshes;
  of_meshes.options = settings.options;
  of_meshes.threads = settings.threads;
  if (instances_->size() > 0 && instances_->triangles() <= settings.flatten_up_to) {
    for (std::uint32_t i = 0, first = 0; i < instances_->size(); first += instances_->mesh_of(i++).size()) {
      firsts_.push_back(first);
    }
    if (before && before->flat_ && have_stood_still(*before->instances_, *instances_)) {
      flat_ = before->flat_;  // W3
    } else {
      flat_ =
          make_tracer(settings.accelerator, std::make_shared<const TriangleMesh>(instances_->flattened()), of_meshes);
    }
  } else if (instances_->size() > 0) {
    const auto known = before ? std::span(before->mesh_tracers_) : std::span<const std::shared_ptr<const Tracer>>();
    for (const auto& mesh : instances_->meshes()) {
      const auto same =
          std::find_if(known.begin(), known.end(), [&](const auto& tracer) { return &tracer->mesh() == mesh.get(); });
      mesh_tracers_.push_back(same != known.end() ? *same : make_tracer(settings.accelerator, mesh, of_meshes));  // W3
    }
    placed_ = make_instance_tracer(settings.accelerator, instances_, mesh_tracers_, of_meshes);
  }
  bounds_ = instances_->bounds();
  for (const auto& solid : solids.solids) bounds_.extend(solid->bounds());
  if (!solids.solids.empty()) {
    solids_ = make_solid_tracer(settings.solid_accelerator, std::move(solids.solids), settings.level);
  }
}

WorldHit TraceWorld::world_hit(const Hit<double>& hit) const {
  if (!hit.is_hit()) return {};
  const auto after = std::upper_bound(firsts_.begin(), firsts_.end(), hit.prim_id);
  const auto item = static_cast<std::uint32_t>(after - firsts_.begin() - 1);
  return {hit.t, item, hit.prim_id - firsts_[item], hit.u, hit.v};
}

WorldHit TraceWorld::solid_hit(const Hit<double>& hit) const {
  if (!hit.is_hit()) return {};
  return {hit.t, first_solid_ + hit.prim_id, static_cast<std::uint32_t>(hit.u), 0, hit.v};
}

void TraceWorld::find_meshes(std::span<const Ray<double>> rays, std::span<WorldHit> hits) const {
  if (flat_) {
    RawArray<Hit<double>, batch> found;
    flat_->closest_hits(rays, found.first(rays.size()));
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = world_hit(found[i]);
    return;
  }
  RawArray<InstanceHit<double>, batch> found;
  std::as_const(*placed_).closest_hits(rays, found.first(rays.size()));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = {found[i].t, found[i].instance, found[i].prim_id, found[i].u, found[i].v};
  }
}

/// `hits` are those of meshes: what solids have nearer takes their place.
void TraceWorld::find_nearer_solids(std::span<const Ray<double>> rays, std::span<WorldHit> hits) const {
  RawArray<Ray<double>, batch> shortened;
  RawArray<Hit<double>, batch> found;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    shortened.make(i, rays[i]);
    shortened[i].t_max = std::min(rays[i].t_max, hits[i].t);
  }
  solids_->closest_hits(shortened.first(rays.size()), found.first(rays.size()));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (found[i].t < hits[i].t) hits[i] = solid_hit(found[i]);  // W2
  }
}

void TraceWorld::closest_hits(std::span<const Ray<double>> rays, std::span<WorldHit> hits) const {
  for (std::size_t first = 0; first < rays.size(); first += batch) {
    const std::span<const Ray<double>> part = rays.subspan(first, std::min(batch, rays.size() - first));
    const std::span<WorldHit> into = hits.subspan(first, part.size());
    if (has_meshes()) {
      find_meshes(part, into);
      if (solids_) find_nearer_solids(part, into);
    } else if (solids_) {
      RawArray<Hit<double>, batch> found;
      solids_->closest_hits(part, found.first(part.size()));
      for (std::size_t i = 0; i < part.size(); ++i) into[i] = solid_hit(found[i]);
    } else {
      std::fill(into.begin(), into.end(), WorldHit{});
    }
  }
}

WorldHit TraceWorld::closest_hit(const Ray<double>& ray, std::uint64_t& work) const {
  WorldHit hit;
  TraversalStats stats;
  if (flat_) {
    Hit<double> found;
    flat_->closest_hits(std::span(&ray, 1), std::span(&found, 1), stats);
    hit = world_hit(found);
  } else if (placed_) {
    InstanceHit<double> found;
    placed_->closest_hits(std::span(&ray, 1), std::span(&found, 1), stats);
    hit = {found.t, found.instance, found.prim_id, found.u, found.v};
  }
  work += sum_of(stats);
  if (solids_) {
    Ray<double> shortened = ray;
    shortened.t_max = std::min(ray.t_max, hit.t);
    Hit<double> found;
    SolidWork solid_work;
    solids_->closest_hits(std::span<const Ray<double>>(&shortened, 1), std::span(&found, 1), solid_work);
    work += sum_of(solid_work.traversal) + solid_work.solids.nodes + solid_work.solids.primitives;
    if (found.t < hit.t) hit = solid_hit(found);  // W2
  }
  return hit;
}

void TraceWorld::any_hits(std::span<const Ray<double>> rays, std::span<std::uint8_t> is_hit) const {
  if (!has_meshes()) {
    if (solids_) return solids_->any_hits(rays, is_hit);
    std::fill(is_hit.begin(), is_hit.end(), std::uint8_t{0});
    return;
  }
  if (flat_) {
    flat_->any_hits(rays, is_hit);
  } else {
    placed_->any_hits(rays, is_hit);
  }
  if (!solids_) return;
  // Those that no triangle stops.
  std::array<Ray<double>, batch> open;
  std::array<std::size_t, batch> places;
  std::array<std::uint8_t, batch> stopped;
  std::size_t count = 0;
  const auto ask = [&] {
    solids_->any_hits(std::span<const Ray<double>>(open).first(count), std::span(stopped).first(count));
    for (std::size_t i = 0; i < count; ++i) is_hit[places[i]] = stopped[i];
    count = 0;
  };
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (is_hit[i]) continue;
    open[count] = rays[i];
    places[count++] = i;
    if (count == batch) ask();
  }
  if (count > 0) ask();
}

}  // namespace sightline
