#pragma once
/// What a program that has nothing to show yet is busy with.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace sightline {

/// Says on stderr what is going on, and for how long, where it takes longer than `patience`: on a terminal in one line
/// that is overwritten, elsewhere in one line a step, and more at ever longer intervals where the step tells how far it
/// is. A thread of its own does so, because a step is often one long call. Safe to use from several threads.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Progress(Clock::duration patience = std::chrono::seconds(2));
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Another `step` begins, or the same one has come to another `detail`.
  void say(const std::string& step, const std::string& detail = {});
  /// The same for a step that is done to this share, from 0 to 1: the time left is reckoned from when it was first
  /// told.
  void say(const std::string& step, const std::string& detail, double share);
  /// The step is over; before anything else is printed.
  void clear();

 private:
  void watch(const std::stop_token& stop);
  void begin(const std::string& step, const std::string& detail);
  void show(Clock::time_point now);

  Clock::duration patience_;
  bool is_terminal_;
  std::mutex mutex_;  ///< Guards all that follows, and the line on stderr.
  std::condition_variable_any change_;
  std::string step_, detail_;  ///< No step: nothing to say.
  Clock::time_point start_;    ///< Of the step.
  std::optional<double> share_;
  double first_share_ = 0;
  Clock::time_point share_start_;  ///< When the first share was told.
  bool is_shown_ = false;          ///< The step, in a line of its own.
  Clock::time_point next_line_;    ///< Elsewhere than on a terminal: when there is another one of the step.
  bool is_line_open_ = false;      ///< On a terminal: a line that is to be overwritten.
  std::jthread watcher_;           ///< Last, so that it ends before what it uses.
};

}  // namespace sightline
