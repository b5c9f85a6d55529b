#pragma once
/// Where and with what a run was made; no number means anything without it.

#include <string>

namespace sightline::bench {

struct Machine {
  std::string processor;
  unsigned hardware_threads = 0;
  double load = 0;  ///< Average number of running programs over the last minute, before the run; -1 when unknown.
  std::string system;
  std::string compiler;
  std::string flags;
  std::string build_type;
  bool has_assertions = false;  ///< Then times say little.
  std::string date;             ///< UTC, ISO 8601.
  std::string sightline_version, embree_version, cgal_version, vtk_version, google_benchmark_version, tbb_version;
};

Machine this_machine();

}  // namespace sightline::bench
