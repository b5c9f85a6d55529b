#pragma once

#include <functional>

#include "viz/command_options.h"

namespace sightline::viz {

class WindowFrame;

/// `sightline-view window`, or without a subcommand: all pages in one window, or the file of one of them.
class WindowCommand {
 public:
  /// Does what the words of a command line ask for; a window is shown in the frame, if there is one.
  using Run = std::function<int(const std::vector<std::string>&, WindowFrame*)>;

  /// Refers to the folder of scene data, which is an option of the program.
  WindowCommand(CLI::App& program, const std::string& data_folder, Run run);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run() const;

 private:
  CLI::App* command_;
  const std::string& data_;
  std::string usual_data_;
  Run run_;
  StructureOptions structure_;
  CameraOptions camera_;
  std::string page_, ray_, pick_, size_ = "1600x1000";
  std::vector<std::string> outs_;
};

}  // namespace sightline::viz
