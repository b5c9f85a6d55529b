#pragma once
/// What the drawing programs ask of a structure besides its cells.

#include <string>

#include "viz/partition_picture.h"

namespace sightline::viz {

/// A lazy structure gets the cells that looking at the scene asks for: those of a coarse picture's rays.
void wake_lazy_cells(const Tracer& tracer);

/// Chooses what reads well where nothing was asked for: a structure that falls into many cells at
/// once (a grid) is cut in the middle.
void suit_filter(const Tracer& tracer, CellFilter& filter);

Caption caption_of(const Tracer& tracer, const std::string& scene);

}  // namespace sightline::viz
