#pragma once
/// Axis-aligned boxes. Held in float; whoever makes one from wider numbers rounds outward.

#include <limits>

#include "sightline/math/vec.h"

namespace sightline {

/// The closed box [lo, hi]; empty (lo > hi) until extended.
struct Aabb {
  Vec3f lo{std::numeric_limits<float>::infinity()};
  Vec3f hi{-std::numeric_limits<float>::infinity()};

  bool is_empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }

  void extend(const Vec3f& p) {
    lo = glm::min(lo, p);
    hi = glm::max(hi, p);
  }
  void extend(const Aabb& box) {
    lo = glm::min(lo, box.lo);
    hi = glm::max(hi, box.hi);
  }

  bool contains(const Aabb& box) const {
    return box.is_empty() || (glm::all(glm::lessThanEqual(lo, box.lo)) && glm::all(glm::lessThanEqual(box.hi, hi)));
  }
  bool contains(const Vec3f& p) const {
    return glm::all(glm::lessThanEqual(lo, p)) && glm::all(glm::lessThanEqual(p, hi));
  }

  Vec3f extent() const { return hi - lo; }
  Vec3f center() const { return 0.5f * lo + 0.5f * hi; }

  int longest_axis() const { return largest_axis(extent()); }

  friend bool operator==(const Aabb&, const Aabb&) = default;
};

/// Largest distance over the axes from `origin` to the faces of `bounds`.
template <class T>
[[gnu::always_inline]] inline T reach_of(const Vec3<T>& origin, const Aabb& bounds) {
  const Vec3<T> to_lo = glm::abs(Vec3<T>(bounds.lo) - origin), to_hi = glm::abs(Vec3<T>(bounds.hi) - origin);
  return max_norm(glm::max(to_lo, to_hi));
}

inline Aabb intersection(const Aabb& a, const Aabb& b) { return {glm::max(a.lo, b.lo), glm::min(a.hi, b.hi)}; }

/// Half of the surface area, the measure of the surface area heuristic; in double because squares of large floats
/// overflow. Zero for an empty box.
inline double half_area(const Aabb& box) {
  if (box.is_empty()) return 0;
  const Vec3d e = Vec3d(box.hi) - Vec3d(box.lo);
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

}  // namespace sightline
