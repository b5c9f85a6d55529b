#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/estimate.h"
#include "bench/machine.h"
#include "sightline/io/progress.h"
#include "sightline/query/accelerator_spec.h"

namespace sightline::bench {

struct InstancePlan {
  std::string scene = "teapot";
  std::uint32_t count = 1'000'000;
  std::vector<AcceleratorSpec> uppers;  ///< Over the instances.
  AcceleratorSpec lower;                ///< Of the mesh.
  Level level = Level::watertight;
  std::size_t rays = 20'000;
  int rounds = 11;
  std::size_t checked_rays = 40;  ///< Of each set, held against all instances one by one.
  std::string spoiled;            ///< The name of a line that is made wrong on purpose; usually empty.
  std::string json, data_dir;
};

/// A line of the table: one structure over the instances.
struct InstanceRow {
  std::string name;
  bool is_peer = false;
  double build_seconds = 0;
  std::size_t bytes = 0;  ///< Placements and the upper structure.
  /// What the process took more than before, in bytes, while it traces and at the most while it built; 0 if unknown.
  std::size_t resident = 0, peak = 0;
  struct Times {
    std::vector<double> round_seconds;
    Estimate seconds;                ///< Of all rays of the set.
    std::optional<Estimate> ratio;   ///< Embree's time over this one's, in the same round.
    std::size_t differing_hits = 0;  ///< Of a peer: rays that end at another triangle.
  };
  std::vector<Times> times;  ///< By sets of rays.
};

struct InstanceReport {
  Machine machine;
  InstancePlan plan;
  std::size_t mesh_triangles = 0, mesh_bytes = 0, placement_bytes = 0;
  std::vector<std::string> sets, descriptions;
  std::vector<std::size_t> ray_counts, hit_counts;
  std::vector<InstanceRow> rows;
};

/// Verifies, then measures. \throws WrongHits where ours differ from each other or from all instances one by one.
InstanceReport run_instances(const InstancePlan& plan, Progress& progress);

std::string text_of(const InstanceReport& report);
std::string json_text(const InstanceReport& report);

/// `sightline-bench instances ...`; throws what bench/main.cpp handles.
int run_instances_command(int argc, const char* const* argv);

}  // namespace sightline::bench
