#pragma once

#include <cstdint>
#include <string_view>

#include "viz/color_ramp.h"

namespace sightline::viz {

/// The color of a material by its name. Names that are not known have one of their own, always the same; a primitive
/// without a material has one by its number.
Rgb material_color(std::string_view name, std::uint32_t primitive);

/// A color on white paper, 1 as it is and 0 white.
Rgb diluted(const Rgb& color, double share);

}  // namespace sightline::viz
