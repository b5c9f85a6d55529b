#pragma once

#include <string>
#include <vector>

#include "viz/command_options.h"
namespace sightline::viz {

class WindowFrame;

/// `sightline-view graph`: its options, and what it does.
class GraphCommand {
 public:
  /// Refers to the folder of scene data, which is an option of the program.
  GraphCommand(CLI::App& program, const std::string& data_folder);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run(WindowFrame* frame = nullptr) const;

 private:
  CLI::App* command_;
  const std::string& data_;
  CameraOptions camera_;
  std::vector<std::string> moved_;
  std::string scene_ = "levels:4", bounds_ = "box", level_, selected_, drag_, time_, size_ = "1600x1000", out_;
  int frames_ = 0;
  bool has_bounds_only_ = false;
};

}  // namespace sightline::viz
