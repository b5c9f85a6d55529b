#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sightline::viz {

/// `sightline-view page`: its options, and what it does.
class PageCommand {
 public:
  /// `data`: the folder of scenes, which the program's options tell.
  PageCommand(CLI::App& program, const std::string& data);

  bool is_chosen() const { return command_->parsed(); }
  /// The exit status. \throws UsageError, std::invalid_argument, FileError, std::runtime_error without three.js
  int run() const;

 private:
  /// By which the page can be had again.
  std::string command_line(const std::vector<std::string>& rays) const;

  CLI::App* command_;
  const std::string& data_;
  std::string accelerators_ = "kd-tree,box-tree,grid", scene_ = "teapot", size_ = "1200x900", html_;
  std::vector<std::string> settings_, rays_, picks_;
  int threads_ = 0;
  double azimuth_ = 24, elevation_ = 20, zoom_ = 1;
};

}  // namespace sightline::viz
