#pragma once
/// Spheres as a first lesson has them, for cases that show what becomes of it.

#include <cmath>
#include <optional>
#include <vector>

#include "sightline/math/ray.h"
#include "sightline/math/volumes.h"

namespace sightline::hard {

/// The roots of |o + t d - c|^2 = r^2 by the formula from school, in T throughout.
template <class T>
std::vector<double> naive_sphere_roots(const Vec3<T>& center, T radius, const Ray<T>& ray) {
  const Vec3<T> away = ray.origin - center;
  const T a = glm::dot(ray.direction, ray.direction), b = 2 * glm::dot(away, ray.direction);
  const T c = glm::dot(away, away) - radius * radius;
  const T discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 0)) return {};
  const T root = std::sqrt(discriminant);
  return {double((-b - root) / (2 * a)), double((-b + root) / (2 * a))};
}

/// The first one ahead.
inline std::optional<double> first_root_ahead(const std::vector<double>& roots) {
  for (const double t : roots) {
    if (t > 0) return t;
  }
  return std::nullopt;
}

inline Ray<float> ray_in_float(const Ray<double>& ray) { return {Vec3f(ray.origin), Vec3f(ray.direction)}; }
/// With numbers that are floats.
inline Ray<double> ray_of_floats(const Vec3d& origin, const Vec3d& direction) {
  return {Vec3d(Vec3f(origin)), Vec3d(Vec3f(direction))};
}

}  // namespace sightline::hard
