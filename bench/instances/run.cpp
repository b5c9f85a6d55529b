#include "bench/instances/run.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "bench/instances/contender.h"
#include "bench/instances/field.h"
#include "bench/peers/embree_instances.h"
#include "bench/processor_time.h"
#include "bench/verify.h"
#include "sightline/query/instance_tracer.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

class Ours final : public InstanceContender {
 public:
  Ours(std::string name, std::unique_ptr<InstanceTracer> tracer, Level level)
      : name_(std::move(name)), tracer_(std::move(tracer)), level_(level) {}

  std::string name() const override { return name_; }
  bool is_peer() const override { return false; }
  std::size_t bytes() const override {
    return tracer_->structure_bytes() + tracer_->instances().size() * sizeof(Placement);
  }
  void closest_hits(std::span<const Ray<float>> rays, std::span<InstanceHit<float>> hits) const override {
    tracer_->closest_hits(rays, hits, level_);
  }

 private:
  std::string name_;
  std::unique_ptr<InstanceTracer> tracer_;
  Level level_;
};

/// Bytes of a line of Linux's /proc/self/status, which counts in units of 1024; 0 where there is none.
std::size_t status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(name + ":")) return 1024 * std::strtoull(line.c_str() + name.size() + 1, nullptr, 10);
  }
  return 0;
}

/// Gives back what the allocator keeps for later, so that what is resident is what is in use.
void trim_heap() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

/// From now on the peak is what is resident from now on.
void reset_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

/// What `resident` grew by.
std::size_t growth(std::size_t before, std::size_t after) { return after > before ? after - before : 0; }

class Run {
 public:
  Run(const InstancePlan& plan, Progress& progress) : plan_(plan), progress_(progress) {
    report_.machine = this_machine();
    report_.plan = plan;
    progress.say("loading " + plan.scene);
    mesh_ = load_scene(plan.scene, plan.data_dir);
    lower_ = make_tracer(plan.lower.accelerator, mesh_, plan.lower.settings);
    report_.mesh_triangles = mesh_->size();
    report_.mesh_bytes = mesh_->size() * sizeof(TriangleMesh::Corners) + mesh_->positions().size() * sizeof(Vec3f) +
                         lower_->structure_bytes() + lower_->leaf_bytes();
    trim_heap();
    const std::size_t before = status_bytes("VmRSS");
    progress.say("placing " + count_text(plan.count) + " instances");
    instances_ = field_of(mesh_, plan.count);
    trim_heap();
    placed_ = growth(before, status_bytes("VmRSS"));
    report_.placement_bytes = instances_->size() * sizeof(Placement);
    sets_ = instance_rays(*instances_, plan.rays);
    for (const InstanceRays& set : sets_) {
      report_.sets.emplace_back(set.name);
      report_.descriptions.emplace_back(set.description);
      report_.ray_counts.push_back(set.rays.size());
    }
  }

  InstanceReport run() {
    build();
    for (std::size_t s = 0; s < sets_.size(); ++s) verify(s);
    measure();
    progress_.clear();
    return std::move(report_);
  }

 private:
  void build() {
    for (const AcceleratorSpec& spec : plan_.uppers) {
      add(spec.label, [&] {
        return std::make_unique<Ours>(
            spec.label, make_instance_tracer(spec.accelerator, instances_, {lower_}, spec.settings), plan_.level);
      });
    }
    add("embree", [&] { return make_embree_instances(*instances_); });
  }

  template <class Make>
  void add(const std::string& name, Make&& make) {
    progress_.say("building", name);
    trim_heap();
    const std::size_t before = status_bytes("VmRSS");
    reset_peak();
    const auto begin = std::chrono::steady_clock::now();
    contenders_.push_back(make());
    InstanceRow row;
    row.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    row.peak = growth(before, status_bytes("VmHWM"));
    trim_heap();
    row.resident = growth(before, status_bytes("VmRSS"));
    row.name = name;
    row.is_peer = contenders_.back()->is_peer();
    row.bytes = contenders_.back()->bytes();
    if (!row.is_peer) row.peak += placed_, row.resident += placed_;
    row.times.resize(sets_.size());
    report_.rows.push_back(std::move(row));
  }

  /// All of ours on all rays, and on some of them all instances one by one.
  void verify(std::size_t s) {
    const std::vector<Ray<float>>& rays = sets_[s].rays;
    progress_.say("verifying", std::string(sets_[s].name));
    std::vector<InstanceHit<float>> expected = hits_of(0, rays), all(plan_.checked_rays);
    std::vector<Ray<float>> some;
    for (std::size_t i = 0; i < plan_.checked_rays; ++i) some.push_back(rays[i * rays.size() / plan_.checked_rays]);
    const auto brute = make_instance_tracer("brute-force", instances_, {lower_});
    brute->closest_hits(some, all, plan_.level);
    for (std::size_t i = 0; i < some.size(); ++i) {
      if (all[i] != expected[i * rays.size() / plan_.checked_rays]) refuse(0, s, some[i]);
    }
    for (std::size_t c = 1; c < contenders_.size(); ++c) {
      const auto hits = hits_of(c, rays);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i] == expected[i]) continue;
        if (!contenders_[c]->is_peer()) refuse(c, s, rays[i]);
        report_.rows[c].times[s].differing_hits +=
            hits[i].instance != expected[i].instance || hits[i].prim_id != expected[i].prim_id;
      }
    }
    report_.hit_counts.push_back(static_cast<std::size_t>(
        std::count_if(expected.begin(), expected.end(), [](const auto& hit) { return hit.is_hit(); })));
  }

  std::vector<InstanceHit<float>> hits_of(std::size_t c, const std::vector<Ray<float>>& rays) const {
    std::vector<InstanceHit<float>> hits(rays.size());
    contenders_[c]->closest_hits(rays, hits);
    if (contenders_[c]->name() == plan_.spoiled) hits[0].prim_id ^= 1;
    return hits;
  }

  [[noreturn]] void refuse(std::size_t c, std::size_t s, const Ray<float>& ray) const {
    const auto text = [](const Vec3f& v) {
      return '(' + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ')';
    };
    throw WrongHits(contenders_[c]->name() + " is wrong, so no times are shown: " + std::string(sets_[s].name) +
                    ", the ray from " + text(ray.origin) + " along " + text(ray.direction));
  }

  void measure() {
    const std::size_t count = contenders_.size(), rounds = static_cast<std::size_t>(plan_.rounds);
    for (std::size_t s = 0; s < sets_.size(); ++s) {
      std::vector<InstanceHit<float>> hits(sets_[s].rays.size());
      for (InstanceRow& row : report_.rows) row.times[s].round_seconds.assign(rounds, 0);
      for (std::size_t round = 0; round < rounds; ++round) {
        progress_.say("measuring", std::string(sets_[s].name) + ", round " + std::to_string(round + 1));
        for (std::size_t k = 0; k < count; ++k) {
          const std::size_t c = (k + round) % count;
          const double begin = processor_seconds();
          contenders_[c]->closest_hits(sets_[s].rays, hits);
          report_.rows[c].times[s].round_seconds[round] = processor_seconds() - begin;
        }
      }
      const std::vector<double>& embree = report_.rows.back().times[s].round_seconds;
      for (InstanceRow& row : report_.rows) {
        InstanceRow::Times& times = row.times[s];
        times.seconds = estimate(times.round_seconds);
        std::vector<double> ratios(rounds);
        for (std::size_t i = 0; i < rounds; ++i) ratios[i] = embree[i] / times.round_seconds[i];
        if (!row.is_peer) times.ratio = estimate(ratios);
      }
    }
  }

  const InstancePlan& plan_;
  Progress& progress_;
  InstanceReport report_;
  std::shared_ptr<const TriangleMesh> mesh_;
  std::shared_ptr<const Tracer> lower_;
  std::shared_ptr<const Instances> instances_;
  std::size_t placed_ = 0;
  std::vector<InstanceRays> sets_;
  std::vector<std::unique_ptr<InstanceContender>> contenders_;
};

}  // namespace

InstanceReport run_instances(const InstancePlan& plan, Progress& progress) { return Run(plan, progress).run(); }

}  // namespace sightline::bench
