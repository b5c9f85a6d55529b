#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sightline::viz {

/// `sightline-view picture`: its options, and what it does.
class PictureCommand {
 public:
  explicit PictureCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws FileError, ScreenError
  int run() const;

 private:
  CLI::App* command_;
  std::string file_;
  bool follows_ = false;
};

}  // namespace sightline::viz
