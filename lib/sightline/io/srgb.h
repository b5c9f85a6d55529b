#pragma once

#include <algorithm>
#include <cmath>

namespace sightline {

/// What light an sRGB-encoded component stands for, and back (IEC 61966-2-1). Encoding holds it within [0, 1]; NaN
/// becomes black.
inline float decode_srgb(float x) { return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f); }

inline float encode_srgb(float linear) {
  const float x = linear > 0 ? std::min(linear, 1.0f) : 0.0f;
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

}  // namespace sightline
