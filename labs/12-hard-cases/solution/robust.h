#pragma once
/// Lab 12: arithmetic that does not lie. Boxes, spheres, edges and origins that no rounding gets past.

#include "sightline/math/aabb.h"
#include "sightline/math/expansion.h"
#include "sightline/math/ray.h"

namespace student {

using namespace sightline;

/// Half a unit in the last place of a number near 1, for float and for double.
inline constexpr float float_roundoff = 0x1p-24f;
inline constexpr double double_roundoff = 0x1p-53;

/// a b - c d, off by no more than two roundings of the result, however much cancels.
inline double difference_of_products(double a, double b, double c, double d) {
  // lab:hole difference_of_products | 1. Products that cancel
  const double product = c * d;
  const double lost = std::fma(-c, d, product);  // rounded product minus true one: a double
  return std::fma(a, b, -product) + lost;
  // lab:end
}

/// Whether the ray's line meets the closed box at any t of [t_min, t_max]; in a face, an edge or a corner counts. A
/// direction may be 0 or -0 along any axis, and the box may be flat.
inline bool meets_box(const Ray<float>& ray, const Vec3f& lo, const Vec3f& hi) {
  // lab:hole meets_box | 2. Boxes that keep NaN
  float enter = ray.t_min, leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_forward = !std::signbit(ray.direction[axis]);
    const float near = ((is_forward ? lo : hi)[axis] - ray.origin[axis]) / ray.direction[axis];
    const float far = ((is_forward ? hi : lo)[axis] - ray.origin[axis]) / ray.direction[axis];
    if (near > enter) enter = near;  // false for NaN, 0 / 0: within the face, which bounds nothing
    if (far < leave) leave = far;
  }
  return enter <= leave;
  // lab:end
}

/// Where the ray's line enters and leaves a ball.
struct Chord {
  float enter, leave;
};

/// In float alone; nothing where the line misses. Far away, t must be right to within a few roundings of the distance.
inline std::optional<Chord> meet_sphere(const Ray<float>& ray, const Vec3f& center, float radius) {
  // lab:hole meet_sphere | 3. Spheres far away
  const Vec3f from_center = ray.origin - center;
  const float a = glm::dot(ray.direction, ray.direction), b = glm::dot(from_center, ray.direction);
  // The nearest point to the center, seen from there: as small as the ball, so its square cancels with nothing large.
  const Vec3f nearest = from_center - b / a * ray.direction;
  const float left = radius * radius - glm::dot(nearest, nearest);
  if (left < 0) return std::nullopt;
  const float c = glm::dot(from_center, from_center) - radius * radius;
  const float q = -(b + std::copysign(std::sqrt(a * left), b));
  const float one = q / a, other = q == 0 ? one : c / q;
  return Chord{std::min(one, other), std::max(one, other)};
  // lab:end
}

/// The sign of d . ((a - o) x (b - o)), without rounding: Expansion (math/expansion.h) is a sum of doubles that loses
/// nothing; exact_difference, +, - and * make them.
inline int exact_edge_sign(const Ray<float>& ray, const Vec3f& a, const Vec3f& b) {
  // lab:hole exact_edge_sign | 4. The sign of an edge
  const auto from = [&](const Vec3f& p, int axis) { return exact_difference(p[axis], ray.origin[axis]); };
  const auto term = [&](int i, int j, int k) {
    return Expansion<1>(ray.direction[i]) * (from(a, j) * from(b, k) - from(a, k) * from(b, j));
  };
  return (term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1)).sign();
  // lab:end
}

/// The same sign, -1, 0 or 1. Computed in double, and where rounding could have changed the sign, by exact_edge_sign;
/// `exact_count` grows by one each time it is asked.
inline int edge_sign(const Ray<float>& ray, const Vec3f& a, const Vec3f& b, long& exact_count) {
  // lab:hole edge_sign | 4. The sign of an edge
  const Vec3d o(ray.origin), d(ray.direction), to_a = Vec3d(a) - o, to_b = Vec3d(b) - o;
  const double estimate = glm::dot(d, glm::cross(to_a, to_b));
  const auto size = [](const Vec3d& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); };
  const double bound = 48 * double_roundoff * size(d) * size(to_a) * size(to_b);
  if (std::fabs(estimate) > bound) return estimate > 0 ? 1 : -1;
  ++exact_count;
  return exact_edge_sign(ray, a, b);
  // lab:end
}

/// Whether the ray's line, as long as it is in both directions, crosses the triangle: within, at an edge, or at a
/// corner. Lines in the triangle's plane miss it, and so does every line where it has no area.
inline bool crosses_triangle(const Ray<float>& ray, const Vec3f& a, const Vec3f& b, const Vec3f& c, long& exact_count) {
  // lab:hole crosses_triangle | 5. Triangles without gaps
  const int u = edge_sign(ray, b, c, exact_count), v = edge_sign(ray, c, a, exact_count);
  if (u * v < 0) return false;
  const int w = edge_sign(ray, a, b, exact_count);
  const bool has_positive = u > 0 || v > 0 || w > 0, has_negative = u < 0 || v < 0 || w < 0;
  return has_positive != has_negative;  // neither: edge-on
  // lab:end
}

/// A point of a triangle, in float: (1 - u - v) a + u b + v c. Given.
inline Vec3f point_of(const Vec3f& a, const Vec3f& b, const Vec3f& c, float u, float v) {
  return (1 - u - v) * a + u * b + v * c;
}

/// Where a ray starts that leaves the triangle at point_of(a, b, c, u, v), towards the side that (b - a) x (c - a)
/// points to: strictly on that side, and no farther from the plane than some dozen roundings of the coordinates. u, v
/// and u + v are in [0, 1]; the triangle is no sliver.
inline Vec3f leave_from(const Vec3f& a, const Vec3f& b, const Vec3f& c, float u, float v) {
  const Vec3f point = point_of(a, b, c, u, v);
  const Vec3d normal = glm::cross(Vec3d(b) - Vec3d(a), Vec3d(c) - Vec3d(a));
  // lab:hole leave_from | 6. Where a ray begins
  const Vec3d error = 8.0 * float_roundoff * (glm::abs(Vec3d(a)) + glm::abs(Vec3d(b)) + glm::abs(Vec3d(c)));
  const double reach = glm::dot(glm::abs(normal), error);
  Vec3f start;
  for (int axis = 0; axis < 3; ++axis) {
    const double exact = point[axis] + normal[axis] * (reach / glm::dot(normal, normal));
    start[axis] = static_cast<float>(exact);
    // Rounding must not take any of it back.
    if (normal[axis] == 0)
      start[axis] = point[axis];
    else
      start[axis] = std::nextafter(
          start[axis], std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(normal[axis])));
  }
  return start;
  // lab:end
}

}  // namespace student
