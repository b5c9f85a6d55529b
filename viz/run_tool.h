#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace sightline {

/// How every tool ends.
inline constexpr int success = 0, failure = 1, wrong_usage = 2;

/// Parses. Returns the status to end with at once, where help or its like was asked for, and has been printed.
/// \throws std::invalid_argument
inline std::optional<int> parse(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(std::string(error.what()) + " (see --help)");
  }
  return std::nullopt;
}

/// What `run` returns; of what it throws one line on standard error, and the status that it stands for: what is wrong
/// with the command line is a std::invalid_argument.
template <class Run>
int run_tool(std::string_view name, Run&& run) {
  const auto report = [&](const std::exception& error, int status) {
    std::cerr << name << ": " << error.what() << '\n';
    return status;
  };
  try {
    const int status = run();
    std::cout.flush();
    const bool is_written = std::cout.good() && std::fflush(stdout) == 0;
    if (status == success && !is_written) throw std::runtime_error("standard output: cannot be written");
    return status;
  } catch (const std::invalid_argument& error) {
    return report(error, wrong_usage);
  } catch (const std::exception& error) {
    return report(error, failure);
  }
}

}  // namespace sightline
