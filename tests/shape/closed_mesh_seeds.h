#pragma once
/// Closed meshes to test with.

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/math/vec.h"

namespace sightline {

struct MeshSeed {
  std::vector<Vec3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

inline MeshSeed octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

inline MeshSeed cube() {
  MeshSeed seed;
  for (int i = 0; i < 8; ++i) seed.vertices.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  seed.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return seed;
}

/// A tetrahedron whose triangles are split again and again by any points whatever: closed, however folded and cut by
/// itself, with triangles of no area among the others.
template <class Point>
MeshSeed folded(std::uint32_t splits, Random& random, Point&& point) {
  MeshSeed seed{{point(), point(), point(), point()}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
  for (std::uint32_t i = 0; i < splits; ++i) {
    auto& split = seed.triangles[random.below(static_cast<std::uint32_t>(seed.triangles.size()))];
    const auto [a, b, c] = split;
    const auto middle = static_cast<std::uint32_t>(seed.vertices.size());
    seed.vertices.push_back(point());
    split = {a, b, middle};
    seed.triangles.push_back({b, c, middle});
    seed.triangles.push_back({c, a, middle});
  }
  return seed;
}

/// Two fans of `sides` triangles around the poles (0, 0, +-1).
inline MeshSeed double_fan(std::uint32_t sides) {
  MeshSeed seed{{{0, 0, 1}, {0, 0, -1}}, {}};
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * 3.141592653589793 * i / sides;
    seed.vertices.emplace_back(std::cos(angle), std::sin(angle), 0.125 * std::sin(3 * angle));
    const std::uint32_t here = 2 + i, next = 2 + (i + 1) % sides;
    seed.triangles.push_back({0, here, next});
    seed.triangles.push_back({1, next, here});
  }
  return seed;
}

}  // namespace sightline
