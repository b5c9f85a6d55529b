#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bench/solids/picture.h"
#include "bench/solids/scratch_folder.h"

namespace sightline::bench {

/// POV-Ray as a program of this machine, given one scene after the other.
class Povray {
 public:
  /// Nothing where there is no program `povray` in PATH.
  static std::optional<Povray> find();

  const std::string& version() const { return version_; }

  /// Traces a scene, in its own language (povray_text.h), into a picture.
  /// \throws std::runtime_error with what POV-Ray says where it fails.
  Picture paint(const std::string& scene, int width, int height);

  /// What POV-Ray says of its tracing: seconds of the processor that its one thread took, and between begin and end on
  /// the wall ("Trace Time"). Both are multiples of 0.001.
  struct TraceTime {
    double processor, elapsed;
  };
  /// No picture is written.
  TraceTime trace(const std::string& scene, int width, int height);

 private:
  Povray();
  std::string run(const std::string& scene, int width, int height, const std::string& output);

  ScratchFolder folder_{{"scene.pov", "log", "picture.ppm"}};
  std::filesystem::path source_, log_, picture_;  ///< In that folder.
  std::string version_;
};

/// The options that it is run with, for reports: one thread, no display, no antialiasing, full quality.
inline constexpr std::string_view povray_options = "+WT1 -D -A -V +Q9";

}  // namespace sightline::bench
