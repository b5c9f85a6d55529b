#define STB_PERLIN_IMPLEMENTATION
#include <stb/stb_perlin.h>

#include "bench/peers/noise_peers.h"

namespace sightline::bench {

void stb_perlin_values(const double* const* points, std::size_t count, double* values) {
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = static_cast<double>(stb_perlin_noise3(
        static_cast<float>(points[0][i]), static_cast<float>(points[1][i]), static_cast<float>(points[2][i]), 0, 0, 0));
  }
}

}  // namespace sightline::bench
