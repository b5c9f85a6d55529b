#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sightline::viz {

/// `sightline-view build`: its options, and what it does.
class BuildCommand {
 public:
  /// Refers to the folder of scene data, which is an option of the program.
  BuildCommand(CLI::App& program, const std::string& data_folder);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run() const;

 private:
  CLI::App* command_;
  const std::string& data_;
  std::string accelerator_ = "kd-tree", scene_ = "teapot", size_ = "1920x1080", out_, frames_;
  std::vector<std::string> settings_;
  int threads_ = 0;
  std::uint32_t node_ = 0;
  std::size_t step_ = 0, most_frames_ = 50;
  double azimuth_ = 24, elevation_ = 20, zoom_ = 1;
};

}  // namespace sightline::viz
