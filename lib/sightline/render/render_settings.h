#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sightline/math/level.h"
#include "sightline/query/tracer.h"

namespace sightline {

/// How a picture is taken of a scene. All but `threads`, `samples` and `error_bound` change the colors of samples;
/// these two change how many there are of a pixel.
struct RenderSettings {
  int width = 640, height = 480;
  std::uint32_t samples = 0;      ///< The most of a pixel; 0: as many as the scene says.
  double error_bound = 0;         ///< Of a pixel's luminance, as its standard error; 0: every pixel gets all samples.
  std::optional<int> depth;       ///< Of reflections and refractions, one after the other; none: as the scene says.
  std::optional<double> cut_off;  ///< What could add less than this to a pixel is not traced (Hall); 0: all is.
  std::optional<double> shadow_error;  ///< That rays to area lamps which are not sent may add to a pixel's luminance,
                                       ///< as its standard error (shadow_choice.h); 0: all are sent; none: as the scene
                                       ///< says.
  std::uint32_t light_samples =
      0;                         ///< Of an area light at each surface; 0: 16 in all for pixels of few samples, else 1.
  bool filters_textures = true;  ///< As wide as a pixel; without, textures are what they are at a point.
  std::uint64_t seed = 0;        ///< Of all that is chosen by chance.
  Level level = Level::watertight;
  std::string accelerator;                      ///< Of the registry; empty: wide-tree over triangles, bih over solids.
  std::vector<TracerSettings::Option> options;  ///< Of the structure.
  std::uint64_t flatten_up_to = std::uint64_t{1} << 21;  ///< Triangles that are put into one mesh, for speed.
  std::string camera;                                    ///< By its name; empty: the scene's first one.
  double time = 0;                                       ///< Of the scene's animations, in seconds.
  bool knows_all = false;  ///< Runs the integrator that knows every effect, for comparison.
  int threads = 0;         ///< 0: as many as there are.
};

}  // namespace sightline
