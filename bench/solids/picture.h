#pragma once

#include <cstddef>
#include <vector>

namespace sightline::bench {

/// What a program saw, row by row from the top: linear brightness, 0 where a ray meets nothing.
struct Picture {
  int width = 0, height = 0;
  std::vector<float> shades;

  Picture() = default;
  Picture(int w, int h) : width(w), height(h), shades(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

  std::size_t size() const { return shades.size(); }
};

/// Of all surfaces in all programs: `ambient` where the light does not reach, and `diffuse` times the cosine more where
/// it does.
inline constexpr double ambient = 0.125, diffuse = 0.875;

}  // namespace sightline::bench
