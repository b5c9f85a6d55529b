#include "bench/machine.h"

#include <tbb/version.h>

#include <cstdlib>
#include <thread>

#include "bench/peers/embree.h"
#include "bench/peers/peers.h"
#include "sightline/io/host.h"

namespace sightline::bench {

Machine this_machine() {
  Machine machine;
  machine.processor = processor_name();
  machine.hardware_threads = std::thread::hardware_concurrency();
  if (getloadavg(&machine.load, 1) != 1) machine.load = -1;
  machine.system = system_name();
  machine.compiler = compiler_name();
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
