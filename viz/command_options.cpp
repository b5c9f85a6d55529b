#include "viz/command_options.h"

#include "viz/command_text.h"

namespace sightline::viz {

StructureOptions::StructureOptions(CLI::App& command, const std::string& accelerators, bool has_many)
    : accelerators_(accelerators) {
  const std::string what = has_many ? "Structures, by commas; default " : "The structure, see --list; default ";
  command.add_option("--accel", accelerators_, what + accelerators)
      ->option_text(has_many ? "NAME[:OPTION=VALUE,...],..." : "NAME[:OPTION=VALUE,...]");
  command.add_option("--scene", scene_, "A scene of list, with or without :SIZE, or a mesh file; default teapot")
      ->option_text("SCENE");
  command
      .add_option("--set", settings_,
                  has_many ? "An option of all entries of a structure; may be repeated"
                           : "An option of the structure; may be repeated")
      ->option_text("ACCEL.OPTION=VALUE")
      ->expected(1)
      ->take_all();
  command.add_option("--threads", threads_, "Threads to build with, to 1024; default 0: all")
      ->check(CLI::Range(0, 1024))
      ->option_text("N");
}

AcceleratorSpec StructureOptions::structure() const {
  AcceleratorSpec spec = parse_structure(accelerators_, settings_);
  spec.settings.threads = threads_;
  return spec;
}

std::string StructureOptions::text() const {
  std::string text = option_text("--accel", accelerators_) + option_text("--scene", scene_);
  for (const std::string& setting : settings_) text += option_text("--set", setting);
  return text;
}

CameraOptions::CameraOptions(CLI::App& command, double elevation, const std::string& whole) : elevation_(elevation) {
  azimuth_option_ = command.add_option("--azimuth", azimuth_, "Camera: degrees to the right of the front; default 24")
                        ->check(CLI::Range(-360.0, 360.0))
                        ->option_text("DEGREES");
  elevation_option_ =
      command
          .add_option("--elevation", elevation_, "Camera: degrees above the horizon; default " + shortest(elevation))
          ->check(CLI::Range(-90.0, 90.0))
          ->option_text("DEGREES");
  command.add_option("--zoom", zoom_, "Camera: 1 shows " + whole + ", 2 comes twice as close")
      ->check(CLI::Range(0.1, 100.0))
      ->option_text("FACTOR");
}

void CameraOptions::check() const {
  require_number("--azimuth", azimuth_);
  require_number("--elevation", elevation_);
  require_number("--zoom", zoom_);
}

void add_outs(CLI::App& command, std::vector<std::string>& outs, const std::string& kinds) {
  command.add_option("--out", outs, "A " + kinds + " file instead of a window; may be repeated")
      ->option_text("FILE")
      ->expected(1)
      ->take_all();
}

}  // namespace sightline::viz
