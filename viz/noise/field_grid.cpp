#include "viz/noise/field_grid.h"

#include <algorithm>
#include <cmath>

namespace sightline::viz {

FieldSlice slice_of(const NoiseField& field, int size, double x_min, double y_min, double extent, double z) {
  FieldSlice slice{size, x_min, y_min, extent, z, {}};
  std::vector<glm::vec3> points;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      points.emplace_back(x_min + (x + 0.5) * slice.step(), y_min + (y + 0.5) * slice.step(), z);
    }
  }
  slice.values.resize(points.size());
  field.values<3, float>(points, slice.values);
  return slice;
}

FieldCube cube_of(const NoiseField& field, int size, double extent, double z) {
  FieldCube cube{size, extent, {}};
  const double step = extent / (size - 1);
  std::vector<glm::vec3> points;
  for (int k = 0; k < size; ++k) {
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) points.emplace_back(i * step, j * step, z + k * step);
    }
  }
  cube.values.resize(points.size());
  field.values<3, float>(points, cube.values);
  return cube;
}

float largest_size(const std::vector<float>& values) {
  float largest = 0;
  for (const float value : values) {
    if (std::isfinite(value)) largest = std::max(largest, std::fabs(value));
  }
  return largest > 0 ? largest : 1;
}

}  // namespace sightline::viz
