#pragma once

#include "sightline/math/vec.h"

namespace sightline {

/// Red, green and blue, linear: 0 is black, 1 is white.
using Color = Vec3f;

/// The first color where `share` is 0, the second where it is 1, exactly.
inline Color mix(const Color& first, const Color& second, double share) {
  return static_cast<float>(1 - share) * first + static_cast<float>(share) * second;
}

}  // namespace sightline
