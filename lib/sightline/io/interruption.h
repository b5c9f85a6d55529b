#pragma once

#include <atomic>
#include <cstdint>

namespace sightline {

/// While this lives, the first signal of Ctrl-C (SIGINT) or SIGTERM is a wish to stop; the next one ends the program as
/// ever, and temporary files with it (Leftovers). Within 0.2 seconds it is the same wish: timeout(1) and others signal
/// both a program and its process group. Signals that the program was started to ignore stay ignored. There
/// may be one at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  static const std::atomic<bool>& is_wished() { return is_wished_; }
  /// The signal that wished so, or 0.
  static int signal() { return signal_; }

 private:
  static void wish(int signal);
  static void restore();

  static std::atomic<bool> is_wished_;
  static std::atomic<int> signal_;
  static std::atomic<std::int64_t> time_;  ///< Of the wish, in nanoseconds.
  static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);
};

}  // namespace sightline
