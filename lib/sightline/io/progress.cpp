#include "sightline/io/progress.h"

#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace sightline {
namespace {

constexpr std::chrono::milliseconds redraw_interval{500};
constexpr std::chrono::hours idle_interval{1};

int terminal_width() {
  winsize window{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 1 ? window.ws_col : 80;
}

std::string text_of(std::chrono::duration<double> time) {
  constexpr double longest = 359'999;  // 100 hours: more is not known
  const auto seconds = static_cast<int>(std::min(time.count(), longest));
  const auto with = [](int amount, const char* unit) { return std::to_string(amount) + unit; };
  if (seconds < 100) return with(seconds, " s");
  if (seconds < 6000) return with(seconds / 60, " min ") + with(seconds % 60, " s");
  return with(seconds / 3600, " h ") + with(seconds / 60 % 60, " min");
}

}  // namespace

Progress::Progress(Clock::duration patience) : patience_(patience), is_terminal_(isatty(STDERR_FILENO) != 0) {
  // Signals are for the program's own threads: the new one inherits a mask that leaves none to it.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  watcher_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

/// The mutex must be held.
void Progress::begin(const std::string& step, const std::string& detail) {
  detail_ = detail;
  if (step == step_) return;
  step_ = step;
  start_ = Clock::now();
  share_.reset();
  is_shown_ = false;
  change_.notify_one();
}

void Progress::say(const std::string& step, const std::string& detail) {
  const std::lock_guard lock(mutex_);
  begin(step, detail);
}

void Progress::say(const std::string& step, const std::string& detail, double share) {
  const std::lock_guard lock(mutex_);
  begin(step, detail);
  if (!share_) {
    first_share_ = share;
    share_start_ = Clock::now();
  }
  share_ = share;
}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  step_.clear();
  if (!is_line_open_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  is_line_open_ = false;
}

void Progress::watch(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    const Clock::time_point now = Clock::now();
    Clock::time_point next = now + idle_interval;
    if (!step_.empty()) {
      // A terminal's line that is open already belongs to whatever is going on.
      const bool is_due = is_line_open_ || now - start_ >= patience_;
      const bool tells_more = !is_shown_ || (share_ && now >= next_line_);
      if (is_due && (is_terminal_ || tells_more)) show(now);
      if (!is_due) next = start_ + patience_;
      if (is_due && (is_terminal_ || share_)) next = now + redraw_interval;
    }
    const std::string seen = step_;
    const Clock::time_point seen_start = start_;
    change_.wait_until(lock, stop, next, [&] { return step_ != seen || start_ != seen_start; });
  }
}

void Progress::show(Clock::time_point now) {
  std::string text = step_ + (share_ || !detail_.empty() ? ": " : "");
  if (share_) text += std::to_string(static_cast<int>(100 * *share_)) + "%" + (detail_.empty() ? "" : ", ");
  text += detail_ + " (" + text_of(now - start_) + " so far";
  if (share_ && *share_ > first_share_) {
    text += ", " + text_of((now - share_start_) * ((1 - *share_) / (*share_ - first_share_))) + " left";
  }
  text += ")";
  is_shown_ = true;
  next_line_ = now + (now - start_);
  if (!is_terminal_) {
    std::fprintf(stderr, "%s\n", text.c_str());
    return;
  }
  std::fprintf(stderr, "\r%.*s\033[K", terminal_width() - 1, text.c_str());  // one that wraps could not be overwritten
  std::fflush(stderr);
  is_line_open_ = true;
}

}  // namespace sightline
