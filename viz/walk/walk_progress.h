#pragma once
/// The parts of a walk's picture that tell how far it has come.

#include "viz/canvas.h"
#include "viz/walk/walk_model.h"

namespace sightline::viz {

inline constexpr double small = 18, medium = 20, large = 28;  ///< Letters.

/// The step in words, counters so far, the nearest hit and what is put aside.
void draw_facts(Canvas& canvas, const WalkLayout& layout, const WalkModel& model, std::size_t step);

/// All steps: their depth, and below it t and the far limit.
void draw_timeline(Canvas& canvas, const WalkLayout& layout, const WalkModel& model, std::size_t step);

}  // namespace sightline::viz
