/// Why nothing is missed. A box is met where the intervals of its slabs have a time in common; each end is a difference
/// and a quotient, so it is moved outward by 2^-51 of itself, and by more than what underflows.
///
/// Balls and cylinders are asked in lengths of `way_`, a point of which in reach (the distance of the center, and the
/// sizes) is rounded by less than 2^-48 of reach. A pad of 2^-42 of reach to radii and lengths covers this: a chord,
/// which is sqrt((R^2 - d^2) / w^2) for the radius R and the distance d from the line, then ends later by more than pad
/// / (4 w), and a slab by pad / w, a hundred times what the ends themselves are rounded by, however small w is, the
/// part of `way_` across the axis, or along it.

#include "sightline/math/volume_ray.h"

#include <algorithm>
#include <cmath>

#include "sightline/math/enclosure.h"

namespace sightline {
namespace {

constexpr double underflow = 0x1p-1000;

double earlier(double t) { return t * (t > 0 ? 1 - 0x1p-51 : 1 + 0x1p-51) - underflow; }
double later(double t) { return t * (t > 0 ? 1 + 0x1p-51 : 1 - 0x1p-51) + underflow; }

double sum_norm(const Vec3d& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

constexpr double padding = 0x1p-42;

}  // namespace

VolumeRay::VolumeRay(const Ray<double>& ray)
    : origin_(ray.origin),
      direction_(ray.direction),
      t_min_(ray.t_min),
      t_max_(ray.t_max),
      is_valid_(sightline::is_valid(ray)) {
  const double size = is_valid_ ? max_norm(direction_) : 1;
  way_ = direction_ / size;
  way2_ = glm::dot(way_, way_);
  from_ = t_min_ * size;
  to_ = t_max_ * size;
}

/// Kay and Kajiya, "Ray Tracing Complex Scenes", 1986.
bool VolumeRay::may_meet(const Aabb& box) const {
  if (is_nothing(box) || !is_valid_) return false;
  double enter = t_min_, leave = t_max_;
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = box.lo[axis], hi = box.hi[axis], o = origin_[axis], d = direction_[axis];
    if (d == 0) {
      if (o < lo || o > hi) return false;
      continue;
    }
    const double at_lo = (lo - o) / d, at_hi = (hi - o) / d;
    enter = std::max(enter, earlier(d > 0 ? at_lo : at_hi));
    leave = std::min(leave, later(d > 0 ? at_hi : at_lo));
  }
  return !(enter > leave);
}

/// By the point of the ray that is closest to the center. Where its time is rounded, it is not much farther.
bool VolumeRay::may_meet(const Sphere& sphere) const {
  if (is_nothing(sphere) || !is_valid_) return false;
  if (is_unbounded(sphere)) return true;
  const Vec3d to_center = Vec3d(sphere.center) - origin_;
  const double closest = std::max(from_, std::min(to_, glm::dot(to_center, way_) / way2_));
  const Vec3d offset = to_center - closest * way_;
  const double radius = sphere.radius + padding * (sum_norm(to_center) + std::fabs(closest) + sphere.radius);
  return !(glm::dot(offset, offset) > radius * radius);
}

bool VolumeRay::may_meet(const Cylinder& cylinder) const {
  if (is_nothing(cylinder) || !is_valid_) return false;
  if (is_unbounded(cylinder)) return true;
  const Vec3d axis = glm::normalize(Vec3d(cylinder.axis)), to_center = Vec3d(cylinder.center) - origin_;
  const double pad = padding * (sum_norm(to_center) + cylinder.radius + cylinder.half_length);
  const double radius = cylinder.radius + pad, half_length = cylinder.half_length + pad;
  double enter = from_, leave = to_;

  const double center_along = glm::dot(to_center, axis), way_along = glm::dot(way_, axis);
  if (way_along != 0) {
    const double low = (center_along - half_length) / way_along, high = (center_along + half_length) / way_along;
    enter = std::max(enter, std::min(low, high));
    leave = std::min(leave, std::max(low, high));
  } else if (std::fabs(center_along) > half_length) {
    return false;
  }

  const Vec3d center_across = to_center - center_along * axis, way_across = way_ - way_along * axis;
  const double across2 = glm::dot(way_across, way_across);
  if (across2 > 0) {
    const double middle = glm::dot(center_across, way_across) / across2;
    const Vec3d offset = center_across - middle * way_across;
    const double rest = radius * radius - glm::dot(offset, offset);
    if (rest < 0) return false;
    const double half_chord = std::sqrt(rest / across2);
    enter = std::max(enter, middle - half_chord);
    leave = std::min(leave, middle + half_chord);
  } else if (glm::dot(center_across, center_across) > radius * radius) {
    return false;
  }
  return !(enter > leave);
}

}  // namespace sightline
