#include "sightline/io/interruption.h"

#include <signal.h>
#include <time.h>

#include <array>
#include <cstddef>

#include "sightline/io/leftovers.h"

namespace sightline {
namespace {

constexpr std::array signals{SIGINT, SIGTERM};
std::array<struct sigaction, signals.size()> before;

}  // namespace

std::atomic<bool> Interruption::is_wished_{false};
std::atomic<int> Interruption::signal_{0};
std::atomic<std::int64_t> Interruption::time_{0};

Interruption::Interruption() {
  is_wished_ = false;
  signal_ = 0;
  const Leftovers none({});  // sees to it that the action before is one that removes temporary files
  struct sigaction wishing {};
  wishing.sa_handler = wish;
  wishing.sa_flags = SA_RESTART;
  for (const int signal : signals) sigaddset(&wishing.sa_mask, signal);
  for (std::size_t i = 0; i < signals.size(); ++i) {
    sigaction(signals[i], nullptr, &before[i]);
    const bool is_ignored = !(before[i].sa_flags & SA_SIGINFO) && before[i].sa_handler == SIG_IGN;
    if (!is_ignored) sigaction(signals[i], &wishing, nullptr);
  }
}

Interruption::~Interruption() { restore(); }

/// Only calls what signal handlers may call.
void Interruption::restore() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before[i], nullptr);
}

void Interruption::wish(int signal) {
  timespec clock{};
  clock_gettime(CLOCK_MONOTONIC, &clock);
  const std::int64_t now = std::int64_t{clock.tv_sec} * 1'000'000'000 + clock.tv_nsec;
  if (!is_wished_) {
    signal_ = signal;
    time_ = now;
    is_wished_ = true;
  } else if (now - time_ >= 200'000'000) {
    restore();
    raise(signal);  // once this returns
  }
}

}  // namespace sightline
