#pragma once

#include <functional>

#include "sightline/texture/color.h"
#include "sightline/texture/footprint.h"
#include "viz/canvas.h"

namespace sightline::viz {

/// A color at each place of space, for what one value stands for there.
using SolidColor = std::function<Color(const Vec3d&, const Footprint&)>;

/// A cube cut out of a solid texture, seen from above and in front so that edges along x, y and z are 120 degrees
/// apart: y up, x to the lower right, z to the lower left. White around it. Pixels are filtered by their footprint.
ColorGrid block_picture(const SolidColor& color, const Vec3d& lowest, double side, int width, int height);

/// A square of the plane y = `y`, x to the right and z down.
ColorGrid section_picture(const SolidColor& color, const Vec3d& lowest, double side, int size);

}  // namespace sightline::viz
