#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "sightline/noise/field_options.h"

namespace sightline::noise_tool {

/// --kind, --ease, --seed, --period, --fractal, --octaves, --lacunarity, --gain, --frequency and --warp of a command.
class FieldFlags {
 public:
  explicit FieldFlags(CLI::App& command);

  /// \throws std::invalid_argument for a name that is not known; ranges are checked where the field is made.
  FieldOptions options() const;

 private:
  FieldOptions options_;
  std::string kind_ = "perlin", ease_ = "cubic", fractal_ = "none";
};

/// "z=0.5" or "0.5": where noise of space is cut. \throws std::invalid_argument
double parse_slice(const std::string& text);

}  // namespace sightline::noise_tool
