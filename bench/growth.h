#pragma once
/// How building and asking grow with the number of triangles.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/power_fit.h"
#include "bench/report.h"
#include "sightline/io/progress.h"

namespace sightline::bench {

/// Of --growth-to, in triangles.
inline constexpr std::size_t least_growth_limit = 3'000, most_growth_limit = 10'000'000;

/// Whether scenes of this name can be had at all sizes.
bool is_growth_family(std::string_view name);

/// From 1000 triangles on, two sizes a decade, up to `limit`: as scenes, such as "soup:1000". A terrain has about as
/// many.
std::vector<std::string> growth_scenes(std::string_view family, std::size_t limit);

struct GrowthLine {
  std::string name;
  bool is_shared = false;  ///< Its structure is that of a line above: so is its build.
  /// By Workload: of seconds to build, or seconds a ray, against the number of triangles, over all sizes measured.
  std::array<std::optional<PowerFit>, workload_count> fit;
  std::size_t left_out_from = 0;  ///< Triangles from which on it was not built, because that takes too long; else 0.
};

/// What the scenes of a family say, in the order of the first. Each has the contenders of the one before it, or fewer.
std::vector<GrowthLine> growth_of(std::span<const SceneReport> scenes);

/// Verifies and measures the plan's family, one size after the other.
std::vector<SceneReport> run_growth(const Plan& plan, Progress& progress);

/// A table for each workload, sizes across, exponents at the end.
std::string growth_text(std::span<const SceneReport> scenes, const Plan& plan);

}  // namespace sightline::bench
