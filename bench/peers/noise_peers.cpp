#include "bench/peers/noise_peers.h"

#include <array>

namespace sightline::bench {
namespace {

using Values = decltype(NoisePeer::values);

constexpr Values libnoise() {
  if constexpr (SIGHTLINE_BENCH_HAS_LIBNOISE) {
    return libnoise_values;
  } else {
    return nullptr;
  }
}

constexpr Values stb_perlin() {
  if constexpr (SIGHTLINE_BENCH_HAS_STB_PERLIN) {
    return stb_perlin_values;
  } else {
    return nullptr;
  }
}

constexpr auto infos = std::to_array<NoisePeer>({
    {"libnoise", "GradientCoherentNoise3D, QUALITY_STD (cubic), double", "libnoise-dev", libnoise()},
    {"stb_perlin", "stb_perlin_noise3, improved noise in float", "libstb-dev", stb_perlin()},
});

}  // namespace

std::span<const NoisePeer> noise_peers() { return infos; }

}  // namespace sightline::bench
