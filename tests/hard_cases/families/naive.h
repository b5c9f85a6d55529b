#pragma once
/// Intersections as they are often written, which families compare with.

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "sightline/math/ray.h"
#include "sightline/shape/mesh.h"

namespace sightline::hard {

struct NaiveHit {
  float t;
  std::uint32_t triangle;
};

/// Whether a triangle's edges are part of it: to some they are not.
enum class Edges { taken, left_out };

/// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997, in float and with the constant of
/// their code.
inline std::optional<float> moller_trumbore(const Ray<float>& ray, const Triangle& triangle, Edges edges) {
  const Vec3f edge1 = triangle.b - triangle.a, edge2 = triangle.c - triangle.a;
  const Vec3f p = glm::cross(ray.direction, edge2);
  const float determinant = glm::dot(edge1, p);
  if (std::fabs(determinant) < 0.000001f) return std::nullopt;
  const float inverse = 1 / determinant;
  const Vec3f from_a = ray.origin - triangle.a;
  const float u = glm::dot(from_a, p) * inverse;
  if (u < 0 || u > 1 || (edges == Edges::left_out && u == 0)) return std::nullopt;
  const Vec3f q = glm::cross(from_a, edge1);
  const float v = glm::dot(ray.direction, q) * inverse;
  if (v < 0 || u + v > 1 || (edges == Edges::left_out && (v == 0 || u + v == 1))) return std::nullopt;
  const float t = glm::dot(edge2, q) * inverse;
  return t > 0.000001f ? std::optional(t) : std::nullopt;
}

inline std::optional<NaiveHit> moller_trumbore(const Ray<float>& ray, const TriangleMesh& mesh,
                                               Edges edges = Edges::taken) {
  std::optional<NaiveHit> nearest;
  for (std::uint32_t id = 0; id < mesh.size(); ++id) {
    const auto t = moller_trumbore(ray, mesh[id], edges);
    if (t && *t <= ray.t_max && (!nearest || *t < nearest->t)) nearest = NaiveHit{*t, id};
  }
  return nearest;
}

/// Distinct roots of a t^2 + b t + c by the formula from school.
template <class T>
int school_root_count(T a, T b, T c) {
  const T discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 0)) return 0;
  const T root = std::sqrt(discriminant);
  return (-b - root) / (2 * a) == (-b + root) / (2 * a) ? 1 : 2;
}

}  // namespace sightline::hard
