#pragma once

#include <bit>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/shape/mesh.h"

namespace sightline {

/// Collects triangles whose equal vertices become one.
class MeshBuilder {
 public:
  /// The number of the vertex at p, the same for every p with the same coordinates (-0 counts as 0).
  std::uint32_t vertex(Vec3f p) {
    p += 0.0f;
    const auto [place, is_new] = numbers_.try_emplace(p, static_cast<std::uint32_t>(positions_.size()));
    if (is_new) positions_.push_back(p);
    return place->second;
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangles_.push_back({a, b, c}); }
  void triangle(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const std::uint32_t first = vertex(a), second = vertex(b), third = vertex(c);
    triangle(first, second, third);
  }

  /// Two triangles; the corners in order around it.
  void quad(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }

  /// The six faces, outward, or inward to make a room of it.
  void box(const Vec3f& lo, const Vec3f& hi, bool inward = false) {
    for (int axis = 0; axis < 3; ++axis) {
      const int next = (axis + 1) % 3, last = (axis + 2) % 3;
      for (const bool upper : {false, true}) {
        Vec3f corners[4] = {lo, lo, hi, hi};
        corners[1][next] = hi[next];
        corners[3][next] = lo[next];
        for (Vec3f& corner : corners) corner[axis] = upper ? hi[axis] : lo[axis];
        corners[0][last] = corners[1][last] = lo[last];
        corners[2][last] = corners[3][last] = hi[last];
        if (upper != inward) {
          quad(corners[0], corners[1], corners[2], corners[3]);
        } else {
          quad(corners[0], corners[3], corners[2], corners[1]);
        }
      }
    }
  }

  /// Every triangle of `mesh`, scaled and then moved.
  void mesh(const TriangleMesh& mesh, float scale = 1, const Vec3f& offset = Vec3f(0)) {
    for (const auto& [a, b, c] : mesh.triangles()) {
      const std::vector<Vec3f>& p = mesh.positions();
      triangle(scale * p[a] + offset, scale * p[b] + offset, scale * p[c] + offset);
    }
  }

  TriangleMesh take() {
    numbers_.clear();
    return {std::exchange(positions_, {}), std::exchange(triangles_, {})};
  }

 private:
  struct Hash {
    std::size_t operator()(const Vec3f& p) const {
      const auto bits = [](float x) { return std::uint64_t{std::bit_cast<std::uint32_t>(x)}; };
      return Random::hash(Random::hash(bits(p.x) << 32 | bits(p.y)) ^ bits(p.z));
    }
  };

  std::unordered_map<Vec3f, std::uint32_t, Hash> numbers_;
  std::vector<Vec3f> positions_;
  std::vector<TriangleMesh::Corners> triangles_;
};

}  // namespace sightline
