#pragma once
/// Random points, and texts of questions.

#include <cmath>
#include <cstdio>
#include <string>

#include "sightline/math/random.h"
#include "sightline/math/ray.h"

namespace sightline::hard {

/// In a cube from -1 to 1.
inline Vec3d any_point(Random& random) {
  const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
  return 2.0 * Vec3d(x, y, z) - 1.0;
}

inline Vec3d any_direction(Random& random) {
  for (;;) {
    const Vec3d p = any_point(random);
    const double length2 = glm::dot(p, p);
    if (length2 > 0.01 && length2 <= 1) return p / std::sqrt(length2);
  }
}

/// Three unit vectors at right angles, but for rounding.
struct AnyFrame {
  explicit AnyFrame(Random& random) : x(any_direction(random)) {
    do y = glm::cross(x, any_direction(random));
    while (glm::length(y) < 0.1);
    y = glm::normalize(y);
    z = glm::cross(x, y);
  }
  Vec3d x, y, z;
};

/// All numbers as hexadecimal floats.
template <class T>
std::string text_of(const Ray<T>& ray) {
  char text[192];
  const Vec3d o(ray.origin), d(ray.direction);
  std::snprintf(text, sizeof text, "ray from %a %a %a towards %a %a %a", o.x, o.y, o.z, d.x, d.y, d.z);
  return text;
}

inline std::string text_of_number(double x) {
  char text[64];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

/// The same as floats have it, which is what code in float is asked.
inline Ray<float> to_float(const Ray<double>& ray) { return {Vec3f(ray.origin), Vec3f(ray.direction)}; }

}  // namespace sightline::hard
