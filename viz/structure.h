#pragma once
/// What the drawing programs ask of a structure besides its cells.

#include <string>

#include "viz/partition_picture.h"

namespace sightline::viz {

/// Refuses an unknown structure or option before any scene is read. \throws std::invalid_argument
void check_structure(const std::string& name, const TracerSettings& settings);

/// Casts a coarse picture's rays, so that a lazily built structure has the cells that looking at the scene asks for.
void wake_lazy_cells(const Tracer& tracer);

/// Chooses what reads well where nothing was asked for: a flat structure of many cells (a grid) is cut in the middle.
void suit_filter(const Tracer& tracer, CellFilter& filter);

Caption caption_of(const Tracer& tracer, const std::string& scene);

}  // namespace sightline::viz
