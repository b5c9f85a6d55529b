#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sightline::bench {

inline constexpr int no_such_program = 127, no_exit_code = 126;

/// Runs a program of the PATH, its name the first word; all that it prints goes into the file. Its exit code; or
/// no_such_program, or no_exit_code where a signal ended it.
int run_program(std::vector<std::string> words, const std::filesystem::path& log);

/// All that is in a file; nothing where it cannot be read.
std::string text_in(const std::filesystem::path& path);

}  // namespace sightline::bench
