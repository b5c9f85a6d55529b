#pragma once
/// Options that several subcommands have.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "viz/view_options.h"

namespace sightline::viz {

/// --accel, --scene, --set and --threads.
class StructureOptions {
 public:
  StructureOptions(CLI::App& command, const std::string& accelerators = "kd-tree", bool has_many = false);

  const std::string& accelerators() const { return accelerators_; }
  const std::string& scene() const { return scene_; }
  const std::vector<std::string>& settings() const { return settings_; }
  int threads() const { return threads_; }
  /// Of a command that has one structure. \throws UsageError
  AcceleratorSpec structure() const;
  /// " --accel kd-tree --scene teapot --set kd-tree.max_depth=8"
  std::string text() const;

 private:
  std::string accelerators_, scene_ = "teapot";
  std::vector<std::string> settings_;
  int threads_ = 0;
};

/// --azimuth, --elevation and --zoom.
class CameraOptions {
 public:
  explicit CameraOptions(CLI::App& command, double elevation = 20, const std::string& whole = "everything");

  /// \throws UsageError for what is no number
  void check() const;
  double azimuth() const { return azimuth_; }
  double elevation() const { return elevation_; }
  double zoom() const { return zoom_; }
  bool has_azimuth() const { return azimuth_option_->count() > 0; }
  bool has_elevation() const { return elevation_option_->count() > 0; }

 private:
  double azimuth_ = 24, elevation_, zoom_ = 1;
  CLI::Option *azimuth_option_, *elevation_option_;
};

/// --out, which may be repeated.
void add_outs(CLI::App& command, std::vector<std::string>& outs, const std::string& kinds);

}  // namespace sightline::viz
