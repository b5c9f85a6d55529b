#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sightline::viz {

/// `sightline-view compare`: its options, and what it does.
class CompareCommand {
 public:
  /// Refers to the folder of scene data, whose option is the program's.
  CompareCommand(CLI::App& program, const std::string& data_folder);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run() const;

 private:
  struct Plan;
  Plan plan() const;

  CLI::App* command_;
  const std::string& data_;
  std::string usual_data_;
  std::string accelerators_ = "box-tree,sphere-tree,grid,bsp-tree,kd-tree,bih", scene_ = "teapot", show_ = "walk",
              count_ = "all", against_, ray_, pick_, size_ = "1920x1080";
  std::vector<std::string> settings_, outs_;
  int threads_ = 0, alone_ = 0;
  double azimuth_ = 24, elevation_ = 20, zoom_ = 1, turn_ = 0;
};

}  // namespace sightline::viz
