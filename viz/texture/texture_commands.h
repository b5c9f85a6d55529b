#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "viz/noise_tool/field_flags.h"

namespace sightline::viz {

/// `sightline-view wood`: its options, and what it does.
class WoodCommand {
 public:
  explicit WoodCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run() const;

 private:
  CLI::App* command_;
  std::string texture_ = "wood", size_ = "1600x1080", out_;
  bool is_tuning_ = false, is_list_ = false;
};

/// `sightline-view normals`, likewise.
class NormalsCommand {
 public:
  explicit NormalsCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  int run() const;

 private:
  CLI::App* command_;
  noise_tool::FieldFlags field_;
  std::string size_ = "1600x1000", out_;
  double amplitude_ = 0.08;
  int divisions_ = 256;
};

}  // namespace sightline::viz
