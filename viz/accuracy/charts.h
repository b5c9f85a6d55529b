#pragma once

#include <string>

#include "bench/accuracy/run.h"

namespace sightline::viz {

/// A chart of each panel: errors to the right, nanoseconds upward, both on scales of logarithms; the front as a line.
/// Writes AXIS-N.png and AXIS-N.svg into the folder, which is made where it is missing. \throws std::runtime_error
void draw_accuracy_charts(const bench::AccuracyReport& report, const std::string& folder);

}  // namespace sightline::viz
