#include "bench/machine.h"

#include <sys/utsname.h>
#include <tbb/version.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

#include "bench/peers/embree.h"
#include "bench/peers/peers.h"

namespace sightline::bench {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::string system_name() {
  utsname names{};
  if (uname(&names) != 0) return "unknown system";
  std::string distribution;
  std::ifstream file("/etc/os-release");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("PRETTY_NAME=\"")) distribution = line.substr(13, line.size() - 14) + ", ";
  }
  return distribution + names.sysname + ' ' + names.release + ' ' + names.machine;
}

std::string utc_date() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

}  // namespace

Machine this_machine() {
  Machine machine;
  machine.processor = processor_name();
  machine.hardware_threads = std::thread::hardware_concurrency();
  if (getloadavg(&machine.load, 1) != 1) machine.load = -1;
  machine.system = system_name();
#ifdef __clang__
  machine.compiler = std::string("Clang ") + __clang_version__;
#else
  machine.compiler = std::string("GCC ") + __VERSION__;
#endif
  machine.flags = SIGHTLINE_BENCH_FLAGS;
  machine.build_type = SIGHTLINE_BENCH_BUILD_TYPE;
#ifndef NDEBUG
  machine.has_assertions = true;
#endif
  machine.date = utc_date();
  machine.sightline_version = SIGHTLINE_BENCH_VERSION;
  machine.embree_version = embree_version();
  machine.cgal_version = cgal_version();
  machine.vtk_version = vtk_version();
  machine.google_benchmark_version = SIGHTLINE_BENCH_GOOGLE_BENCHMARK_VERSION;
  machine.tbb_version = std::to_string(TBB_VERSION_MAJOR) + '.' + std::to_string(TBB_VERSION_MINOR);
  return machine;
}

}  // namespace sightline::bench
