#pragma once

#include <algorithm>
#include <cmath>

#include "sightline/math/vec.h"

namespace sightline {

/// How much of a texture's space one value stands for: say, a pixel's part of a surface. Zero asks for the point alone.
struct Footprint {
  Vec3d extent{0};   ///< Of the smallest box with edges along the axes that holds it.
  double width = 0;  ///< Its largest diameter, for what has no axes.

  Footprint() = default;

  /// The same to all sides.
  explicit Footprint(double diameter) : extent(std::fabs(diameter)), width(std::fabs(diameter)) {}

  /// A parallelogram, by what a point moves from a pixel to the next to the right and to the next below.
  /// Igehy, "Tracing Ray Differentials", 1999.
  Footprint(const Vec3d& right, const Vec3d& below)
      : extent(glm::abs(right) + glm::abs(below)),
        width(std::max(glm::length(right + below), glm::length(right - below))) {}
};

}  // namespace sightline
