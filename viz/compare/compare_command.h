#pragma once

#include "viz/command_options.h"

namespace sightline::viz {

class WindowFrame;

/// `sightline-view compare`: its options, and what it does; or `heat`, which is that with one structure and its work.
class CompareCommand {
 public:
  /// Refers to the folder of scene data, whose option is the program's.
  CompareCommand(CLI::App& program, const std::string& data_folder, bool is_heat = false);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run(WindowFrame* frame = nullptr) const;

 private:
  struct Plan;
  Plan plan() const;

  bool is_heat_;
  CLI::App* command_;
  const std::string& data_;
  std::string usual_data_;
  StructureOptions structures_;
  CameraOptions camera_;
  std::string show_, count_ = "all", against_, ray_, pick_, size_ = "1920x1080";
  std::vector<std::string> outs_;
  int alone_ = 0;
  double turn_ = 0;
};

}  // namespace sightline::viz
