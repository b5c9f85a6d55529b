#pragma once
/// Trees as they are often written: right, but for one case each.

#include <array>
#include <memory>

#include "tests/hard_cases/accelerator_parts.h"

namespace sightline::hard {

enum class KdFault { planar, outside_cell, zero_direction, split_at_origin };

class NaiveKdTree {
 public:
  NaiveKdTree(const TriangleMesh& mesh, KdFault fault) : mesh_(mesh), fault_(fault) {
    root_ = build(all_ids(mesh), mesh.bounds(), 0);
  }

  Hit<float> closest(const Ray<float>& ray) const {
    const Interval<float> range = naive_clip(mesh_.bounds(), ray);
    Hit<float> best;
    if (!(range.lo > range.hi)) walk(*root_, ray, range.lo, range.hi, best);
    return best;
  }

 private:
  struct Node {
    int axis = 0;
    float split = 0;
    std::unique_ptr<Node> below, above;
    std::vector<std::uint32_t> ids;
  };

  std::unique_ptr<Node> build(std::vector<std::uint32_t> ids, const Aabb& box, int depth) const {
    auto node = std::make_unique<Node>();
    const Vec3f extent = box.hi - box.lo;
    node->axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const float middle = 0.5f * (box.lo[node->axis] + box.hi[node->axis]);
    node->split = extent[node->axis] > 2 ? std::round(middle) : middle;
    if (ids.size() <= 4 || depth == 12) {
      node->ids = std::move(ids);
      return node;
    }
    std::vector<std::uint32_t> below, above;
    for (const std::uint32_t id : ids) {
      const float lo = mesh_.bounds(id).lo[node->axis], hi = mesh_.bounds(id).hi[node->axis];
      // Those in the plane: in no child, in the one above, as rays that look into both may have it, or in both.
      const bool is_open = fault_ == KdFault::planar, is_half_open = is_open || fault_ == KdFault::zero_direction;
      if (is_half_open ? lo < node->split : lo <= node->split) below.push_back(id);
      if (is_open ? hi > node->split : hi >= node->split) above.push_back(id);
    }
    Aabb low = box, high = box;
    low.hi[node->axis] = high.lo[node->axis] = node->split;
    node->below = build(std::move(below), low, depth + 1);
    node->above = build(std::move(above), high, depth + 1);
    return node;
  }

  /// True where the nearest is found.
  bool walk(const Node& node, const Ray<float>& ray, float t_min, float t_max, Hit<float>& best) const {
    if (!node.below) {
      keep_nearest(mesh_, node.ids, ray, best);
      return best.is_hit() && (fault_ == KdFault::outside_cell || best.t < t_max);
    }
    const float o = ray.origin[node.axis], d = ray.direction[node.axis], s = node.split;
    const bool goes_below = o == s && fault_ != KdFault::split_at_origin ? d < 0 : o < s;
    const Node &near = goes_below ? *node.below : *node.above, &far = goes_below ? *node.above : *node.below;
    const auto both = [&](float first_end, float second_begin) {
      return walk(near, ray, t_min, first_end, best) || walk(far, ray, second_begin, t_max, best);
    };
    if (d == 0 && fault_ != KdFault::zero_direction) {
      return o == s ? both(t_max, t_min) : walk(near, ray, t_min, t_max, best);
    }
    const float t = (s - o) / d;
    if (t > 0 && t_min <= t && t <= t_max) return both(t, t);
    if (t <= 0 || t > t_max) return walk(near, ray, t_min, t_max, best);
    return walk(far, ray, t_min, t_max, best);
  }

  const TriangleMesh& mesh_;
  KdFault fault_;
  std::unique_ptr<Node> root_;
};

/// A bounding interval hierarchy that takes the first child's hit for the nearest.
class NaiveBih {
 public:
  explicit NaiveBih(const TriangleMesh& mesh) : mesh_(mesh) { root_ = build(all_ids(mesh), 0); }

  Hit<float> closest(const Ray<float>& ray) const { return walk(*root_, ray); }

 private:
  struct Node {
    int axis = 0;
    Aabb bounds;
    std::array<std::unique_ptr<Node>, 2> children;
    std::vector<std::uint32_t> ids;
  };

  std::unique_ptr<Node> build(std::vector<std::uint32_t> ids, int depth) const {
    auto node = std::make_unique<Node>();
    for (const std::uint32_t id : ids) node->bounds.extend(mesh_.bounds(id));
    if (ids.size() <= 4 || depth == 16) {
      node->ids = std::move(ids);
      return node;
    }
    node->axis = depth % 3;
    std::sort(ids.begin(), ids.end(), [&](std::uint32_t i, std::uint32_t j) {
      const Aabb a = mesh_.bounds(i), b = mesh_.bounds(j);
      return a.lo[node->axis] + a.hi[node->axis] < b.lo[node->axis] + b.hi[node->axis];
    });
    const auto middle = ids.begin() + static_cast<std::ptrdiff_t>(ids.size() / 2);
    node->children[0] = build({ids.begin(), middle}, depth + 1);
    node->children[1] = build({middle, ids.end()}, depth + 1);
    return node;
  }

  Hit<float> walk(const Node& node, const Ray<float>& ray) const {
    Hit<float> best;
    const Interval<float> range = naive_clip(node.bounds, ray);
    if (range.lo > range.hi) return best;
    if (!node.children[0]) {
      keep_nearest(mesh_, node.ids, ray, best);
      return best;
    }
    const bool is_negative = ray.direction[node.axis] < 0;
    best = walk(*node.children[is_negative], ray);
    return best.is_hit() ? best : walk(*node.children[!is_negative], ray);
  }

  const TriangleMesh& mesh_;
  std::unique_ptr<Node> root_;
};

}  // namespace sightline::hard
