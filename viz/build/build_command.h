#pragma once

#include "viz/command_options.h"

namespace sightline::viz {

class WindowFrame;

/// `sightline-view build`: its options, and what it does.
class BuildCommand {
 public:
  /// Refers to the folder of scene data, which is an option of the program.
  BuildCommand(CLI::App& program, const std::string& data_folder);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run(WindowFrame* frame = nullptr) const;

 private:
  CLI::App* command_;
  const std::string& data_;
  StructureOptions structure_;
  CameraOptions camera_;
  std::string size_ = "1920x1080", out_, frames_;
  std::uint32_t node_ = 0;
  std::size_t step_ = 0, most_frames_ = 50;
};

}  // namespace sightline::viz
