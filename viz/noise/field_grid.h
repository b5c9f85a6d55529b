#pragma once
/// Noise on grids, as pictures need it.

#include <cstddef>
#include <vector>

#include "sightline/noise/noise_field.h"

namespace sightline::viz {

/// Samples on a square of the plane z = `z`, cell-centered, row by row from y = y_min.
struct FieldSlice {
  int size = 0;  ///< Samples along each side.
  double x_min = 0, y_min = 0, extent = 1, z = 0;
  std::vector<float> values;

  double step() const { return extent / size; }
  float at(int x, int y) const { return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + x]; }
};

FieldSlice slice_of(const NoiseField& field, int size, double x_min, double y_min, double extent, double z);

/// Samples at the nodes of a cube's grid, x fastest, from the origin.
struct FieldCube {
  int size = 0;
  double extent = 1;
  std::vector<float> values;
};

FieldCube cube_of(const NoiseField& field, int size, double extent, double z);

/// The largest size among finite values, or 1 where all are 0.
float largest_size(const std::vector<float>& values);

}  // namespace sightline::viz
