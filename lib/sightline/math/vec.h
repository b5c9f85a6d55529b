#pragma once
/// Three-component vectors: GLM's, under the names the library uses.

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

namespace sightline {

template <class T>
using Vec3 = glm::vec<3, T, glm::defaultp>;
using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

template <class T>
bool is_finite(const Vec3<T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Largest absolute component (the maximum norm); of components that are no numbers any other, or NaN. No std::fmax:
/// compilers call a function for what it does about NaN.
template <class T>
T max_norm(const Vec3<T>& v) {
  const T x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
  const T xy = x > y ? x : y;
  return xy > z ? xy : z;
}

/// The axis of the largest component; of equal ones the first. Without branches, which rays would mispredict.
template <class T>
int largest_axis(const Vec3<T>& v) {
  const int is_y = v.y > v.x, is_z = v.z > (v.x < v.y ? v.y : v.x);
  return 2 * is_z | (is_y & ~is_z);
}

}  // namespace sightline
