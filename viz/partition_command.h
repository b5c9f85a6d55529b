#pragma once

#include "viz/command_options.h"

namespace sightline::viz {

class WindowFrame;

/// `sightline-view partitions`: its options, and what it does.
class PartitionCommand {
 public:
  /// Refers to the folder of scene data, which is an option of the program.
  PartitionCommand(CLI::App& program, const std::string& data_folder);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status; a window is shown in the frame, if there is one.
  /// \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run(WindowFrame* frame = nullptr) const;

 private:
  CellFilter filter() const;

  CLI::App* command_;
  const std::string& data_;
  StructureOptions structure_;
  CameraOptions camera_;
  std::string out_, depth_, slice_, size_ = "1200x900";
  bool leaves_ = false;
  std::size_t max_cells_ = CellFilter{}.max_cells;
};

}  // namespace sightline::viz
