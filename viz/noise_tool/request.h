#pragma once
/// What sightline-noise is asked for, checked as far as it does not depend on the points.

#include <optional>
#include <string>

#include "sightline/math/level.h"
#include "sightline/noise/noise_field.h"

namespace sightline::noise_tool {

struct Slice {
  int width = 512, height = 512;
  double z = 0;
  double extent = 8;  ///< Lattice cells across the picture, around the origin.
};

struct Request {
  FieldOptions field;
  Level precision = Level::precise;  ///< `fast` is float, `precise` double.
  double footprint = 0;
  bool has_gradient = false;
  std::string in = "-";
  std::string image;  ///< Where points are not asked for, but a picture.
  Slice slice;
};

/// \throws std::invalid_argument naming the flag, what was expected and what was found.
Level parse_precision(const std::string& text);
/// "640x480"
void parse_size(const std::string& text, Slice& slice);

}  // namespace sightline::noise_tool
