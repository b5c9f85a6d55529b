#pragma once
/// The cases of triangles, and what they share.

#include <cmath>
#include <numbers>
#include <vector>

#include "sightline/math/random.h"
#include "tests/hard_cases/mesh_question.h"

namespace sightline::hard {

HardCase triangle_edge();
HardCase triangle_vertex();
HardCase triangle_embree_far();
HardCase triangle_fan_pole();
HardCase triangle_t_junction();
HardCase triangle_absolute_epsilon();
HardCase triangle_underflow();
HardCase triangle_pbrt_bad_case();
HardCase triangle_sliver();
HardCase triangle_coplanar();
HardCase triangle_parity();
HardCase triangle_origin_on();

/// In the cube from -1 to 1.
inline Vec3d point_in_cube(Random& random) {
  const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
  return 2.0 * Vec3d(x, y, z) - 1.0;
}

/// Closed, its corners rounded to float.
inline TriangleMesh uv_sphere(std::uint32_t rings, std::uint32_t sectors, const Vec3d& center, double radius) {
  std::vector<Vec3f> positions{Vec3f(center + Vec3d(0, 0, radius)), Vec3f(center - Vec3d(0, 0, radius))};
  std::vector<TriangleMesh::Corners> triangles;
  const auto at = [&](std::uint32_t ring, std::uint32_t sector) { return 2 + ring * sectors + sector % sectors; };
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
    const double polar = std::numbers::pi * (ring + 1) / rings;
    for (std::uint32_t i = 0; i < sectors; ++i) {
      const double angle = 2 * std::numbers::pi * i / sectors;
      const Vec3d unit(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar));
      positions.push_back(Vec3f(center + radius * unit));
    }
  }
  for (std::uint32_t i = 0; i < sectors; ++i) {
    triangles.push_back({0, at(0, i), at(0, i + 1)});
    triangles.push_back({1, at(rings - 2, i + 1), at(rings - 2, i)});
    for (std::uint32_t ring = 0; ring + 2 < rings; ++ring) {
      triangles.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
  }
  return {std::move(positions), std::move(triangles)};
}

/// From there to there, as floats have them.
inline Ray<float> ray_between(const Vec3d& from, const Vec3d& to) {
  const Vec3f origin(from);
  return {origin, Vec3f(to - Vec3d(origin))};
}

}  // namespace sightline::hard
