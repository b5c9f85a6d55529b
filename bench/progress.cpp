#include "bench/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

namespace sightline::bench {

Progress::Progress() : is_terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), last_(start_) {}

void Progress::say(const std::string& text) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (now - start_ < 2s) return;
  const bool is_first = last_ == start_;
  if (!is_first && now - last_ < (is_terminal_ ? Clock::duration(100ms) : Clock::duration(10s))) return;
  last_ = now;
  if (!is_terminal_) {
    std::fprintf(stderr, "%s\n", text.c_str());
    return;
  }
  winsize window{};
  const bool is_known = ioctl(STDERR_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 1;
  const int width = is_known ? window.ws_col - 1 : 79;  // a line that wraps could not be overwritten
  std::fprintf(stderr, "\r%.*s\033[K", width, text.c_str());
  std::fflush(stderr);
  is_line_open_ = true;
}

void Progress::clear() {
  if (!is_line_open_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  is_line_open_ = false;
}

}  // namespace sightline::bench
