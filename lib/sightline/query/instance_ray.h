#pragma once
/// Rays of the world as the structure of an instance's mesh sees them.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "sightline/accel/padded_ray.h"
#include "sightline/math/rounding.h"
#include "sightline/shape/instances.h"

namespace sightline {

/// A ray in the coordinates of a mesh, only to be culled with: triangles are tested where they stand in the world.
///   L1  Whatever the world's test reports at t, the mesh has a point within margin / 2 * reach, on every axis, of this
///       ray at the parameter that stands for t: margin M1 (padded_ray.h) holds.
///   L2  For that the ray begins near the mesh, but so far from it that reach covers what may be off: before it come no
///       hits.
///   L3  Its parameter is a multiple of the world's, less a constant: limits are rounded outward.
/// What may be off, in the mesh's units, with B the inverse of the placement's linear part, |.| the largest sum of
/// absolute values over its rows, u = 2^-24 or 2^-53 the query's rounding, q from the placement's translation to the
/// ray's origin, V the largest coordinate of the instance and W more than its distance from the origin:
///   |B| rho (q + W)       B, and what is multiplied by it, are off by their share rho: entries of the adjugate are one
///                         rounding of exact products, so that rho grows with the cancellation in the determinant
///                         alone;
///   |B| 2^-24 V           vertices are rounded to float where they stand (I1 of instances.h);
///   |B| (u + 2^-35) W     t is rounded, and T2 of triangle.h;
///   |B| error             what else the caller's test is off by, in the world's units;
///   u (center + 7 reach)  this ray is rounded.
template <class T>
class InstanceRay {
 public:
  InstanceRay(const Ray<T>& world, const Placement& placement, const Aabb& bounds, double error) {
    const Affine map = placement.to_world();
    const Vec3d a = map.column(0), b = map.column(1), c = map.column(2);
    const Vec3d adjugate[3] = {glm::cross(b, c), glm::cross(c, a), glm::cross(a, b)};
    const double determinant = glm::dot(a, adjugate[0]);
    const double cancelled = glm::dot(glm::abs(a), glm::abs(adjugate[0])) / std::fabs(determinant);
    const Vec3d q = Vec3d(world.origin) - map.column(3), direction(world.direction);
    const auto undone = [&](const Vec3d& v) {
      return Vec3d(glm::dot(adjugate[0], v), glm::dot(adjugate[1], v), glm::dot(adjugate[2], v)) / determinant;
    };
    const Vec3d origin = undone(q), way = undone(direction);
    const double shrink = std::max({sum(adjugate[0]), sum(adjugate[1]), sum(adjugate[2])}) / std::fabs(determinant);

    const Vec3d lo(bounds.lo), hi(bounds.hi), center = 0.5 * (lo + hi);
    const double radius = 0.5 * glm::length(hi - lo);
    const double size = std::max(max_norm(lo), max_norm(hi)) *
                        max_norm(glm::abs(a) + glm::abs(b) + glm::abs(c));  // of the linear part's image
    const double far = size + max_norm(q);                                  // W
    const double rho = 0x1p-49 + 0x1p-50 * cancelled;
    const double off = shrink * (rho * (max_norm(q) + far) + 0x1p-23 * (size + max_norm(map.column(3))) +
                                 (unit + 0x1p-35) * far + error + tiny * (1 + max_norm(direction))) +
                       unit * max_norm(center);

    // L2: reach is more than a quarter of this, whatever part of the bounds has triangles.
    const double distance = std::max(2 * radius, 4 * off / spare);
    // A power of two, so that the local direction is from 1 to 2 long along its largest component.
    speed_ = std::bit_cast<double>(std::bit_cast<std::uint64_t>(max_norm(way)) & 0x7ff0'0000'0000'0000u);
    const Vec3d step = way * (1 / speed_);
    start_ = glm::dot(center - origin, step) / glm::dot(step, step) - distance;
    ray_.origin = Vec3<T>(origin + start_ * step);
    ray_.direction = Vec3<T>(step);
    ray_.t_min = std::max(T(0), -limit(-1, world.t_min));
    ray_.t_max = far_limit(world.t_max);
    is_clear_ = cancelled < 0x1p20 && is_finite(ray_.origin) && is_finite(ray_.direction) && std::isfinite(start_);
  }

  /// Otherwise, as where a placement is nearly singular, nothing may be culled.
  bool is_clear() const { return is_clear_; }
  const Ray<T>& ray() const { return ray_; }

  /// Not before the local parameter of t.
  T far_limit(T t) const { return limit(1, t); }

 private:
  static constexpr double unit = std::is_same_v<T, float> ? 0x1p-24 : 0x1p-53;
  /// Half of the margin, less 16 unit that rounding this ray may take.
  static constexpr double spare = std::is_same_v<T, float> ? 0x1p-20 : 0x1p-36;
  /// Twice what a number that underflows is off by: vertices are floats, t is of type T.
  static constexpr double tiny = 0x1p-148;

  static double sum(const Vec3d& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

  /// sign times the local parameter of t, rounded up (L3).
  T limit(double sign, T t) const {
    const double scaled = double(t) * speed_, exact = sign * (scaled - start_);
    const double above = exact + 0x1p-50 * (std::fabs(scaled) + std::fabs(start_));
    if constexpr (std::is_same_v<T, float>) {
      return round_up(above);
    } else {
      return next_up(above);
    }
  }

  Ray<T> ray_;
  double speed_, start_;
  bool is_clear_;
};

}  // namespace sightline
