#pragma once
/// Where a ray crosses triangles, by another road than the library's.

#include <cstdint>
#include <map>
#include <vector>

#include "tests/shape/closed_mesh_seeds.h"
#include "tests/shape/rational_geometry.h"

namespace sightline {

/// Distances, and the triangles there.
using CrossingMap = std::map<Rational, std::vector<std::uint32_t>>;

/// Plane first, then on which sides of the edges the point is.
inline CrossingMap expected_crossings(const ExactLine& line, const MeshSeed& seed) {
  CrossingMap expected;
  for (std::uint32_t id = 0; id < seed.triangles.size(); ++id) {
    const auto& corners = seed.triangles[id];
    const ExactVector a = exact(seed.vertices[corners[0]]), b = exact(seed.vertices[corners[1]]),
                      c = exact(seed.vertices[corners[2]]);
    const ExactVector normal = cross(b - a, c - a);
    const Rational slope = dot(normal, line.direction);
    if (slope == 0) continue;
    const Rational t = dot(normal, a - line.origin) / slope;
    const ExactVector p = line.origin + t * line.direction;
    if (t < 0 || dot(cross(b - a, p - a), normal) < 0 || dot(cross(c - b, p - b), normal) < 0 ||
        dot(cross(a - c, p - c), normal) < 0) {
      continue;
    }
    expected[t].push_back(id);
  }
  return expected;
}

}  // namespace sightline
