#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace sightline::viz {

/// The folder of the running program, where its siblings are.
std::filesystem::path program_folder();

/// A program that runs beside this one, with its input, output and display. It is ended (SIGTERM) with this object, and
/// when the thread that started it dies, however it does.
class RunningProgram {
 public:
  /// \throws std::runtime_error where it cannot be started.
  RunningProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Waits for its end. Its exit status, or 128 + the signal that ended it.
  int wait();

 private:
  pid_t child_ = -1;  ///< -1 once it was waited for.
};

/// Runs a program to its end. As RunningProgram says.
int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments);

}  // namespace sightline::viz
