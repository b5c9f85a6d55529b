#pragma once

#include <ctime>

namespace sightline::bench {

/// Seconds of this thread on a processor.
inline double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1'000'000'000;
}

}  // namespace sightline::bench
