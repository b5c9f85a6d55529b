#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sightline::viz {

/// `sightline-view walk`: its options, and what it does.
class WalkCommand {
 public:
  /// Refers to the folder of scene data, which is an option of the program.
  WalkCommand(CLI::App& program, const std::string& data_folder);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run() const;

 private:
  CLI::App* command_;
  const std::string& data_;
  std::string accelerator_ = "kd-tree", scene_ = "teapot", ray_, pick_, size_ = "1920x1080", frames_;
  std::vector<std::string> settings_, earlier_, outs_;
  int threads_ = 0, benchmark_ = 0;
  long long step_ = -1;
  std::size_t every_ = 1, after_ = 0;
  double azimuth_ = 24, elevation_ = 20, zoom_ = 1;
};

}  // namespace sightline::viz
