#pragma once
/// Several scenes in one line a contender.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/report.h"

namespace sightline::bench {

struct SummaryLine {
  std::string name;
  bool is_shared = false;                    ///< Its structure is that of a line above: so are its bytes and its build.
  std::optional<double> bytes_per_triangle;  ///< Geometric mean over the scenes; nothing where one has no triangles.
  /// By Workload: the geometric mean over the scenes of the ratio to the reference peer. Round n of every scene makes
  /// sample n of the mean, and these have the median and interval shown. Nothing where some scene has no ratio.
  std::array<std::optional<Estimate>, workload_count> ratio;
};

/// A line for each contender that took part in all scenes, in the first one's order.
std::vector<SummaryLine> summary_of(std::span<const SceneReport> scenes);

/// The table of it; empty for fewer than two scenes.
std::string summary_text(std::span<const SceneReport> scenes, const Plan& plan);

}  // namespace sightline::bench
