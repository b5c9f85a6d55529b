#pragma once
/// What is asked of meshes that enclose something.

#include <array>
#include <map>

#include "sightline/shape/mesh.h"

namespace sightline {

/// Whether each edge, told by where its ends are, is taken as often one way as the other, and once.
inline bool is_closed(const TriangleMesh& mesh) {
  using Point = std::array<float, 3>;
  std::map<std::pair<Point, Point>, int> edges;
  const auto point = [&](std::uint32_t vertex) {
    const Vec3f p = mesh.positions()[vertex] + 0.0f;
    return Point{p.x, p.y, p.z};
  };
  for (const auto& corners : mesh.triangles()) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{point(corners[i]), point(corners[(i + 1) % 3])}];
  }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end()) return false;
  }
  return true;
}

/// What triangles enclose: more than 0 where they face outward.
inline double volume(const TriangleMesh& mesh) {
  double six_times = 0;
  for (std::uint32_t i = 0; i < mesh.size(); ++i) {
    const Triangle t = mesh[i];
    six_times += glm::dot(Vec3d(t.a), glm::cross(Vec3d(t.b), Vec3d(t.c)));
  }
  return six_times / 6;
}

}  // namespace sightline
