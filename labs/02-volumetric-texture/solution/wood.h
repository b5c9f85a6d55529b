#pragma once
/// Lab 02: wood, a color for every point of space.

#include "sightline/math/vec.h"

namespace student {

using namespace sightline;

/// How the rings lie.
struct Wood {
  double texture_frequency = 1;  ///< At distance d from the y axis lies ring (texture_frequency d)^2.
  double noise_frequency = 1;    ///< Scales points before noise is asked for: how many bumps a ring has.
  double noise_amplitude = 1;    ///< How many rings noise of 1 moves a point by.
};

/// The number of the ring at p, without noise: the square of texture_frequency times the distance to the y axis.
inline double ring_number(const Wood& wood, const Vec3d& p) {
  // lab:hole ring_number | 1. Rings around an axis
  const double x = wood.texture_frequency * p.x, z = wood.texture_frequency * p.z;
  return x * x + z * z;
  // lab:end
}

/// What is left of x after the next whole number below: 0 <= f < 1, for negative x too.
inline double fraction(double x) {
  // lab:hole fraction | 2. Where a ring begins
  return x - std::floor(x);
  // lab:end
}

/// Where noise is asked for.
inline Vec3d noise_point(const Wood& wood, const Vec3d& p) {
  // lab:hole noise_point | 3. Noise moves the rings
  return wood.noise_frequency * p;
  // lab:end
}

/// From 0, early wood, to 1, late wood: where p lies within its ring. `noise` is the noise at noise_point().
inline double grain(const Wood& wood, const Vec3d& p, double noise) {
  // lab:hole grain | 3. Noise moves the rings
  return fraction(ring_number(wood, p) + wood.noise_amplitude * noise);
  // lab:end
}

/// early where grain is 0, late where it is 1, in proportion between.
inline Vec3d color(const Vec3d& early, const Vec3d& late, double grain) {
  // lab:hole color | 4. Colors
  return early + grain * (late - early);
  // lab:end
}

}  // namespace student
