#pragma once

#include "viz/command_options.h"

namespace sightline::viz {

class WindowFrame;

/// `sightline-view walk`: its options, and what it does.
class WalkCommand {
 public:
  /// Refers to the folder of scene data, which is an option of the program.
  WalkCommand(CLI::App& program, const std::string& data_folder);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run(WindowFrame* frame = nullptr) const;

 private:
  CLI::App* command_;
  const std::string& data_;
  StructureOptions structure_;
  CameraOptions camera_;
  std::string ray_, pick_, size_ = "1920x1080", frames_;
  std::vector<std::string> earlier_, outs_;
  int benchmark_ = 0;
  long long step_ = -1;
  std::size_t every_ = 1, after_ = 0;
};

}  // namespace sightline::viz
