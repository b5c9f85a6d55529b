#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sightline::viz {

/// `sightline-view graph`: its options, and what it does.
class GraphCommand {
 public:
  /// Refers to the folder of scene data, which is an option of the program.
  GraphCommand(CLI::App& program, const std::string& data_folder);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run() const;

 private:
  CLI::App* command_;
  const std::string& data_;
  std::string scene_ = "levels:4", bounds_ = "box", level_, selected_, drag_, time_, size_ = "1600x1000", out_;
  int frames_ = 0;
  bool has_bounds_only_ = false;
  double azimuth_ = 24, elevation_ = 16, zoom_ = 1;
};

}  // namespace sightline::viz
