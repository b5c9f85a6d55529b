#include "viz/texture/block_picture.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace sightline::viz {
namespace {

const double cos30 = std::sqrt(0.75);

/// What a pixel sees of the block, in sides of the block.
struct Seen {
  Vec3d position;      ///< 0 to 1 along each axis.
  Vec3d right, below;  ///< What the position moves by with a step of the picture.
  double light;
};

/// Of a place in the picture, from the corner that is highest up: x to the right, y down, in sides.
std::optional<Seen> look(double x, double y) {
  const auto is_within = [](double a) { return a >= 0 && a <= 1; };
  const double a = y + x / (2 * cos30), b = y - x / (2 * cos30);
  if (is_within(a) && is_within(b)) return Seen{{a, 1, b}, {1 / (2 * cos30), 0, -1 / (2 * cos30)}, {1, 0, 1}, 1};
  if (x <= 0) {
    const double across = x / cos30 + 1, down = y - 0.5 - across / 2;
    if (!is_within(across) || !is_within(down)) return std::nullopt;
    return Seen{{across, 1 - down, 1}, {1 / cos30, 1 / (2 * cos30), 0}, {0, -1, 0}, 0.62};
  }
  const double across = 1 - x / cos30, down = y - 0.5 - across / 2;
  if (!is_within(across) || !is_within(down)) return std::nullopt;
  return Seen{{1, 1 - down, across}, {0, -1 / (2 * cos30), -1 / cos30}, {0, -1, 0}, 0.8};
}

void put(ColorGrid& grid, int x, int y, const Color& color, double light) {
  for (int channel = 0; channel < 3; ++channel) {
    const double shown = srgb_from_linear(light * color[channel]);
    grid.bytes[(static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(x)) * 3 +
               static_cast<std::size_t>(channel)] = static_cast<std::uint8_t>(std::lround(255 * shown));
  }
}

ColorGrid white(int width, int height) {
  ColorGrid grid{width, height, {}};
  grid.bytes.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3, 255);
  return grid;
}

}  // namespace

ColorGrid block_picture(const SolidColor& color, const Vec3d& lowest, double side, int width, int height) {
  ColorGrid grid = white(width, height);
  const double pixels = std::min(width / (2 * cos30), height / 2.0) * 0.98;  // a side's
  tbb::parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const auto seen = look((x + 0.5 - width / 2.0) / pixels, (y + 0.5 - height / 2.0) / pixels + 1);
      if (!seen) continue;
      const double step = side / pixels;
      put(grid, x, y, color(lowest + side * seen->position, Footprint(step * seen->right, step * seen->below)),
          seen->light);
    }
  });
  return grid;
}

ColorGrid section_picture(const SolidColor& color, const Vec3d& lowest, double side, int size) {
  ColorGrid grid = white(size, size);
  const double step = side / size;
  const Footprint footprint({step, 0, 0}, {0, 0, step});
  tbb::parallel_for(0, size, [&](int y) {
    for (int x = 0; x < size; ++x) {
      put(grid, x, y, color(lowest + Vec3d((x + 0.5) * step, 0, (y + 0.5) * step), footprint), 1);
    }
  });
  return grid;
}

}  // namespace sightline::viz
