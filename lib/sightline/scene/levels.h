#pragma once

#include "sightline/scene/scene.h"

namespace sightline {

/// renderLevel, by which courses explain hierarchical modelling: a sphere of radius 1/2, and then, at 0.75 of the size,
/// the same again at (1, -0.75, 0) and at (-1, -0.75, 0), each turned about y by `degrees`; `levels` times, so that
/// what is below a sphere moves with it. 2^levels - 1 spheres. `levels` is at least 1.
Scene make_levels(int levels, double degrees = 0);

/// What make_levels makes, turned otherwise.
void turn_levels(Scene& scene, double degrees);

}  // namespace sightline
