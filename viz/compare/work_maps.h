#pragma once
/// Work, and differences of work, as pictures with one scale, and the legends of these.

#include <cstdint>
#include <span>

#include "viz/canvas.h"

namespace sightline::viz {

ColorGrid work_map(std::span<const std::uint32_t> work, int width, int height, double highest);
ColorGrid difference_map(std::span<const std::int64_t> differences, int width, int height, double scale);

/// A bar with its numbers below it, in the canvas's units.
struct LegendBar {
  double x, y, width;
};
void draw_work_legend(Canvas& canvas, const LegendBar& bar, double highest);
void draw_difference_legend(Canvas& canvas, const LegendBar& bar, double scale);

}  // namespace sightline::viz
