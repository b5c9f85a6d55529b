#pragma once

#include "viz/command_options.h"
#include "viz/noise_tool/field_flags.h"

namespace sightline::viz {

class WindowFrame;

/// `sightline-view noise`: its options, and what it does.
class NoiseCommand {
 public:
  explicit NoiseCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run(WindowFrame* frame = nullptr) const;

 private:
  CLI::App* command_;
  noise_tool::FieldFlags field_;
  CameraOptions camera_;
  std::string panel_, point_ = "1.6,1.35", size_ = "1600x1000", slice_ = "z=0.5";
  std::vector<std::string> outs_;
  double extent_ = 4;
};

}  // namespace sightline::viz
