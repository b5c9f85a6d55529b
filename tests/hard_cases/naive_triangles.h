#pragma once
/// Tests of triangles as they are often written, in float.

#include <algorithm>
#include <cmath>
#include <optional>

#include "sightline/shape/triangle.h"

namespace sightline::hard {

/// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997. Determinants up to `least` count as
/// none; a negative one lets 0 / 0 through.
inline std::optional<float> moller_trumbore(const Ray<float>& ray, const Triangle& triangle, float least) {
  const Vec3f e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, p = glm::cross(ray.direction, e2);
  const float det = glm::dot(e1, p);
  if (std::fabs(det) <= least) return std::nullopt;
  const Vec3f s = ray.origin - triangle.a;
  const float u = glm::dot(s, p) / det;
  if (u < 0 || u > 1) return std::nullopt;
  const Vec3f q = glm::cross(s, e1);
  const float v = glm::dot(ray.direction, q) / det;
  if (v < 0 || u + v > 1) return std::nullopt;
  return glm::dot(e2, q) / det;
}
inline std::optional<float> moller_trumbore(const Ray<float>& ray, const Triangle& triangle) {
  return moller_trumbore(ray, triangle, 0);
}
inline std::optional<float> cautious_moller_trumbore(const Ray<float>& ray, const Triangle& triangle) {
  return moller_trumbore(ray, triangle, 1e-6f);
}

/// Baldwin and Weber, "Fast Ray-Triangle Intersections by Coordinate Transformation", 2016, in its simplest form: the
/// map that makes the triangle the unit triangle of the plane z = 0 is kept in float.
inline std::optional<float> baldwin_weber(const Ray<float>& ray, const Triangle& triangle) {
  const Vec3f e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, n = glm::cross(e1, e2);
  const Vec3f row_u = glm::cross(e2, n) / glm::dot(e1, glm::cross(e2, n)),
              row_v = glm::cross(e1, n) / glm::dot(e2, glm::cross(e1, n));
  const float at_u = glm::dot(row_u, triangle.a), at_v = glm::dot(row_v, triangle.a), at_n = glm::dot(n, triangle.a);
  const float t = (at_n - glm::dot(n, ray.origin)) / glm::dot(n, ray.direction);
  const Vec3f p = ray.at(t);
  const float u = glm::dot(row_u, p) - at_u, v = glm::dot(row_v, p) - at_v;
  if (!(u >= 0 && v >= 0 && u + v <= 1)) return std::nullopt;
  return t;
}

/// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013, without its second look in double.
inline std::optional<float> woop(const Ray<float>& ray, const Triangle& triangle) {
  const int z = largest_axis(glm::abs(ray.direction)), x = (z + 1) % 3, y = (x + 1) % 3;
  const float sx = ray.direction[x] / ray.direction[z], sy = ray.direction[y] / ray.direction[z];
  const Vec3f a = triangle.a - ray.origin, b = triangle.b - ray.origin, c = triangle.c - ray.origin;
  const float ax = a[x] - sx * a[z], ay = a[y] - sy * a[z], bx = b[x] - sx * b[z], by = b[y] - sy * b[z],
              cx = c[x] - sx * c[z], cy = c[y] - sy * c[z];
  const float u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
  const float det = u + v + w;
  if (det == 0) return std::nullopt;
  return (u * a[z] + v * b[z] + w * c[z]) / ray.direction[z] / det;
}

/// Refuses triangles without area, and takes the square of the area for it.
inline std::optional<float> area_checked(const Ray<float>& ray, const Triangle& triangle) {
  const Vec3f normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
  if (glm::dot(normal, normal) == 0) return std::nullopt;
  return moller_trumbore(ray, triangle);
}

}  // namespace sightline::hard
