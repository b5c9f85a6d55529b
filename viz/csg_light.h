#pragma once
/// What tracing a solid in space and tracing its section share.

#include <vector>

#include "viz/canvas.h"
#include "viz/csg_ladder.h"

namespace sightline::viz {

inline constexpr int side = 2;  ///< Rays of a pixel, across and down.

/// What a primitive's material sends back, linear.
Vec3d light_of(const LadderSolid& solid, std::uint32_t primitive);

/// Averages linear light, `side` x `side` samples to a pixel.
ColorGrid averaged(const std::vector<Vec3f>& light, int width, int height);

/// run.operator()<level>()
template <class Run>
auto with_level(Level level, Run&& run) {
  switch (level) {
    case Level::fast:
      return run.template operator()<Level::fast>();
    case Level::watertight:
      return run.template operator()<Level::watertight>();
    case Level::precise:
      return run.template operator()<Level::precise>();
    case Level::exact:
      break;
  }
  return run.template operator()<Level::exact>();
}

}  // namespace sightline::viz
