#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "sightline/math/aabb.h"
#include "sightline/math/rounding.h"

namespace sightline {

/// Layers of cells along each axis, at least one, so that there are about `cells` of them and each is as near to a cube
/// as can be: in proportion to the extents. An axis along which the bounds are flat, or too thin for a whole layer, has
/// one; what one axis cannot take goes to the others.
///   R1  The product is at most `cells` (or 1), and at most 2^28.
///   R2  A layer is at least twice as thick as the widest spacing of floats within the bounds on its axis, so
///       that primitives can lie in one and not in the next.
/// Ize, Shirley and Parker, "Grid creation strategies for efficient ray tracing", 2007.
inline std::array<int, 3> grid_resolution(const Aabb& bounds, double cells) {
  constexpr double most_cells = 0x1p28;
  cells = std::clamp(cells, 1.0, most_cells);
  const Vec3d extent = Vec3d(bounds.hi) - Vec3d(bounds.lo);
  const auto most_layers = [&](int axis) {
    const float farthest = std::fmax(std::fabs(bounds.lo[axis]), std::fabs(bounds.hi[axis]));
    const double spacing = double(farthest) - double(next_down(farthest));
    return std::clamp(extent[axis] / (2 * spacing), 1.0, most_cells);
  };

  std::array<int, 3> layers{1, 1, 1};
  std::array<bool, 3> is_open;
  for (int axis = 0; axis < 3; ++axis) is_open[axis] = extent[axis] > 0;
  // Each round settles the axis that departs most from what it would have, or ends.
  for (;;) {
    double volume = 1;
    int open = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (is_open[axis]) volume *= extent[axis], ++open;
    }
    if (open == 0) return layers;
    const double layers_per_unit = std::pow(cells / volume, 1.0 / open);
    int strictest = -1;
    double strictest_ratio = 1;
    for (int axis = 0; axis < 3; ++axis) {
      if (!is_open[axis]) continue;
      const double wanted = extent[axis] * layers_per_unit, allowed = std::clamp(wanted, 1.0, most_layers(axis));
      const double ratio = std::max(allowed / wanted, wanted / allowed);
      layers[axis] = static_cast<int>(std::min(allowed, cells));  // R1, where all others are thinner than a layer
      if (ratio > strictest_ratio) strictest = axis, strictest_ratio = ratio;
    }
    if (strictest < 0) return layers;
    is_open[strictest] = false;
    cells = std::max(1.0, cells / layers[strictest]);
  }
}

}  // namespace sightline
