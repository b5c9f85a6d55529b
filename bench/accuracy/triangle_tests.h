#pragma once
/// Ray-triangle tests as textbooks and papers have them, written plainly, in any type of numbers. Each takes the line
/// of a ray, counts edges in, and reports t and the weights u, v of the second and third corner.

#include <utility>

#include "sightline/math/ray.h"
#include "sightline/shape/triangle.h"

namespace sightline::bench {

template <class T>
struct TestedCrossing {
  bool is_hit = false;
  T t = 0, u = 0, v = 0;
};

/// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
template <class T>
struct MoellerTrumbore {
  struct Prepared {
    Vec3<T> a, b, c;
    explicit Prepared(const Triangle& triangle) : a(triangle.a), b(triangle.b), c(triangle.c) {}
  };
  Vec3<T> origin, direction;
  explicit MoellerTrumbore(const Ray<float>& ray) : origin(ray.origin), direction(ray.direction) {}

  TestedCrossing<T> operator()(const Prepared& p) const {
    const Vec3<T> ab = p.b - p.a, ac = p.c - p.a, across = glm::cross(direction, ac);
    const T determinant = glm::dot(ab, across);
    if (determinant == 0) return {};
    const T inverse = 1 / determinant;
    const Vec3<T> from = origin - p.a;
    const T u = glm::dot(from, across) * inverse;
    if (!(u >= 0 && u <= 1)) return {};
    const Vec3<T> up = glm::cross(from, ab);
    const T v = glm::dot(direction, up) * inverse;
    if (!(v >= 0 && u + v <= 1)) return {};
    return {true, glm::dot(ac, up) * inverse, u, v};
  }
};

/// Baldwin and Weber, "Fast Ray-Triangle Intersections by Coordinate Transformation", 2016: a map that takes the
/// triangle to the unit one is kept with it; of its rows one is known, which the largest component of the normal says.
template <class T>
struct BaldwinWeber {
  struct Prepared {
    Vec3<T> row[3];
    T offset[3];
    explicit Prepared(const Triangle& triangle) {
      const Vec3d a(triangle.a), ab = Vec3d(triangle.b) - a, ac = Vec3d(triangle.c) - a, n = glm::cross(ab, ac);
      const double size = glm::dot(n, n);
      const Vec3d rows[3] = {glm::cross(ac, n) / size, glm::cross(n, ab) / size, n / size};
      for (int i = 0; i < 3; ++i) row[i] = Vec3<T>(rows[i]), offset[i] = static_cast<T>(-glm::dot(rows[i], a));
    }
  };
  Vec3<T> origin, direction;
  explicit BaldwinWeber(const Ray<float>& ray) : origin(ray.origin), direction(ray.direction) {}

  TestedCrossing<T> operator()(const Prepared& p) const {
    const T speed = glm::dot(p.row[2], direction);
    if (speed == 0) return {};
    const T t = -(glm::dot(p.row[2], origin) + p.offset[2]) / speed;
    const Vec3<T> at = origin + t * direction;
    const T u = glm::dot(p.row[0], at) + p.offset[0];
    const T v = glm::dot(p.row[1], at) + p.offset[1];
    return {u >= 0 && v >= 0 && u + v <= 1, t, u, v};
  }
};

/// Sides of three lines in Pluecker coordinates (Shevtsov, Soupikov and Kapustin, 2007, go on from there).
template <class T>
struct Pluecker {
  using Prepared = typename MoellerTrumbore<T>::Prepared;
  Vec3<T> origin, direction, moment;
  explicit Pluecker(const Ray<float>& ray)
      : origin(ray.origin), direction(ray.direction), moment(glm::cross(direction, origin)) {}

  TestedCrossing<T> operator()(const Prepared& p) const {
    const T u = side(p.b, p.c), v = side(p.c, p.a), w = side(p.a, p.b);
    const bool has_positive = u > 0 || v > 0 || w > 0, has_negative = u < 0 || v < 0 || w < 0;
    if (has_positive == has_negative) return {};
    const Vec3<T> normal = glm::cross(p.b - p.a, p.c - p.a);
    const T inverse = 1 / (u + v + w);
    return {true, glm::dot(normal, p.a - origin) / glm::dot(normal, direction), v * inverse, w * inverse};
  }
  T side(const Vec3<T>& from, const Vec3<T>& to) const {
    return glm::dot(direction, glm::cross(to, from)) + glm::dot(to - from, moment);
  }
};

/// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013, without its second try in double.
template <class T>
struct Woop {
  using Prepared = typename MoellerTrumbore<T>::Prepared;
  Vec3<T> origin;
  int x, y, z;
  T shear_x, shear_y, scale;
  explicit Woop(const Ray<float>& ray) : origin(ray.origin) {
    z = largest_axis(glm::abs(ray.direction)), x = (z + 1) % 3, y = (z + 2) % 3;
    if (ray.direction[z] < 0) std::swap(x, y);
    const Vec3<T> direction(ray.direction);
    shear_x = direction[x] / direction[z], shear_y = direction[y] / direction[z], scale = 1 / direction[z];
  }

  TestedCrossing<T> operator()(const Prepared& p) const {
    const Vec3<T> a = p.a - origin, b = p.b - origin, c = p.c - origin;
    const T ax = a[x] - shear_x * a[z], ay = a[y] - shear_y * a[z];
    const T bx = b[x] - shear_x * b[z], by = b[y] - shear_y * b[z];
    const T cx = c[x] - shear_x * c[z], cy = c[y] - shear_y * c[z];
    const T u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return {};
    const T determinant = u + v + w;
    if (determinant == 0) return {};
    const T inverse = 1 / determinant;
    return {true, (u * a[z] + v * b[z] + w * c[z]) * scale * inverse, v * inverse, w * inverse};
  }
};

}  // namespace sightline::bench
