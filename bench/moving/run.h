#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/estimate.h"
#include "bench/machine.h"
#include "sightline/io/progress.h"
#include "sightline/query/accelerator_spec.h"

namespace sightline::bench {

struct MovingPlan {
  int levels = 12;  ///< Of make_levels: 2^levels - 1 spheres.
  int frames = 200;
  double degrees = 360;  ///< That each child turns by from the first frame to the last.
  int width = 160, height = 120;
  std::vector<AcceleratorSpec> uppers;
  std::string lower = "box-tree";
  std::string spoiled;  ///< The name of a line that is made wrong on purpose; usually empty.
  std::string json;
};

/// A line of the table: one structure over the instances, in seconds a frame.
struct MovingRow {
  std::string name;
  std::vector<double> build_seconds, refit_seconds;                 ///< By frames, without the first.
  std::vector<double> built_trace_seconds, refitted_trace_seconds;  ///< By frames, without the first.
  Estimate build, refit, built_trace, refitted_trace;
  Estimate ratio;               ///< Building over refitting, in the same frame.
  int builds_when_cheaper = 0;  ///< Frames for which MovePolicy::cheaper built anew.
  double cheaper_seconds = 0;   ///< Of all its frames, building, refitting and tracing,
  double rebuild_seconds = 0;   ///< and of all frames built anew.
};

struct MovingReport {
  Machine machine;
  MovingPlan plan;
  std::size_t instances = 0, triangles = 0;
  double update_seconds =
      0;  ///< Median of a frame: turning the nodes and placing their meshes, for whatever comes next.
  std::vector<MovingRow> rows;
};

/// Plays the animation with each structure refitted, built anew, and by choice, and holds each frame's hits against the
/// others'. \throws WrongHits where they differ
MovingReport run_moving(const MovingPlan& plan, Progress& progress);

std::string text_of(const MovingReport& report);
std::string json_text(const MovingReport& report);

/// `sightline-bench moving ...`; throws what bench/main.cpp handles.
int run_moving_command(int argc, const char* const* argv);

}  // namespace sightline::bench
