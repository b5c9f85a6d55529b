#pragma once
/// Noise libraries beside which ours is measured. A machine may be without them.

#include <span>
#include <string_view>

namespace sightline::bench {

/// One call for each point, as their users would.
struct NoisePeer {
  std::string_view name;
  std::string_view description;
  std::string_view package;  ///< Of Debian, that a build needs to have it.
  /// Perlin noise at `count` points, given axis by axis; null when this build is without the library.
  void (*values)(const double* const* points, std::size_t count, double* values);
};

/// All that there are; the first is what ratios refer to.
std::span<const NoisePeer> noise_peers();

void libnoise_values(const double* const* points, std::size_t count, double* values);
void stb_perlin_values(const double* const* points, std::size_t count, double* values);

}  // namespace sightline::bench
