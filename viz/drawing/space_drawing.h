#pragma once
/// Things in space as flat shapes, those behind first.

#include "viz/drawing/drawing.h"
#include "viz/noise/panel.h"

namespace sightline::viz {

/// The color of a role (Okabe and Ito), the same in all panels.
Rgb color_of(Role role);
/// "expected", "overlooked": as legends have it.
const char* name_of(Role role);

/// False where something was not finite, and left out.
bool draw_space(Canvas& canvas, const PanelFrame& frame, const SpacePanel& panel);

}  // namespace sightline::viz
