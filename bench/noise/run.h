#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/estimate.h"
#include "bench/machine.h"
#include "sightline/io/progress.h"

namespace sightline::bench {

struct NoisePlan {
  std::size_t points = std::size_t{1} << 14;  ///< Of each pass: more than the nearest cache holds.
  int rounds = 21;
  double slot_seconds = 0.004;  ///< A contender's share of a round is at least as long.
  bool is_spoiled = false;      ///< Makes one value of a batch wrong: the run has to refuse.
  std::string json;
};

/// One way to ask for noise at all points of a pass.
struct NoiseContender {
  std::string table;  ///< "random points", "grid, row by row", ...
  std::string name;   ///< "perlin float batch"
  std::function<void()> pass;
  bool is_peer = false;
  double error = 0;  ///< Of gradients: the largest, against the analytic one in double.
};

struct NoiseRow {
  std::string table, name;
  bool is_peer = false;
  double error = 0;
  std::vector<double> round_seconds;  ///< Of one point.
  Estimate seconds;
  std::optional<Estimate> ratio;  ///< libnoise's time at the same points over this one, paired by round.
};

/// Float against double, at points so far from the origin.
struct NoiseAccuracy {
  std::string name;
  double distance = 0;
  double largest = 0, rms = 0;
};

struct NoiseReport {
  Machine machine;
  NoisePlan plan;
  std::vector<std::string> missing;  ///< Packages of peers that this build is without.
  std::vector<NoiseRow> rows;
  std::vector<NoiseAccuracy> accuracy;
};

/// \throws WrongHits where a batch is not what single points are, or improved noise not the reference.
std::vector<NoiseContender> make_noise_contenders(const NoisePlan& plan);
std::vector<NoiseAccuracy> accuracy_of_floats();

/// Verifies, then measures in rounds, each of which begins with the next contender.
NoiseReport run_noise(const NoisePlan& plan, Progress& progress);

std::string text_of(const NoiseReport& report);
std::string json_text(const NoiseReport& report);

/// `sightline-bench noise ...`; throws what bench/main.cpp handles.
int run_noise_command(int argc, const char* const* argv);

}  // namespace sightline::bench
