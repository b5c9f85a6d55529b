#include "sightline/io/leftovers.h"

#include <signal.h>
#include <unistd.h>

namespace sightline {

std::array<std::atomic<Leftovers*>, Leftovers::most> Leftovers::table_{};

Leftovers::Leftovers(const std::vector<std::filesystem::path>& files, const std::vector<std::filesystem::path>& folders)
    : files_(files.begin(), files.end()), folders_(folders.begin(), folders.end()), owner_(getpid()) {
  watch_signals();
  for (auto& place : table_) {
    Leftovers* none = nullptr;
    if (!place.compare_exchange_strong(none, this)) continue;
    place_ = &place;
    return;
  }
}

Leftovers::~Leftovers() {
  Leftovers* mine = this;
  const bool is_taken = place_ && !place_->compare_exchange_strong(mine, nullptr);
  while (is_taken) pause();  // L2: this program ends
  remove();
}

/// Only calls what signal handlers may call.
void Leftovers::remove() const {
  for (const std::string& file : files_) unlink(file.c_str());
  for (const std::string& folder : folders_) rmdir(folder.c_str());
}

void Leftovers::end_by_signal(int signal) {
  for (auto& place : table_) {
    const Leftovers* leftovers = place.exchange(nullptr);
    // A fork has the table too, but the files are its parent's.
    if (leftovers && leftovers->owner_ == getpid()) leftovers->remove();
  }
  sigset_t ended;
  sigemptyset(&ended);
  sigaddset(&ended, signal);
  pthread_sigmask(SIG_UNBLOCK, &ended, nullptr);
  raise(signal);        // its action is the default one by now
  _exit(128 + signal);  // the first process of a container outlives that
}

void Leftovers::watch_signals() {
  constexpr std::array signals{SIGHUP, SIGINT, SIGPIPE, SIGQUIT, SIGTERM, SIGXCPU, SIGXFSZ};
  struct sigaction ending {};
  ending.sa_handler = end_by_signal;
  ending.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : signals) sigaddset(&ending.sa_mask, signal);
  for (const int signal : signals) {
    struct sigaction present {};
    sigaction(signal, nullptr, &present);
    const bool is_default = !(present.sa_flags & SA_SIGINFO) && present.sa_handler == SIG_DFL;
    if (is_default) sigaction(signal, &ending, nullptr);
  }
}

}  // namespace sightline
