#pragma once

#include "viz/partition_picture.h"

namespace sightline::viz {

/// Shows the picture in a window until it is closed. Drag to turn, wheel to come closer; Up and Down change the deepest
/// depth, Left and Right move the slice, L toggles leaves only, Q closes. Needs a display (see has_display).
void open_partition_window(const Tracer& tracer, CellFilter filter, const PartitionPicture& first);

}  // namespace sightline::viz
