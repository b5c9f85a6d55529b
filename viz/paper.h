#pragma once

#include "viz/color_ramp.h"

namespace sightline::viz {

/// What diagrams are drawn with on white.
inline constexpr Rgb ink{0.12, 0.14, 0.19}, soft_ink{0.42, 0.45, 0.52}, faint_ink{0.72, 0.74, 0.79},
    band{0.957, 0.963, 0.975}, accent{0.85, 0.04, 0.42};

}  // namespace sightline::viz
