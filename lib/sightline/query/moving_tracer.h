#pragma once
/// Two levels over instances that move from frame to frame.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sightline/query/instance_tracer.h"
#include "sightline/query/refit_choice.h"

namespace sightline {

enum class MovePolicy {
  cheaper,  ///< Refitted while that pays, by the seconds that were measured; see RefitChoice.
  refit,    ///< Refitted, where the structure can be.
  rebuild,
};

/// Hits are the same whatever the policy.
class MovingTracer {
 public:
  /// As make_instance_tracer.
  MovingTracer(std::string accelerator, std::vector<std::shared_ptr<const Tracer>> meshes, TracerSettings settings = {},
               MovePolicy policy = MovePolicy::cheaper);

  /// The next frame. Its instances are those of the frame before in other places, or any others: then all is built
  /// anew.
  const InstanceTracer& move(std::shared_ptr<const Instances> instances);

  /// How long tracing the frame took, for the policy `cheaper`.
  void traced(double seconds) { choice_.traced(seconds); }

  struct Counts {
    int built = 0, refitted = 0;
    double building_seconds = 0, refitting_seconds = 0;
  };
  const Counts& counts() const { return counts_; }

 private:
  bool refit(const std::shared_ptr<const Instances>& instances);

  std::string accelerator_;
  std::vector<std::shared_ptr<const Tracer>> meshes_;
  TracerSettings settings_;
  MovePolicy policy_;
  RefitChoice choice_;
  Counts counts_;
  std::unique_ptr<InstanceTracer> tracer_;
};

}  // namespace sightline
