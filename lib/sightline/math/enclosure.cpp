/// All volumes are measured from what is stored of them, in double, so that only these measures' roundings count:
///   M1  Distances between floats are off by less than 2^-50 of themselves, their parts along a normalized axis and
///       across it by less than 2^-45 of them.

#include "sightline/math/enclosure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sightline/math/interval.h"
#include "sightline/math/rounding.h"
#include "sightline/math/smallest_ball.h"
#include "sightline/math/smallest_cylinder.h"

namespace sightline {
namespace {

/// As round_up, and not below infinity where the number is none.
float radius_up(double x) { return std::isfinite(x) ? round_up(x) : std::numeric_limits<float>::infinity(); }

Sphere checked(const Sphere& sphere) {
  return is_finite(sphere.center) && std::isfinite(sphere.radius) ? sphere : everything<Sphere>();
}
Cylinder checked(const Cylinder& cylinder) {
  const bool is_bounded = is_finite(cylinder.center) && is_finite(cylinder.axis) && cylinder.axis != Vec3f(0) &&
                          std::isfinite(cylinder.radius) && std::isfinite(cylinder.half_length);
  return is_bounded ? cylinder : everything<Cylinder>();
}

template <class V>
std::vector<V> without_nothing(std::span<const V> volumes) {
  std::vector<V> some;
  some.reserve(volumes.size());
  for (const V& v : volumes) {
    if (!is_nothing(v)) some.push_back(v);
  }
  return some;
}

/// The smallest ball from a center around balls (M1).
Sphere measured(const Vec3d& middle, std::span<const Sphere> spheres) {
  const Vec3f center(middle);
  double radius = 0;
  for (const Sphere& s : spheres) {
    radius = std::max(radius, glm::length(Vec3d(s.center) - Vec3d(center)) + s.radius);
  }
  return checked({center, radius_up(radius * (1 + 0x1p-49))});
}

/// Of two balls of which neither holds the other.
Vec3d middle_of_two(const Sphere& a, const Sphere& b) {
  const Vec3d way = Vec3d(b.center) - Vec3d(a.center);
  const double distance = glm::length(way);
  return Vec3d(a.center) + way * (0.5 * (distance + double(b.radius) - double(a.radius)) / distance);
}

// ---- Cylinders

struct Rod {
  Vec3d center, axis;  ///< The axis has unit length.
  double radius, half_length;

  explicit Rod(const Cylinder& c)
      : center(c.center), axis(glm::normalize(Vec3d(c.axis))), radius(c.radius), half_length(c.half_length) {}

  /// How far it reaches from its center along a direction of unit length.
  double reach(const Vec3d& n) const {
    return half_length * std::fabs(glm::dot(axis, n)) + radius * glm::length(glm::cross(axis, n));
  }
  Vec3d end(int i) const { return i == 0 ? center - half_length * axis : center + half_length * axis; }
};

/// Coordinates along an axis and across it, from an origin.
struct AxisFrame {
  Vec3d origin, u, v, w;

  AxisFrame(const Vec3d& from, const Vec3d& axis) : origin(from), w(glm::normalize(axis)) {
    const Vec3d a = glm::abs(w);
    const Vec3d least = a.x <= a.y && a.x <= a.z ? Vec3d(1, 0, 0) : a.y <= a.z ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
    u = glm::normalize(glm::cross(w, least));
    v = glm::cross(w, u);
  }
  Vec3d across(const Vec3d& p) const { return {glm::dot(p - origin, u), glm::dot(p - origin, v), 0}; }
  Vec3d back(double x, double y, double z) const { return origin + x * u + y * v + z * w; }
};

Interval<double> extent_along(std::span<const Rod> rods, const Vec3d& origin, const Vec3d& n) {
  Interval<double> extent;
  for (const Rod& rod : rods) {
    const double middle = glm::dot(rod.center - origin, n), reach = rod.reach(n);
    extent.lo = std::min(extent.lo, middle - reach);
    extent.hi = std::max(extent.hi, middle + reach);
  }
  return extent;
}

/// Half of the surface, roughly: the circle around the middle of the ends' extents is not the smallest.
double area_along(std::span<const Rod> rods, const AxisFrame& frame) {
  Vec3d lo(std::numeric_limits<double>::infinity()), hi(-lo);
  for (const Rod& rod : rods) {
    for (int i = 0; i < 2; ++i) {
      const Vec3d p = frame.across(rod.end(i));
      lo = glm::min(lo, p - rod.radius);
      hi = glm::max(hi, p + rod.radius);
    }
  }
  const Vec3d middle = 0.5 * (lo + hi);
  double radius = 0;
  for (const Rod& rod : rods) {
    for (int i = 0; i < 2; ++i) {
      const Vec3d p = frame.across(rod.end(i));
      radius = std::max(radius, std::hypot(p.x - middle.x, p.y - middle.y) + rod.radius);
    }
  }
  const Interval<double> extent = extent_along(rods, frame.origin, frame.w);
  return radius * (radius + (extent.hi - extent.lo));
}

/// The axes, that of the largest rod, and the line between the two that are about the farthest apart.
std::array<Vec3d, 5> candidate_axes(std::span<const Rod> rods) {
  const auto size = [](const Rod& rod) { return rod.radius + rod.half_length; };
  const auto largest =
      std::max_element(rods.begin(), rods.end(), [&](const Rod& a, const Rod& b) { return size(a) < size(b); });
  const auto farthest_from = [&](const Vec3d& p) {
    const auto distance = [&](const Rod& rod) { return glm::length(rod.center - p); };
    return std::max_element(rods.begin(), rods.end(),
                            [&](const Rod& a, const Rod& b) { return distance(a) < distance(b); })
        ->center;
  };
  const Vec3d far = farthest_from(rods[0].center);
  const Vec3d line = farthest_from(far) - far;
  return {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1), largest->axis, max_norm(line) > 0 ? line : largest->axis};
}

/// On an axis as it is stored, measured from a center as that is stored. A rod lies within the hull of its end disks,
/// and a disk across the axis within a circle of its radius.
Cylinder measured(std::span<const Rod> rods, const AxisFrame& frame) {
  std::vector<Vec3d> centers;
  std::vector<double> radii;
  for (const Rod& rod : rods) {
    for (int i = 0; i < 2; ++i) {
      centers.push_back(frame.across(rod.end(i)));
      radii.push_back(rod.radius);
    }
  }
  const Vec3d circle = SmallestBall::center_of_balls(centers, radii, 3);
  const Interval<double> middle = extent_along(rods, frame.origin, frame.w);
  const Vec3f center(frame.back(circle.x, circle.y, 0.5 * (middle.lo + middle.hi)));
  const Vec3f axis(frame.w);
  const Vec3d from(center), n = glm::normalize(Vec3d(axis));
  double radius = 0, half_length = 0;
  for (const Rod& rod : rods) {
    half_length = std::max(half_length, std::fabs(glm::dot(rod.center - from, n)) + rod.reach(n));
    for (int i = 0; i < 2; ++i) {
      const Vec3d p = rod.end(i) - from;
      radius = std::max(radius, glm::length(p - glm::dot(p, n) * n) + rod.radius);
    }
  }
  const double rounding = 0x1p-40 * (radius + half_length);  // M1
  return checked({center, axis, radius_up(radius + rounding), radius_up(half_length + rounding)});
}

}  // namespace

double volume_of(const Aabb& box) {
  if (box.is_empty()) return 0;
  const Vec3d e = Vec3d(box.hi) - Vec3d(box.lo);
  return e.x * e.y * e.z;
}

double volume_of(const Sphere& sphere) {
  const double r = sphere.radius;
  return r < 0 ? 0 : 4 * std::numbers::pi / 3 * r * r * r;
}

double volume_of(const Cylinder& cylinder) {
  const double r = cylinder.radius;
  return r < 0 ? 0 : 2 * std::numbers::pi * r * r * cylinder.half_length;
}

Sphere closer_of(const Sphere& a, const Sphere& b) { return b.radius < a.radius ? b : a; }

Cylinder closer_of(const Cylinder& a, const Cylinder& b) {
  const auto half_area = [](const Cylinder& c) {
    return double(c.radius) * (double(c.radius) + 2 * double(c.half_length));
  };
  if (is_nothing(a)) return a;
  return !is_nothing(b) && half_area(a) <= half_area(b) ? a : b;
}

Enclosure enclosure_of(std::span<const Vec3f> points) {
  Enclosure made;
  if (points.empty()) return made;
  for (const Vec3f& p : points) made.box.extend(p);
  const Vec3f center(SmallestBall::center(
      points.size(), [&](std::size_t i) { return Vec3d(points[i]); }, 4));
  double radius = 0;
  for (const Vec3f& p : points) radius = std::max(radius, glm::length(Vec3d(p) - Vec3d(center)));
  made.sphere = checked({center, radius_up(radius * (1 + 0x1p-49))});  // M1
  made.cylinder = checked(SmallestCylinder(made.box, points).smallest());
  return made;
}

Enclosure enclosure_of(const Aabb& box) { return {box, ball_around(box), cylinder_around(box)}; }

Sphere ball_around(const Aabb& box) {
  if (is_nothing(box)) return Enclosure().sphere;
  if (is_unbounded(box)) return everything<Sphere>();
  const Vec3f center = box.center();
  const Vec3d reach = glm::max(Vec3d(box.hi) - Vec3d(center), Vec3d(center) - Vec3d(box.lo));
  return checked({center, radius_up(glm::length(reach) * (1 + 0x1p-49))});  // M1
}

Cylinder cylinder_around(const Aabb& box) {
  if (is_nothing(box)) return Enclosure().cylinder;
  if (is_unbounded(box)) return everything<Cylinder>();
  const Vec3f center = box.center();
  const Vec3d reach = glm::max(Vec3d(box.hi) - Vec3d(center), Vec3d(center) - Vec3d(box.lo));
  Cylinder best = everything<Cylinder>();
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double radius = std::hypot(reach[(axis + 1) % 3], reach[(axis + 2) % 3]), half = reach[axis];
    if (!(radius * (radius + 2 * half) < least)) continue;
    least = radius * (radius + 2 * half);
    Vec3f along(0);
    along[axis] = 1;
    best = checked({center, along, radius_up(radius * (1 + 0x1p-49)), radius_up(half * (1 + 0x1p-49))});  // M1
  }
  return best;
}

Aabb around(std::span<const Aabb> boxes) {
  Aabb all;
  for (const Aabb& box : boxes) all.extend(box);
  return all;
}

Sphere around(std::span<const Sphere> spheres) {
  const std::vector<Sphere> some = without_nothing(spheres);
  if (some.empty()) return Enclosure().sphere;
  const auto largest =
      std::max_element(some.begin(), some.end(), [](const Sphere& a, const Sphere& b) { return a.radius < b.radius; });
  if (is_unbounded(*largest)) return everything<Sphere>();
  const bool holds_all = std::all_of(some.begin(), some.end(), [&](const Sphere& s) {
    return (glm::length(Vec3d(s.center) - Vec3d(largest->center)) + s.radius) * (1 + 0x1p-49) <= largest->radius ||
           &s == &*largest;
  });
  if (holds_all) return *largest;
  if (some.size() == 2) return measured(middle_of_two(some[0], some[1]), some);
  std::vector<Vec3d> centers;
  std::vector<double> radii;
  for (const Sphere& s : some) {
    centers.emplace_back(s.center);
    radii.push_back(s.radius);
  }
  return measured(SmallestBall::center_of_balls(centers, radii, 4), some);
}

Cylinder around(std::span<const Cylinder> cylinders) {
  const std::vector<Cylinder> some = without_nothing(cylinders);
  if (some.empty()) return Enclosure().cylinder;
  if (some.size() == 1) return some[0];
  if (std::any_of(some.begin(), some.end(), [](const Cylinder& c) { return is_unbounded(c); })) {
    return everything<Cylinder>();
  }
  const std::vector<Rod> rods(some.begin(), some.end());
  const std::array<Vec3d, 5> axes = candidate_axes(rods);
  AxisFrame best(rods[0].center, axes[0]);
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3d& axis : axes) {
    const AxisFrame frame(rods[0].center, axis);
    const double area = area_along(rods, frame);
    if (!(area < least)) continue;
    least = area;
    best = frame;
  }
  return measured(rods, best);
}

}  // namespace sightline
