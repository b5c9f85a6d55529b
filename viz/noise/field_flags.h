#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "sightline/noise/field_options.h"

namespace sightline::viz {

/// --kind, --ease, --seed, --period, --fractal, --octaves, --lacunarity, --gain, --frequency and --warp of a command.
class FieldFlags {
 public:
  explicit FieldFlags(CLI::App& command);

  /// \throws UsageError for a name that is not known; ranges are checked where the field is made.
  FieldOptions options() const;

 private:
  FieldOptions options_;
  std::string kind_ = "perlin", ease_ = "cubic", fractal_ = "none";
};

}  // namespace sightline::viz
