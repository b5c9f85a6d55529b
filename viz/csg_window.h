#pragma once

#include "viz/csg_picture.h"

namespace sightline::viz {

/// Shows the picture in a window until it is closed. A click on the solid chooses the ray through it and prints its
/// table; R brings back the first one, Q closes. Needs a display (see has_display).
void open_csg_window(const CsgPicture& first);

}  // namespace sightline::viz
