#pragma once

#include <chrono>
#include <string>

namespace sightline::bench {

/// Says on stderr what is going on, once the run has taken two seconds: on a terminal in one line that is overwritten,
/// elsewhere in a line every ten seconds at most.
class Progress {
 public:
  Progress();
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void say(const std::string& text);
  /// Before anything else is printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool is_terminal_;
  bool is_line_open_ = false;
  Clock::time_point start_, last_;
};

}  // namespace sightline::bench
