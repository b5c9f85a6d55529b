#include "viz/render_tool/monitor.h"

#include <signal.h>

#include <cstdio>
#include <iostream>

#include "sightline/render/checkpoint.h"
#include "sightline/render/ray_count.h"

namespace sightline::render_tool {
namespace {

constexpr std::chrono::milliseconds tell_interval{200};
constexpr std::chrono::seconds show_interval{1};

}  // namespace

Monitor::Monitor(const Film& film, const Outlets& outlets)
    : film_(film), outlets_(outlets), first_rays_(rays_of(film.progress().counters)) {
  // Signals are for the program's own threads: the new one inherits a mask that leaves none to it.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  watcher_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

void Monitor::watch(const std::stop_token& stop) {
  Clock::time_point next_show = start_ + show_interval;
  Clock::time_point last_kept = start_;
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, stop, tell_interval, [&] { return stop.stop_requested(); }) && !stop.stop_requested()) {
    tell();
    const Clock::time_point now = Clock::now();
    if (now >= next_show) {
      show();
      next_show = Clock::now() + show_interval;
    }
    if (outlets_.checkpoint_interval.count() > 0 && now - last_kept >= outlets_.checkpoint_interval) {
      keep();
      last_kept = Clock::now();
    }
  }
}

void Monitor::tell() {
  if (!outlets_.progress) return;
  const FilmProgress progress = film_.progress();
  const std::chrono::duration<double> time = Clock::now() - start_;
  const double rate = static_cast<double>(rays_of(progress.counters) - first_rays_) / time.count();
  char detail[96];
  std::snprintf(detail, sizeof detail, "sample %u, %.2f million rays/s", progress.end_of_pass, rate / 1e6);
  const double share = static_cast<double>(progress.done) / static_cast<double>(progress.expected);
  outlets_.progress->say("rendering", detail, share);
}

void Monitor::show() try {
  if (!outlets_.preview || !outlets_.preview->is_shown() || film_.progress().done == shown_) return;
  const FilmState film = film_.copy();
  shown_ = film_.progress().done;
  outlets_.preview->show(film);
} catch (const std::exception& error) {
  outlets_.preview = nullptr;
  std::cerr << "sightline-render: no more preview: " << error.what() << '\n';
}

void Monitor::keep() try {
  write_checkpoint(outlets_.checkpoint, film_.copy(), outlets_.fingerprint);
} catch (const std::exception& error) {
  outlets_.checkpoint_interval = {};
  std::cerr << "sightline-render: no checkpoint: " << error.what() << '\n';
}

}  // namespace sightline::render_tool
