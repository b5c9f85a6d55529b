#include "tests/hard_cases/leaks/leak_hunt.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cstdio>
#include <ctime>
#include <mutex>
#include <numeric>
#include <stdexcept>

#include "tests/hard_cases/leaks/closed_seeds.h"
#include "tests/hard_cases/leaks/leak_mesh.h"
#include "tests/hard_cases/leaks/packet_tracer.h"

namespace sightline::hard {
namespace {

/// Of this thread alone, whatever else the machine does.
double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9;
}

constexpr std::uint64_t batch_groups = 64;
constexpr std::uint64_t batch_rays = batch_groups * LeakMesh::group_size;
constexpr std::uint32_t most_for_brute_force = 400;

/// Powers of two where rays are to go through vertices exactly.
const std::vector<Placement>& placements() {
  static const std::vector<Placement> all{{"at 1", 1, Vec3d(0), 0},
                                          {"on a lattice", 1, Vec3d(0), 0x1p-9},
                                          {"on a lattice of 2^-22", 0x1p-13, Vec3d(0), 0x1p-9},
                                          {"at 1e-4", 1e-4, Vec3d(0), 0},
                                          {"at 1e7", 1e7, Vec3d(0), 0},
                                          {"far away", 16, Vec3d(148376, 1234, -223423), 0}};
  return all;
}

std::vector<LeakMesh> leak_meshes(const std::filesystem::path& data_dir, Progress& progress) {
  std::vector<LeakMesh> meshes;
  for (const NamedSeed& seed : closed_seeds(data_dir)) {
    for (const Placement& placement : placements()) {
      progress.say("making meshes", seed.name + " " + placement.name);
      meshes.emplace_back(seed.name + " " + placement.name, seed.mesh, placement);
    }
  }
  return meshes;
}

/// Of the rays of a mesh on a lattice, whose every decision takes expansions, and of any other.
std::uint64_t share_of(const LeakMesh& mesh) { return mesh.is_on_lattice() ? 1 : 5; }

/// Numbers of ways, each as often as its share says.
std::vector<std::size_t> schedule() {
  std::vector<std::size_t> order;
  for (int round = 0; round < 18; ++round) {
    for (std::size_t i = 0; i < leak_ways.size(); ++i) {
      if (round < leak_ways[i].share) order.push_back(i);
    }
  }
  return order;
}

struct Structure {
  std::unique_ptr<Tracer> tracer;
  std::unique_ptr<PacketTracer> packets;  ///< Or null.
};

/// Of one thread.
template <class T>
struct Batch {
  std::vector<Ray<T>> rays = std::vector<Ray<T>>(batch_rays);
  std::vector<Hit<T>> hits = std::vector<Hit<T>>(batch_rays);
  std::vector<std::uint8_t> is_hit = std::vector<std::uint8_t>(batch_rays);
};

template <class T>
void ask(const Structure& structure, const LeakWay& way, Level level, std::span<const Ray<T>> rays,
         std::span<Hit<T>> hits, std::span<std::uint8_t> is_hit) {
  const bool packs = way.how == LeakWay::How::packet && structure.packets;
  if (!way.is_any) {
    if (packs)
      structure.packets->closest_hits(rays, hits, level);
    else if (way.how == LeakWay::How::stream)
      structure.tracer->stream_closest_hits(rays, hits, level);
    else
      structure.tracer->closest_hits(rays, hits, level);
    for (std::size_t i = 0; i < rays.size(); ++i) is_hit[i] = hits[i].is_hit() && hits[i].t <= rays[i].t_max;
  } else if (packs) {
    structure.packets->any_hits(rays, is_hit, level);
  } else if (way.how == LeakWay::How::stream) {
    structure.tracer->stream_any_hits(rays, is_hit, level);
  } else {
    structure.tracer->any_hits(rays, is_hit, level);
  }
}

/// All numbers as hexadecimal floats, so that they are read back as they are.
template <class T>
std::string text_of(const Ray<T>& ray) {
  char text[256];
  const Ray<double> r = to_double(ray);
  std::snprintf(text, sizeof text, "from %a %a %a towards %a %a %a up to %a", r.origin.x, r.origin.y, r.origin.z,
                r.direction.x, r.direction.y, r.direction.z, r.t_max);
  return text;
}

/// A structure over a mesh, and what of it is counted.
class MeshHunt {
 public:
  MeshHunt(const LeakPlan& plan, const LeakMesh& mesh, const Structure& structure, LeakRow& row)
      : plan_(plan), mesh_(mesh), structure_(structure), row_(row) {}

  template <class T>
  void run_batch(std::uint64_t number, std::uint64_t count, const LeakWay& way, LeakRow::Count& counted) {
    thread_local Batch<T> batch;
    const double start = processor_seconds();
    const std::uint64_t first_group = number * batch_groups;
    for (std::uint64_t i = 0; i < count; i += LeakMesh::group_size) {
      mesh_.rays(plan_.seed, first_group + i / LeakMesh::group_size, batch.rays.data() + i);
    }
    const auto size = static_cast<std::size_t>(count);
    ask<T>(structure_, way, plan_.level, std::span(batch.rays).first(size), std::span(batch.hits).first(size),
           std::span(batch.is_hit).first(size));
    std::uint64_t leaks = 0;
    for (std::size_t i = 0; i < size; ++i) {
      if (batch.is_hit[i] != 0) continue;
      ++leaks;
      tell(number * batch_rays + i, way, text_of(batch.rays[i]));
    }
    const std::lock_guard lock(mutex_);
    counted.rays += count;
    counted.leaks += leaks;
    row_.seconds += processor_seconds() - start;
  }

 private:
  /// Of all leaks of the mesh the first one, whichever thread comes upon it first.
  void tell(std::uint64_t ray, const LeakWay& way, const std::string& text) {
    const std::lock_guard lock(mutex_);
    if (has_earlier_mesh_ || ray >= first_) return;
    first_ = ray;
    row_.first_leak = row_.structure + ", " + std::string(way.name) + ", " + std::string(info_of(plan_.level).name) +
                      ": mesh " + mesh_.name() + ", seed " + std::to_string(plan_.seed) + ", ray " +
                      std::to_string(ray) + ": " + text;
  }

  const LeakPlan& plan_;
  const LeakMesh& mesh_;
  const Structure& structure_;
  LeakRow& row_;
  std::mutex mutex_;
  const bool has_earlier_mesh_ = !row_.first_leak.empty();
  std::uint64_t first_ = ~std::uint64_t{0};
};

class Hunt {
 public:
  Hunt(const LeakPlan& plan, Progress& progress) : plan_(plan), progress_(progress) {}

  void run(const AcceleratorSpec& spec, const std::vector<const LeakMesh*>& meshes, std::uint64_t rays, LeakRow& row) {
    std::uint64_t all = 0, before = 0;
    for (const LeakMesh* mesh : meshes) all += share_of(*mesh);
    for (const LeakMesh* mesh : meshes) {
      const std::uint64_t until = before + share_of(*mesh);
      run(spec, *mesh, rays * until / all - rays * before / all, row);
      before = until;
    }
  }

 private:
  void run(const AcceleratorSpec& spec, const LeakMesh& mesh, std::uint64_t rays, LeakRow& row) {
    tell(spec.label + " over " + mesh.name());
    const Structure structure{make_tracer(spec.accelerator, mesh.mesh(), spec.settings),
                              make_packet_tracer(spec.accelerator, mesh.mesh(), spec.settings)};
    MeshHunt hunt(plan_, mesh, structure, row);
    const std::uint64_t first_way = next_way_, batches = (rays + batch_rays - 1) / batch_rays;
    next_way_ += batches;
    tbb::parallel_for(std::uint64_t{0}, batches, [&](std::uint64_t number) {
      const std::uint64_t count = std::min(batch_rays, rays - number * batch_rays);
      const std::size_t at = schedule_[(first_way + number) % schedule_.size()];
      const LeakWay& way = leak_ways[at];
      way.is_double ? hunt.run_batch<double>(number, count, way, row.ways[at])
                    : hunt.run_batch<float>(number, count, way, row.ways[at]);
      done_ += count;
      if (number % 64 == 63) tell(spec.label + " over " + mesh.name());
    });
  }

  void tell(const std::string& what) {
    progress_.say("hunting leaks", what, static_cast<double>(done_) / static_cast<double>(plan_.rays));
  }

  const LeakPlan& plan_;
  Progress& progress_;
  const std::vector<std::size_t> schedule_ = schedule();
  std::uint64_t next_way_ = 0;
  std::atomic<std::uint64_t> done_{0};
};

void check(const LeakPlan& plan) {
  if (plan.rays == 0) throw std::invalid_argument("leaks: expected at least 1 ray, found 0");
  if (plan.level != Level::fast && plan.level != Level::watertight) {
    throw std::invalid_argument("leaks: expected the level fast or watertight, which are those of triangles, found " +
                                std::string(info_of(plan.level).name));
  }
  for (const AcceleratorSpec& spec : plan.structures) check_accelerator(spec);
}

}  // namespace

std::uint64_t LeakRow::rays() const {
  return std::accumulate(ways.begin(), ways.end(), std::uint64_t{0},
                         [](auto sum, const Count& c) { return sum + c.rays; });
}
std::uint64_t LeakRow::leaks() const {
  return std::accumulate(ways.begin(), ways.end(), std::uint64_t{0},
                         [](auto sum, const Count& c) { return sum + c.leaks; });
}
std::uint64_t LeakReport::rays() const {
  return std::accumulate(rows.begin(), rows.end(), std::uint64_t{0},
                         [](auto sum, const LeakRow& r) { return sum + r.rays(); });
}
std::uint64_t LeakReport::leaks() const {
  return std::accumulate(rows.begin(), rows.end(), std::uint64_t{0},
                         [](auto sum, const LeakRow& r) { return sum + r.leaks(); });
}

LeakReport hunt_leaks(const LeakPlan& plan, Progress& progress) {
  check(plan);
  std::vector<AcceleratorSpec> structures = plan.structures;
  if (structures.empty()) {
    for (const AcceleratorInfo& info : accelerator_infos()) {
      structures.push_back({std::string(info.name), std::string(info.name), {}});
    }
  }
  LeakReport report{plan.seed, plan.level, {}, 0, plan.threads, {}};
  const std::vector<LeakMesh> meshes = leak_meshes(plan.data_dir, progress);
  for (const LeakMesh& mesh : meshes) {
    report.meshes.push_back(mesh.name());
    report.triangles += mesh.mesh()->size();
  }
  tbb::task_arena arena(plan.threads > 0 ? plan.threads : tbb::task_arena::automatic);
  report.threads = arena.max_concurrency();
  Hunt hunt(plan, progress);
  for (std::size_t i = 0; i < structures.size(); ++i) {
    const AcceleratorSpec& spec = structures[i];
    std::vector<const LeakMesh*> fit;
    for (const LeakMesh& mesh : meshes) {
      if (spec.accelerator != "brute-force" || mesh.mesh()->size() <= most_for_brute_force) fit.push_back(&mesh);
    }
    LeakRow& row = report.rows.emplace_back();
    row.structure = spec.label;
    const std::uint64_t rays = plan.rays * (i + 1) / structures.size() - plan.rays * i / structures.size();
    arena.execute([&] { hunt.run(spec, fit, rays, row); });
  }
  progress.clear();
  return report;
}

}  // namespace sightline::hard
