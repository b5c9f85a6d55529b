#include "sightline/texture/texture_noise.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "sightline/math/random.h"

namespace sightline {

TextureNoise::TextureNoise(const FieldOptions& options) : field_(options) {
  FieldOptions one_octave = options;
  one_octave.octaves = 1;
  one_octave.frequency = 1;
  one_octave.warp = 0;
  const NoiseField octave(one_octave);
  constexpr int count = 1 << 12;
  std::vector<glm::dvec3> points(count);
  Random random(1);
  for (auto& p : points) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = 4096 * random.uniform_double();
  }
  std::vector<double> values(count);
  octave.values<3, double>(points, values);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double octave_mean = octave(Vec3d(0), infinity);  // where all has given way to it
  double squares = 0;
  for (const double n : values) squares += (n - octave_mean) * (n - octave_mean);
  mean_ = field_(Vec3d(0), infinity);
  octave_deviation_ = std::sqrt(squares / count);
  whole_amplitude_ = field_.lost_amplitude(infinity);
}

double share_above(double threshold, double mean, double deviation) {
  if (!(deviation > 0)) return mean >= threshold ? 1 : 0;
  return 0.5 * std::erfc((threshold - mean) / (deviation * std::numbers::sqrt2));
}

double threshold_for(double share) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(share > 0)) return infinity;
  if (share >= 1) return -infinity;
  // Bisection: asked once a texture. Beyond 40 deviations there is nothing that a double could tell from 0 or 1.
  double low = -40, high = 40;
  for (int i = 0; i < 64; ++i) {
    const double middle = 0.5 * (low + high);
    (share_above(middle, 0, 1) > share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace sightline
