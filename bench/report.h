#pragma once
/// What a run found, as the table and the JSON file show it.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bench/contender.h"
#include "bench/estimate.h"
#include "bench/machine.h"
#include "bench/plan.h"

namespace sightline::bench {

/// One contender at one workload. A build counts as one "ray".
struct Measurement {
  std::size_t rays = 0;                 ///< That this contender is asked in one pass.
  double hit_share = 0;                 ///< Of all rays of the workload.
  std::optional<TraversalStats> stats;  ///< Over `rays`; counted outside the timing.
  std::size_t disagreeing_rays = 0;     ///< A peer's: other hits than ours, beyond rounding.
  double first_pass_seconds = 0;        ///< Real time of the first pass, which completes a lazy structure ...
  double next_pass_seconds = 0;         ///< ... and of the pass after it, which counts.
  double pass_seconds = 0;              ///< What the rounds were planned with.
  int iterations = 0;                   ///< Passes per round.
  int rounds = 0;                       ///< That it was to take part in.
  /// Seconds of one pass in each round; NaN in the rounds that it did not take part in.
  std::vector<double> round_seconds;

  std::optional<Estimate> seconds;  ///< Of one pass: real for builds, of the thread on a processor for rays.
  std::optional<Estimate> ratio;    ///< Speed per ray over that of the reference peer in the same round.

  std::optional<Estimate> mrays_per_second() const {
    if (!seconds) return std::nullopt;
    const double mrays = 1e-6 * static_cast<double>(rays);
    return Estimate{mrays / seconds->median, mrays / seconds->high, mrays / seconds->low, seconds->confidence};
  }
};

struct ContenderReport {
  std::string name;
  Contender::Kind kind = Contender::Kind::ours;
  bool is_asked_fewer = false;                  ///< Rays than there are, picked at random, because it is slow.
  std::string accelerator;                      ///< Of ours: the registry's name.
  std::vector<TracerSettings::Option> options;  ///< Of ours: those that were set.
  std::optional<Asking> asking;                 ///< Of ours: as asked for.
  Level level = Level::watertight;              ///< As answered; of a peer: of ours that it is held against.
  std::optional<std::size_t> built_as;          ///< The earlier contender of the scene whose structure it asks.
  Built::Bytes bytes;                           ///< After all rays were traced once.
  std::size_t bytes_when_built = 0;
  std::array<std::optional<Measurement>, workload_count> at;  ///< By Workload; none where not asked for.

  /// It goes on building while it is asked.
  bool is_lazy() const { return bytes.total() != bytes_when_built; }
};

struct SceneReport {
  std::string name;
  std::size_t triangles = 0;
  std::size_t sampled_rays = 0;  ///< That brute force verified, of each workload.
  std::vector<ContenderReport> contenders;
};

struct Report {
  Machine machine;
  Plan plan;
  std::vector<SceneReport> scenes;
};

/// By round, the speed per ray over the reference's; NaN in rounds in which not both took part.
std::vector<double> paired_ratios(const Measurement& own, const Measurement& reference);

/// What ratios refer to; null where it is not part of the run.
const ContenderReport* reference_of(const SceneReport& scene);

/// Fills `seconds` and `ratio` in from `round_seconds`. A ratio is the median of the ratios of the rounds in which both
/// took part, so that what slows the machine down for a while slows both. Whoever shares a structure shares its build.
void summarize(SceneReport& scene);

}  // namespace sightline::bench
