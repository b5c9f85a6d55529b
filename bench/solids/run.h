#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/estimate.h"
#include "bench/machine.h"
#include "bench/power_fit.h"
#include "bench/solids/painter.h"
#include "bench/solids/plan.h"
#include "sightline/io/progress.h"

namespace sightline::bench {

inline constexpr std::string_view povray_name = "POV-Ray";

/// A line of a scene's table.
struct SolidRow {
  std::string name;
  std::optional<PaintStats> stats;  ///< Counted outside the timing; not of POV-Ray.
  /// One picture in each round, of the processor and on the wall; NaN where it did not take part.
  std::vector<double> round_seconds, round_elapsed;
  std::optional<Estimate> seconds, elapsed;
  /// POV-Ray's times over this one's, in the same round.
  std::optional<Estimate> ratio, elapsed_ratio;
};

/// How far two pictures are apart.
struct Difference {
  std::size_t coverage = 0;  ///< Pixels in which only one has a hit.
  std::size_t shade = 0;     ///< Pixels in which both have one and differ by more than shade_limit.
};
inline constexpr double shade_limit = 1.0 / 256;

struct SolidSceneReport {
  std::string name, description;
  std::size_t solids = 0, pixels = 0;
  double hit_share = 0;
  std::string accelerator;
  std::optional<Difference> from_povray;
  std::vector<SolidRow> rows;
};

struct SolidReport {
  Machine machine;
  SolidPlan plan;
  std::string povray_version;  ///< Empty without it.
  std::vector<SolidSceneReport> scenes;
};

/// Verifies, then measures. Calls see(scene) when one is complete.
/// \throws WrongHits where levels disagree with the reference, with each other, or with POV-Ray.
SolidReport run_solids(const SolidPlan& plan, Progress& progress,
                       const std::function<void(const SolidReport&, const SolidSceneReport&)>& see);

struct SolidGrowth {
  std::string name;
  PowerFit fit;  ///< Of seconds a picture against the number of spheres.
};
std::vector<SolidGrowth> growth_of(const SolidReport& report);

std::string head_text(const SolidReport& report);
std::string table_text(const SolidReport& report, const SolidSceneReport& scene);
std::string growth_text(const SolidReport& report);
std::string json_text(const SolidReport& report);

/// `sightline-bench solids ...`; throws what bench/main.cpp handles.
int run_solids_command(int argc, const char* const* argv);

}  // namespace sightline::bench
