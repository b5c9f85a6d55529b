#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sightline/math/level.h"
#include "sightline/query/tracer.h"

namespace sightline {

/// How a picture is taken of a scene. All but `threads`, `samples` and `error_bound` change the colors of samples;
/// these two change how many there are of a pixel.
struct RenderSettings {
  int width = 640, height = 480;
  std::uint32_t samples = 0;   ///< The most of a pixel; 0: as many as the scene says.
  double error_bound = 0;      ///< Of a pixel's luminance, as its standard error; 0: every pixel gets all samples.
  int depth = 8;               ///< Of reflections and refractions, one after the other.
  double cut_off = 1.0 / 512;  ///< What could add less than this to a pixel is not traced (Hall); 0: all is.
  std::uint64_t seed = 0;      ///< Of all that is chosen by chance.
  Level level = Level::watertight;
  std::string accelerator = "bih";
  std::vector<TracerSettings::Option> options;  ///< Of the structure.
  std::string camera;                           ///< By its name; empty: the scene's first one.
  double time = 0;                              ///< Of the scene's animations, in seconds.
  int threads = 0;                              ///< 0: as many as there are.
};

}  // namespace sightline
