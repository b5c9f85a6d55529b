#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

#include "sightline/io/progress.h"
#include "sightline/render/film.h"
#include "viz/render_tool/preview.h"

namespace sightline::render_tool {

/// Where a film under way is told of.
struct Outlets {
  Progress* progress = nullptr;
  Preview* preview = nullptr;
  std::filesystem::path checkpoint;
  std::chrono::duration<double> checkpoint_interval{0};  ///< 0: none.
  std::uint64_t fingerprint = 0;
};

/// While this lives, a thread of its own tells how far the film is, shows it, and keeps it in a checkpoint from time to
/// time. A checkpoint that cannot be written is told of in one line, and not tried again.
class Monitor {
 public:
  Monitor(const Film& film, const Outlets& outlets);

 private:
  using Clock = std::chrono::steady_clock;

  void watch(const std::stop_token& stop);
  void tell();
  void show();
  void keep();

  const Film& film_;
  Outlets outlets_;
  Clock::time_point start_ = Clock::now();
  std::uint64_t first_rays_;
  std::uint64_t shown_ = 0;  ///< Samples on the picture that is shown.
  std::mutex mutex_;         ///< Guards nothing but the waiting.
  std::condition_variable_any wake_;
  std::jthread watcher_;  ///< Last, so that it ends before what it uses.
};

}  // namespace sightline::render_tool
