#include "viz/csg_light.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "viz/material_color.h"

namespace sightline::viz {
namespace {

Vec3d linear_of(const Rgb& color) {
  return {linear_from_srgb(color[0]), linear_from_srgb(color[1]), linear_from_srgb(color[2])};
}

}  // namespace

Vec3d light_of(const LadderSolid& solid, std::uint32_t primitive) {
  return linear_of(material_color(solid.material(primitive), primitive));
}

/// Averages blocks of linear light.
ColorGrid averaged(const std::vector<Vec3f>& light, int width, int height) {
  ColorGrid grid{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  tbb::parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      Vec3d sum(0);
      for (int i = 0; i < side * side; ++i) {
        sum += Vec3d(light[(static_cast<std::size_t>(y) * side + i / side) * width * side + x * side + i % side]);
      }
      for (int c = 0; c < 3; ++c) {
        const double value = srgb_from_linear(sum[c] / (side * side));
        grid.bytes[(static_cast<std::size_t>(y) * width + x) * 3 + c] =
            static_cast<std::uint8_t>(std::lround(255 * value));
      }
    }
  });
  return grid;
}

}  // namespace sightline::viz
