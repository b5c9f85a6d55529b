#pragma once
/// What holds a thing, in three kinds: the simpler the faster asked, the closer the fewer asked in vain.

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

#include "sightline/math/aabb.h"
#include "sightline/math/volumes.h"

namespace sightline {

enum class BoundKind { box, sphere, cylinder };
inline constexpr std::array bound_kinds{BoundKind::box, BoundKind::sphere, BoundKind::cylinder};

constexpr std::string_view name_of(BoundKind kind) {
  return kind == BoundKind::box ? "box" : kind == BoundKind::sphere ? "sphere" : "cylinder";
}

template <class V>
inline constexpr BoundKind kind_of = BoundKind::box;
template <>
inline constexpr BoundKind kind_of<Sphere> = BoundKind::sphere;
template <>
inline constexpr BoundKind kind_of<Cylinder> = BoundKind::cylinder;

/// A box, a ball and a cylinder, each of which holds the same thing.
///   E1  Of nothing the box is empty and radii are negative; so it is by default.
///   E2  Of what has no bounds, or leaves the range of float, box and radii are infinite.
///   E3  A point p of the cylinder has |(p - center) . axis| <= half_length and lies within `radius` of the line of the
///       axis, normalized.
struct Enclosure {
  Aabb box;
  Sphere sphere{Vec3f(0), -1};
  Cylinder cylinder{Vec3f(0), Vec3f(0, 0, 1), -1, -1};

  template <class V>
  const V& get() const;
  template <class V>
  V& get() {
    return const_cast<V&>(static_cast<const Enclosure&>(*this).get<V>());
  }
};

template <>
inline const Aabb& Enclosure::get<Aabb>() const {
  return box;
}
template <>
inline const Sphere& Enclosure::get<Sphere>() const {
  return sphere;
}
template <>
inline const Cylinder& Enclosure::get<Cylinder>() const {
  return cylinder;
}

/// Calls use(volume) of the kind, where `volume` is an object of its type that says nothing more.
template <class Use>
decltype(auto) with_kind(BoundKind kind, Use&& use) {
  if (kind == BoundKind::sphere) return use(Sphere());
  if (kind == BoundKind::cylinder) return use(Cylinder());
  return use(Aabb());
}

// ---- E1 and E2

inline bool is_nothing(const Aabb& box) { return box.is_empty(); }
inline bool is_nothing(const Sphere& sphere) { return sphere.radius < 0; }
inline bool is_nothing(const Cylinder& cylinder) { return cylinder.radius < 0; }

/// Of a box, whether any side is infinite: its middle is no number then.
inline bool is_unbounded(const Aabb& box) {
  return !is_nothing(box) && !(std::isfinite(max_norm(box.lo)) && std::isfinite(max_norm(box.hi)));
}
inline bool is_unbounded(const Sphere& sphere) { return std::isinf(sphere.radius); }
inline bool is_unbounded(const Cylinder& cylinder) { return std::isinf(cylinder.radius); }

template <class V>
V everything();
template <>
inline Aabb everything<Aabb>() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  return {Vec3f(-infinity), Vec3f(infinity)};
}
template <>
inline Sphere everything<Sphere>() {
  return {Vec3f(0), std::numeric_limits<float>::infinity()};
}
template <>
inline Cylinder everything<Cylinder>() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  return {Vec3f(0), Vec3f(0, 0, 1), infinity, infinity};
}

// ---- Measures

/// For ratios of tightness; 0 of nothing.
double volume_of(const Aabb& box);
double volume_of(const Sphere& sphere);
double volume_of(const Cylinder& cylinder);

/// Of two that hold a thing, the one of less surface, which fewer rays meet.
Sphere closer_of(const Sphere& a, const Sphere& b);
Cylinder closer_of(const Cylinder& a, const Cylinder& b);

// ---- Making

/// Around points in whose convex hull the thing lies; finite ones.
Enclosure enclosure_of(std::span<const Vec3f> points);
/// Around the points of a box.
Enclosure enclosure_of(const Aabb& box);

/// The smallest ball and the smallest of the cylinders along the axes around a box.
Sphere ball_around(const Aabb& box);
Cylinder cylinder_around(const Aabb& box);

/// Around volumes of the same kind. Those of nothing do not count. A box is the smallest one; balls and cylinders are
/// near it, and one volume alone is held exactly.
Aabb around(std::span<const Aabb> boxes);
Sphere around(std::span<const Sphere> spheres);
Cylinder around(std::span<const Cylinder> cylinders);

}  // namespace sightline
