#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sightline::viz {

/// `sightline-view drawing`: its options, and what it does.
class DrawingCommand {
 public:
  explicit DrawingCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws FileError, ScreenError, UsageError
  int run() const;

 private:
  CLI::App* command_;
  std::string file_, out_, size_ = "1200x900";
};

}  // namespace sightline::viz
