#pragma once
/// A uniform grid as it is often written: right, but for one case each.

#include <array>
#include <cmath>

#include "tests/hard_cases/accelerator_parts.h"

namespace sightline::hard {

enum class GridFault { insert, outside_cell };

class NaiveGrid {
 public:
  static constexpr int n = 8;

  NaiveGrid(const TriangleMesh& mesh, GridFault fault) : mesh_(mesh), fault_(fault), cells_(n * n * n) {
    size_ = (mesh.bounds().hi - mesh.bounds().lo) / float(n);
    for (std::uint32_t id = 0; id < mesh.size(); ++id) insert(id);
  }

  /// Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987.
  Hit<float> closest(const Ray<float>& ray) const {
    const Interval<float> range = naive_clip(mesh_.bounds(), ray);
    Hit<float> best;
    if (range.lo > range.hi) return best;
    std::array<int, 3> at;
    Vec3f next(INFINITY), delta(INFINITY);
    for (int axis = 0; axis < 3; ++axis) {
      at[axis] = index(axis, ray.origin[axis] + range.lo * ray.direction[axis]);
      if (ray.direction[axis] == 0) continue;
      const float plane = mesh_.bounds().lo[axis] + float(at[axis] + (ray.direction[axis] > 0)) * size_[axis];
      next[axis] = (plane - ray.origin[axis]) / ray.direction[axis];
      delta[axis] = size_[axis] / std::fabs(ray.direction[axis]);
    }
    for (;;) {
      keep_nearest(mesh_, cells_[static_cast<std::size_t>((at[2] * n + at[1]) * n + at[0])], ray, best);
      const int axis = next.x <= next.y && next.x <= next.z ? 0 : next.y <= next.z ? 1 : 2;
      if (best.is_hit() && (fault_ == GridFault::outside_cell || best.t <= next[axis])) return best;
      at[axis] += ray.direction[axis] < 0 ? -1 : 1;
      if (at[axis] < 0 || at[axis] >= n) return best;
      next[axis] += delta[axis];
    }
  }

 private:
  int index(int axis, float x) const { return std::clamp(int((x - mesh_.bounds().lo[axis]) / size_[axis]), 0, n - 1); }

  void insert(std::uint32_t id) {
    const Aabb box = mesh_.bounds(id);
    std::array<int, 3> first, last;
    for (int axis = 0; axis < 3; ++axis) {
      const float lo = (box.lo[axis] - mesh_.bounds().lo[axis]) / size_[axis],
                  hi = (box.hi[axis] - mesh_.bounds().lo[axis]) / size_[axis];
      const bool is_half_open = fault_ == GridFault::insert;
      first[axis] = std::clamp(is_half_open ? int(std::floor(lo)) : int(std::floor(lo - 1e-3f)), 0, n - 1);
      last[axis] = std::min(is_half_open ? int(std::ceil(hi)) - 1 : int(std::floor(hi + 1e-3f)), n - 1);
    }
    for (int z = first[2]; z <= last[2]; ++z) {
      for (int y = first[1]; y <= last[1]; ++y) {
        for (int x = first[0]; x <= last[0]; ++x) cells_[static_cast<std::size_t>((z * n + y) * n + x)].push_back(id);
      }
    }
  }

  const TriangleMesh& mesh_;
  GridFault fault_;
  Vec3f size_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace sightline::hard
