#include <libnoise/noise.h>

#include "bench/peers/noise_peers.h"

namespace sightline::bench {

void libnoise_values(const double* const* points, std::size_t count, double* values) {
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = noise::GradientCoherentNoise3D(points[0][i], points[1][i], points[2][i], 0, noise::QUALITY_STD);
  }
}

}  // namespace sightline::bench
