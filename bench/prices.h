#pragma once
/// What a choice costs that trades accuracy, or having all rays at hand, for speed.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/report.h"

namespace sightline::bench {

/// One structure asked in two ways that differ in one choice: watertight over fast, or single rays over a stream.
struct Price {
  std::string name, over;  ///< Of the contenders.
  /// By Workload: time per ray of `name` over that of `over`, the geometric mean over the scenes. Round n of every
  /// scene makes sample n of it, as in summary.h. Nothing where a scene has not both, nor for build.
  std::array<std::optional<Estimate>, workload_count> ratio;
};

/// First those of accuracy, then those of single rays, each in the order of the first scene's contenders.
std::vector<Price> prices_of(std::span<const SceneReport> scenes);

/// A line for each, between empty lines; empty where every structure is asked in one way.
std::string prices_text(std::span<const SceneReport> scenes, const Plan& plan);

}  // namespace sightline::bench
