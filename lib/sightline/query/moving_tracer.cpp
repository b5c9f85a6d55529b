#include "sightline/query/moving_tracer.h"

#include <chrono>
#include <utility>

namespace sightline {
namespace {

template <class Work>
double seconds_of(Work&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

MovingTracer::MovingTracer(std::string accelerator, std::vector<std::shared_ptr<const Tracer>> meshes,
                           TracerSettings settings, MovePolicy policy)
    : accelerator_(std::move(accelerator)),
      meshes_(std::move(meshes)),
      settings_(std::move(settings)),
      policy_(policy) {}

const InstanceTracer& MovingTracer::move(std::shared_ptr<const Instances> instances) {
  if (refit(instances)) return *tracer_;
  const double seconds =
      seconds_of([&] { tracer_ = make_instance_tracer(accelerator_, std::move(instances), meshes_, settings_); });
  choice_.built(seconds);
  ++counts_.built;
  counts_.building_seconds += seconds;
  return *tracer_;
}

bool MovingTracer::refit(const std::shared_ptr<const Instances>& instances) {
  if (!tracer_ || policy_ == MovePolicy::rebuild) return false;
  if (policy_ == MovePolicy::cheaper && !choice_.prefers_refitting()) return false;
  bool is_done = false;
  const double seconds = seconds_of([&] { is_done = tracer_->refit(instances); });
  if (!is_done) return false;
  choice_.refitted(seconds);
  ++counts_.refitted;
  counts_.refitting_seconds += seconds;
  return true;
}

}  // namespace sightline
