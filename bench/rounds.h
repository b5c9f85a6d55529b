#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/stage.h"
#include "sightline/io/progress.h"

namespace sightline::bench {

/// Google Benchmark's own flags, such as --benchmark_filter; see its manual.
/// \throws std::invalid_argument naming one that it does not know.
void set_google_flags(const std::vector<std::string>& flags);

/// Times everything on the stages with Google Benchmark and fills their reports in. Every round of a workload runs all
/// contenders once, one after the other, each round beginning with the next of them; so all see the same state of the
/// machine, and none always runs first.
/// Calls see(stage) when a stage is complete. Returns the number of times taken.
std::size_t run_rounds(std::vector<Stage>& stages, const Plan& plan, Progress& progress,
                       const std::function<void(const SceneReport&)>& see);

}  // namespace sightline::bench
