#pragma once

#include <sys/types.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

namespace sightline {

/// Paths to remove when this is destroyed, or when a signal such as that of Ctrl-C ends the program, unless the program
/// handles that signal itself.
///   L1  Complete before the table shows it to signal handlers, and never changed then.
///   L2  Whoever takes it out of the table removes the paths; the other leaves it alone, for it may be gone.
class Leftovers {
 public:
  /// Need not be there, then or now. Files go first, then folders in the order given, if they are empty by then.
  explicit Leftovers(const std::vector<std::filesystem::path>& files,
                     const std::vector<std::filesystem::path>& folders = {});
  ~Leftovers();
  Leftovers(const Leftovers&) = delete;
  Leftovers& operator=(const Leftovers&) = delete;

 private:
  static constexpr std::size_t most = 64;  // at a time; more are removed by their destructors only
  static std::array<std::atomic<Leftovers*>, most> table_;
  static_assert(std::atomic<Leftovers*>::is_always_lock_free);

  static void watch_signals();
  static void end_by_signal(int signal);
  void remove() const;

  std::vector<std::string> files_, folders_;
  pid_t owner_;
  std::atomic<Leftovers*>* place_ = nullptr;
};

}  // namespace sightline
