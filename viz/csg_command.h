#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sightline::viz {

class WindowFrame;

/// `sightline-view csg`: its options, and what it does.
class CsgCommand {
 public:
  explicit CsgCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, ScreenError
  int run(WindowFrame* frame = nullptr) const;

 private:
  CLI::App* command_;
  std::string solid_ = "widget", ray_, pick_, precision_ = "watertight", accelerator_ = "box-tree", size_ = "1600x900";
  std::vector<std::string> outs_;
  bool is_list_ = false;
};

}  // namespace sightline::viz
