#pragma once

#include <span>
#include <string>

#include "bench/report.h"

namespace sightline::bench {

/// Half of a bar is as long as this; what would be longer ends in an arrow.
inline constexpr int bar_reach = 10;

/// The speed `ratio` on a scale of logarithms, 1 in the middle: "      ####|          " is a quarter. Each mark is a
/// factor of the square root of two. Always 2 * bar_reach + 1 wide; empty but for the middle where the ratio is no
/// positive number.
std::string bar_text(double ratio);

/// A picture of several scenes: each contender's speed on one kind of rays over the reference's, scene beside scene.
/// Empty for fewer than two scenes, or where nothing was timed to compare.
std::string bars_text(std::span<const SceneReport> scenes, const Plan& plan);

}  // namespace sightline::bench
