#pragma once
/// Whole pictures: rays a second, and what more threads bring.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/estimate.h"
#include "bench/machine.h"
#include "sightline/io/progress.h"
#include "sightline/math/level.h"

namespace sightline::bench {

struct ScalingPlan {
  std::vector<std::string> scenes;  ///< As make_scene() takes them, or names of data/scenes.
  std::vector<int> threads;         ///< The first is what the others are compared with.
  int width = 640, height = 480;
  std::uint32_t samples = 2;  ///< Of a pixel.
  int rounds = 7;
  double row_seconds = 30;  ///< A line that would take longer for all its rounds takes part in fewer.
  Level level = Level::watertight;
  std::filesystem::path data_dir;
  std::string spoiled, json;
};

struct ThreadsRow {
  int threads = 1;
  std::vector<double> round_seconds;  ///< On the wall, from a blank film to the exposed one; NaN where it sat out.
  std::optional<Estimate> seconds;
  std::optional<Estimate> speed_up;  ///< The first row's time over this one's, in the same round.
};

struct ScalingSceneReport {
  std::string name, integrator;
  double build_seconds = 0;  ///< Of all that finds surfaces, on as many threads as there are; not part of the rounds.
  std::uint64_t rays = 0;    ///< Of a picture.
  std::vector<ThreadsRow> rows;
};

struct ScalingReport {
  Machine machine;
  ScalingPlan plan;
  std::vector<ScalingSceneReport> scenes;
};

/// Scenes of data/scenes that differ in what takes their time.
std::vector<std::string> scaling_scenes();

/// As many threads as a picture can have here.
int most_threads();

/// Verifies that films are the same bits for all numbers of threads, then measures.
/// \throws WrongHits where they are not; what make_scene() and Renderer do.
ScalingReport run_scaling(const ScalingPlan& plan, Progress& progress);

std::string text_of(const ScalingReport& report);
std::string json_text(const ScalingReport& report);

}  // namespace sightline::bench
