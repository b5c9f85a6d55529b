#pragma once
/// Solids to trace, written down once for every program that traces them.

#include <string>
#include <string_view>
#include <vector>

#include "sightline/csg/solid_tree.h"
#include "sightline/scene/camera.h"

namespace sightline::bench {

/// Positions and sizes are dyadic, with few digits: decimal text has them exactly.
struct SolidScene {
  std::string name;
  std::string description;
  std::vector<SolidTree> solids;  ///< Each one primitive of an accelerator.
  Camera camera;
  Vec3d light{0};  ///< A point.
};

/// box & sphere - (cylinder | cylinder | cylinder), around `center`.
SolidTree widget(const Vec3d& center, double half_side);

/// A widget, 64 widgets, and box - N spheres for N = 1, 4, 16, 64, 256, in this order.
std::vector<SolidScene> solid_scenes(int width, int height);

/// Spheres that are taken from the box: 0 where the scene is none of that family.
int holes_of(std::string_view scene);

}  // namespace sightline::bench
