#pragma once
/// The ladder of costs: what each effect takes, beside the same scene without it.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/estimate.h"
#include "bench/machine.h"
#include "bench/render/ladder_scenes.h"
#include "sightline/io/progress.h"
#include "sightline/render/render_counters.h"

namespace sightline::bench {

struct LadderPlan {
  int width = 400, height = 300;
  int rounds = 31;
  double row_seconds = 60;  ///< A rung that would take longer for all its rounds takes part in fewer.
  Level level = Level::watertight;
  std::filesystem::path data_dir;
  std::string spoiled, json;
};

struct RungReport {
  Rung rung;
  std::string integrator;
  RenderCounters counters;  ///< Of a picture.
  std::vector<double> round_seconds;
  std::optional<Estimate> seconds;
  std::optional<Estimate> over, added;  ///< Beside the rung below, in the same round: times its time, seconds more.

  /// Whether it takes another time than the rung below: 1 is not within the interval.
  bool is_resolved() const { return over && (over->low > 1 || over->high < 1); }
};

struct LadderReport {
  Machine machine;
  LadderPlan plan;
  std::vector<RungReport> rungs;

  double pixels() const { return static_cast<double>(plan.width) * plan.height; }
};

/// The first effect that is off and was counted all the same.
std::optional<Effect> counted_though_off(Effects on, const RenderCounters& counters);

/// Verifies, then measures, on one thread. \throws WrongHits where a rung does not simulate what it is there for, where
/// something was counted that is off, and where its picture is not that of the integrator that knows every effect.
LadderReport run_ladder(const LadderPlan& plan, Progress& progress);

std::string text_of(const LadderReport& report);
std::string json_text(const LadderReport& report);

}  // namespace sightline::bench
