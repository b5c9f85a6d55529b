#pragma once

#include <array>

#include "sightline/math/vec.h"

namespace sightline::solid {

/// A triangle of a solid's surface, counter-clockwise as seen from outside.
struct Facet {
  std::array<Vec3d, 3> vertices;

  friend bool operator==(const Facet&, const Facet&) = default;
};

}  // namespace sightline::solid
