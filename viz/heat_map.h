#pragma once

#include <cstdint>
#include <span>

#include "sightline/io/image_file.h"
#include "viz/color_ramp.h"

namespace sightline::viz {

/// Work per pixel as color, on a logarithmic scale from 1 to `highest` steps, with its legend below. Less than one step
/// is black. Pictures that are to be compared take the same `highest`.
Image heat_map(std::span<const std::uint32_t> work, int width, int height, double highest);

/// The color of this much work on that scale, as screens take it, and where it lies along it: from 0 to 1.
Rgb heat_color(double work, double highest);
double heat_share(double work, double highest);

/// The work that all but one pixel in a thousand stay below; at least 10.
double scale_for(std::span<const std::uint32_t> work);

}  // namespace sightline::viz
