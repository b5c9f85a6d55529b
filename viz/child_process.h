#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sightline::viz {

/// The folder of the running program, where its siblings are.
std::filesystem::path program_folder();

/// Runs a program to its end, with this one's input, output and display; SIGTERM ends it when this one dies first,
/// however it does. Its exit status, or 128 + the signal that ended it. \throws std::runtime_error where it cannot be
/// started.
int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments);

}  // namespace sightline::viz
