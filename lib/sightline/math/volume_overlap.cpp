#include "sightline/math/volume_overlap.h"

#include <array>
#include <cmath>
#include <limits>

#include "sightline/math/enclosure.h"

namespace sightline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Each number here is rounded by less than 2^-48 of the distance to the far side.
constexpr double padding = 0x1p-42;

double sum_norm(const Vec3d& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

/// Everywhere where the numbers overflow.
Interval<double> extent(double middle, double reach, double distance) {
  const double half = reach + padding * (distance + reach);
  const Interval<double> found{middle - half, middle + half};
  return found.is_empty() ? Interval<double>{-infinity, infinity} : found;
}

/// How far a cylinder reaches from its center along a direction, both of unit length.
double reach_of(const Cylinder& cylinder, const Vec3d& axis, const Vec3d& normal) {
  return cylinder.half_length * std::fabs(glm::dot(axis, normal)) +
         cylinder.radius * glm::length(glm::cross(axis, normal));
}

Vec3d unit(int axis) {
  Vec3d v(0);
  v[axis] = 1;
  return v;
}

Vec3d axis_of(const Cylinder& cylinder) { return glm::normalize(Vec3d(cylinder.axis)); }

}  // namespace

Interval<double> extent_along(const Aabb& box, const Vec3d& normal, const Vec3d& from) {
  if (is_nothing(box)) return {};
  const Vec3d lo(box.lo), hi(box.hi);
  const Vec3d middle = 0.5 * (lo + hi) - from, half = 0.5 * (hi - lo);
  return extent(glm::dot(normal, middle), glm::dot(glm::abs(normal), half), sum_norm(middle) + sum_norm(half));
}

Interval<double> extent_along(const Sphere& sphere, const Vec3d& normal, const Vec3d& from) {
  if (is_nothing(sphere)) return {};
  const Vec3d middle = Vec3d(sphere.center) - from;
  return extent(glm::dot(normal, middle), sphere.radius, sum_norm(middle));
}

Interval<double> extent_along(const Cylinder& cylinder, const Vec3d& normal, const Vec3d& from) {
  if (is_nothing(cylinder)) return {};
  const Vec3d middle = Vec3d(cylinder.center) - from;
  return extent(glm::dot(normal, middle), reach_of(cylinder, axis_of(cylinder), normal),
                sum_norm(middle) + cylinder.radius + cylinder.half_length);
}

Interval<double> extent_along(const Aabb& box, int axis) { return {box.lo[axis], box.hi[axis]}; }

Interval<double> extent_along(const Sphere& sphere, int axis) { return extent_along(sphere, unit(axis), Vec3d(0)); }

Interval<double> extent_along(const Cylinder& cylinder, int axis) {
  return extent_along(cylinder, unit(axis), Vec3d(0));
}

bool may_overlap(const Aabb& a, const Aabb& b) { return !intersection(a, b).is_empty(); }

bool may_overlap(const Sphere& a, const Sphere& b) {
  if (is_nothing(a) || is_nothing(b)) return false;
  const double distance = glm::length(Vec3d(b.center) - Vec3d(a.center));
  return !(distance > (double(a.radius) + double(b.radius)) * (1 + padding));
}

/// Gottschalk, Lin and Manocha, "OBBTree: A Hierarchical Structure for Rapid Interference Detection", 1996, part boxes
/// by such directions.
bool may_overlap(const Cylinder& a, const Cylinder& b) {
  if (is_nothing(a) || is_nothing(b)) return false;
  if (is_unbounded(a) || is_unbounded(b)) return true;
  const Vec3d way = Vec3d(b.center) - Vec3d(a.center), u = axis_of(a), v = axis_of(b);
  const std::array<Vec3d, 6> directions{
      u, v, way, way - glm::dot(way, u) * u, way - glm::dot(way, v) * v, glm::cross(u, v)};
  const double pad = padding * (sum_norm(way) + a.radius + a.half_length + b.radius + b.half_length);
  for (const Vec3d& direction : directions) {
    const double length = glm::length(direction);
    if (!(length > 0)) continue;
    const Vec3d n = direction / length;
    if (std::fabs(glm::dot(way, n)) > reach_of(a, u, n) + reach_of(b, v, n) + pad) return false;
  }
  return true;
}

}  // namespace sightline
