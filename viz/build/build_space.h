#pragma once
/// A node in space: what it holds, which planes were weighed, where it was divided, and what became of it.

#include <vtkRenderer.h>

#include "viz/build/build_picture.h"
#include "viz/color_ramp.h"

namespace sightline::viz {

/// Of triangles: below the plane, above it, on both sides.
inline constexpr Rgb below_color{0.42, 0.72, 0.91}, above_color{0.95, 0.80, 0.35}, both_color{0.42, 0.42, 0.46};

struct SpaceTold {
  std::size_t planes_drawn = 0, planes = 0;
  double cheapest = 0, dearest = 0;  ///< Of the planes drawn.
};
/// Adds the node to the renderer, and aims its camera.
SpaceTold show_space(vtkRenderer& space, const BuildStory& story, const BuildStep& step, const BuildLook& look,
                     double aspect, double scale);

}  // namespace sightline::viz
