#pragma once
/// Rays and hits, in float and in double.

#include <cstdint>
#include <limits>

#include "sightline/math/vec.h"

namespace sightline {

/// The half-line origin + t * direction. The direction need not be normalized: t is in units of it. Hits are reported
/// for t_min < t <= t_max, so a ray that starts exactly on a surface does not find that surface again.
template <class T>
struct Ray {
  Vec3<T> origin{0};
  Vec3<T> direction{0, 0, 1};
  T t_min = 0;
  T t_max = std::numeric_limits<T>::infinity();

  Vec3<T> at(T t) const { return origin + t * direction; }
};

/// Lengths of double directions that are traced: squares and products with coordinates stay within double. All float
/// directions are.
inline constexpr double shortest_direction = 0x1p-500;
inline constexpr double longest_direction = 0x1p+500;

/// False for rays that hit nothing by definition: a NaN or infinite component, no direction or one out of the limits
/// above, or an empty parameter range.
template <class T>
bool is_valid(const Ray<T>& ray) {
  if (!is_finite(ray.origin) || !is_finite(ray.direction)) return false;
  const double size = max_norm(ray.direction);
  return size >= shortest_direction && size <= longest_direction && ray.t_min <= ray.t_max;
}

/// Exact for float rays.
template <class T>
Ray<double> to_double(const Ray<T>& ray) {
  return {Vec3d(ray.origin), Vec3d(ray.direction), ray.t_min, ray.t_max};
}

inline constexpr std::uint32_t no_primitive = 0xffff'ffff;

/// The nearest crossing of a ray with a primitive; a miss when prim_id is no_primitive.
/// u and v are the primitive's own surface coordinates (for a triangle the weights of its second and third vertex).
template <class T>
struct Hit {
  T t = std::numeric_limits<T>::infinity();
  std::uint32_t prim_id = no_primitive;
  T u = 0;
  T v = 0;

  bool is_hit() const { return prim_id != no_primitive; }
  friend bool operator==(const Hit&, const Hit&) = default;
};

/// The order all structures share: nearer first, the lower id where distances are equal.
template <class T>
bool is_closer(const Hit<T>& a, const Hit<T>& b) {
  return a.t < b.t || (a.t == b.t && a.prim_id < b.prim_id);
}

}  // namespace sightline
