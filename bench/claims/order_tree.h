#pragma once
/// A binary hierarchy of boxes over objects in an order that is given, one object a leaf.
///   O1  A node's box contains those of the objects below it.
///   O2  The left child follows its parent, the right one is linked.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "sightline/accel/padded_ray.h"
#include "sightline/accel/probe.h"
#include "sightline/math/aabb.h"
#include "sightline/shape/mesh.h"

namespace sightline::bench {

/// How the children of a node are walked.
enum class ChildOrder { as_they_come, nearer_first };

/// What one or more walks tested.
struct VolumeTests {
  std::uint64_t volumes = 0;  ///< Boxes, those of objects included.
  std::uint64_t own = 0;      ///< Boxes of single objects.
  std::uint64_t objects = 0;  ///< Objects themselves.
};

class OrderTree {
 public:
  /// Halves the ids where they stand; with `is_sorted` after sorting each half across its centers' widest axis.
  OrderTree(const TriangleMesh& mesh, std::vector<std::uint32_t> ids, bool is_sorted)
      : mesh_(mesh), order_(std::move(ids)), is_sorted_(is_sorted) {
    nodes_.reserve(2 * order_.size());
    if (!order_.empty()) grow(0, static_cast<std::uint32_t>(order_.size()));
  }

  std::span<const std::uint32_t> leaf_order() const { return order_; }

  template <class T, class Visit>
  void traverse(const Ray<T>& ray, ChildOrder children, Visit&& visit, VolumeTests& tests) const {
    const PaddedRay<T> padded(ray, nodes_[0].box);
    if (!(padded.t_min <= padded.t_max)) return;
    T far = padded.t_max;
    const auto enter = [&](std::uint32_t node) {
      ++tests.volumes;
      tests.own += nodes_[node].is_leaf();
      return padded.clip(nodes_[node].box, far);
    };
    struct Waiting {
      std::uint32_t node;
      T enter;
    };
    std::vector<Waiting> stack;
    if (const auto whole = enter(0); !whole.is_empty()) stack.push_back({0, whole.lo});
    while (!stack.empty()) {
      const Waiting at = stack.back();
      stack.pop_back();
      if (at.enter > far) continue;
      const Node& node = nodes_[at.node];
      if (node.is_leaf()) {
        ++tests.objects;
        far = visit(LeafRange{node.first, 1});
        continue;
      }
      Waiting left{at.node + 1, T(0)}, right{node.right, T(0)};
      const auto in_left = enter(left.node), in_right = enter(right.node);
      left.enter = in_left.lo, right.enter = in_right.lo;
      const bool is_left_first = children == ChildOrder::as_they_come || left.enter <= right.enter;
      if (is_left_first && !in_right.is_empty()) stack.push_back(right);
      if (!in_left.is_empty()) stack.push_back(left);
      if (!is_left_first && !in_right.is_empty()) stack.push_back(right);
    }
  }

  /// Each object's box, one after the other: no hierarchy at all.
  template <class T, class Visit>
  void traverse_list(const Ray<T>& ray, Visit&& visit, VolumeTests& tests) const {
    const PaddedRay<T> padded(ray, nodes_[0].box);
    if (!(padded.t_min <= padded.t_max)) return;
    T far = padded.t_max;
    for (const Node& node : nodes_) {
      if (!node.is_leaf()) continue;
      ++tests.volumes, ++tests.own;
      if (padded.clip(node.box, far).is_empty()) continue;
      ++tests.objects;
      far = visit(LeafRange{node.first, 1});
    }
  }

 private:
  struct Node {
    Aabb box;
    std::uint32_t first = 0;  ///< Position of a leaf.
    std::uint32_t right = 0;  ///< 0 of a leaf.
    bool is_leaf() const { return right == 0; }
  };

  void sort(std::span<std::uint32_t> ids) const {
    Aabb centers;
    for (const std::uint32_t id : ids) centers.extend(mesh_.bounds(id).center());
    const int axis = centers.longest_axis();
    std::nth_element(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(ids.size() / 2), ids.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                       return mesh_.bounds(a).center()[axis] < mesh_.bounds(b).center()[axis];
                     });
  }

  Aabb grow(std::uint32_t first, std::uint32_t count) {
    const std::size_t self = nodes_.size();
    nodes_.push_back({{}, first, 0});
    if (count == 1) {
      nodes_[self].box = mesh_.bounds(order_[first]);
    } else {
      if (is_sorted_) sort(std::span(order_).subspan(first, count));
      Aabb box = grow(first, count / 2);
      nodes_[self].right = static_cast<std::uint32_t>(nodes_.size());  // O2
      box.extend(grow(first + count / 2, count - count / 2));
      nodes_[self].box = box;
    }
    return nodes_[self].box;
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> order_;
  bool is_sorted_;
  std::vector<Node> nodes_;
};

}  // namespace sightline::bench
