#pragma once
/// Where programs run that nobody vouches for.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace sightline::labs {

/// Programs in here
///   B1  see the system's programs and libraries, and the folders that they are given, nothing else: no home, no other
///       submission, no solution;
///   B2  write to their own folder, where they are given one to write to, and to 64 MB of /tmp that goes with them;
///   B3  have no network, and no other process to see or to signal;
///   B4  end with the program that runs them, and with all that they have started.
/// By bubblewrap's namespaces, and seccomp for C1.
class Sandbox {
 public:
  /// \throws std::runtime_error in one line where this machine offers none, with what would help
  Sandbox();
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  /// The words that run a command, its program a full path, which reads from `readable` and writes to `writable`.
  std::vector<std::string> wrap(const std::vector<std::string>& command,
                                const std::vector<std::filesystem::path>& readable,
                                const std::vector<std::filesystem::path>& writable) const;

  /// The same for a student's program: it also starts no process (C1). Threads it may start.
  std::vector<std::string> wrap_alone(const std::vector<std::string>& command,
                                      const std::vector<std::filesystem::path>& readable) const;

 private:
  int filter_ = -1;  ///< A file without a name that holds the filter of system calls.
};

}  // namespace sightline::labs
