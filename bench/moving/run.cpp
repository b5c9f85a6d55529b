#include "bench/moving/run.h"

#include <chrono>

#include "bench/verify.h"
#include "sightline/query/moving_tracer.h"
#include "sightline/scene/camera.h"
#include "sightline/scene/flatten.h"
#include "sightline/scene/levels.h"

namespace sightline::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Frame = std::shared_ptr<const Instances>;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// One way to play the animation.
class Player {
 public:
  Player(const AcceleratorSpec& upper, const std::vector<std::shared_ptr<const Tracer>>& meshes, MovePolicy policy)
      : tracer_(upper.accelerator, meshes, upper.settings, policy) {}

  /// What the rays see in the frame. Building and refitting are told by counts().
  std::vector<InstanceHit<float>> show(const Frame& frame, const std::vector<Ray<float>>& rays) {
    const InstanceTracer& tracer = tracer_.move(frame);
    std::vector<InstanceHit<float>> hits(rays.size());
    const auto begin = Clock::now();
    tracer.closest_hits(rays, hits);
    trace_seconds_ = seconds_since(begin);
    tracer_.traced(trace_seconds_);
    total_ += trace_seconds_;
    return hits;
  }

  double trace_seconds() const { return trace_seconds_; }
  double total_seconds() const { return total_ + counts().building_seconds + counts().refitting_seconds; }
  const MovingTracer::Counts& counts() const { return tracer_.counts(); }

 private:
  MovingTracer tracer_;
  double trace_seconds_ = 0, total_ = 0;
};

class Run {
 public:
  Run(const MovingPlan& plan, Progress& progress) : plan_(plan), progress_(progress) {
    report_.machine = this_machine();
    report_.plan = plan;
    make_frames();
    for (const auto& mesh : frames_[0]->meshes()) meshes_.push_back(make_tracer(plan.lower, mesh));
    Aabb all;
    for (const Frame& frame : frames_) all.extend(frame->bounds());
    rays_ = primary_rays(Camera::facing(all, plan.width, plan.height));
  }

  MovingReport run() {
    for (const AcceleratorSpec& upper : plan_.uppers) report_.rows.push_back(play(upper));
    progress_.clear();
    return std::move(report_);
  }

 private:
  void make_frames() {
    Scene scene = make_levels(plan_.levels);
    std::vector<double> seconds;
    for (int i = 0; i < plan_.frames; ++i) {
      progress_.say("moving", "frame " + std::to_string(i + 1));
      const auto begin = Clock::now();
      turn_levels(scene, plan_.degrees * i / plan_.frames);
      frames_.push_back(std::make_shared<const Instances>(instances_of(scene).instances));
      seconds.push_back(seconds_since(begin));
    }
    report_.update_seconds = estimate(seconds).median;
    report_.instances = frames_[0]->size();
    report_.triangles = frames_[0]->triangles();
  }

  MovingRow play(const AcceleratorSpec& upper) {
    MovingRow row;
    row.name = upper.label;
    Player refitted(upper, meshes_, MovePolicy::refit), rebuilt(upper, meshes_, MovePolicy::rebuild),
        cheaper(upper, meshes_, MovePolicy::cheaper);
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      progress_.say("playing " + upper.label, "frame " + std::to_string(i + 1));
      const MovingTracer::Counts refits = refitted.counts(), builds = rebuilt.counts();
      const auto expected = rebuilt.show(frames_[i], rays_);
      auto hits = refitted.show(frames_[i], rays_);
      if (upper.label == plan_.spoiled) hits[0].prim_id ^= 1;
      if (hits != expected || cheaper.show(frames_[i], rays_) != expected) {
        throw WrongHits(upper.label + " is wrong, so no times are shown: frame " + std::to_string(i + 1) +
                        " is another picture refitted than built anew");
      }
      if (i == 0) continue;
      row.build_seconds.push_back(rebuilt.counts().building_seconds - builds.building_seconds);
      row.refit_seconds.push_back(refitted.counts().refitting_seconds - refits.refitting_seconds);
      row.built_trace_seconds.push_back(rebuilt.trace_seconds());
      row.refitted_trace_seconds.push_back(refitted.trace_seconds());
    }
    row.build = estimate(row.build_seconds);
    row.refit = estimate(row.refit_seconds);
    row.built_trace = estimate(row.built_trace_seconds);
    row.refitted_trace = estimate(row.refitted_trace_seconds);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < row.build_seconds.size(); ++i) {
      ratios.push_back(row.build_seconds[i] / row.refit_seconds[i]);
    }
    row.ratio = estimate(ratios);
    row.builds_when_cheaper = cheaper.counts().built;
    row.cheaper_seconds = cheaper.total_seconds();
    row.rebuild_seconds = rebuilt.total_seconds();
    return row;
  }

  const MovingPlan& plan_;
  Progress& progress_;
  MovingReport report_;
  std::vector<Frame> frames_;
  std::vector<std::shared_ptr<const Tracer>> meshes_;
  std::vector<Ray<float>> rays_;
};

}  // namespace

MovingReport run_moving(const MovingPlan& plan, Progress& progress) { return Run(plan, progress).run(); }

}  // namespace sightline::bench
