#pragma once
/// The binary tree of boxes from which wide ones are made.

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <cstdint>
#include <span>
#include <vector>

#include "sightline/accel/large_pages.h"
#include "sightline/accel/object_split.h"
#include "sightline/accel/primitives.h"

namespace sightline {

/// Divided by the surface area heuristic down to single primitives.
///   N1  A subtree of n primitives takes 2 n - 1 places: its root, then the left child's, then the right child's. So
///       subtrees are built apart without moving them, and no node needs a link.
///   N2  The primitives of a subtree stand side by side in `order`, those of the left child first.
///   N3  Of a path's nodes at most heuristic_depth divide by cost; from then on they halve: no leaf is deeper than
///       max_depth.
class BinaryTree {
 public:
  struct Node {
    Aabb box;
    std::uint32_t count;  ///< Primitives below.
    std::uint32_t note;   ///< Of whoever works on the tree; 0 at first.
  };

  static constexpr int heuristic_depth = 48;
  static constexpr int max_depth = heuristic_depth + 32;

  /// `bins`: on each axis, when many primitives are divided.
  BinaryTree(const Primitives& primitives, int bins)
      : order(primitives.size()), splitter_({1, 1, 1, bins}, {}), items_(primitives.size()) {
    const std::uint32_t count = primitives.size();
    if (count == 0) return;
    nodes_ = LargeBuffer<Node>(std::size_t{2} * count - 1);
    tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t id) { items_[id] = {primitives.bounds(id), id}; });
    grow(0, 0, count, 0);
    tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t i) { order[i] = items_[i].id; });
    items_ = LargeBuffer<BoundsReference>();
  }

  std::vector<std::uint32_t> order;  ///< Ids by position (N2).

  bool is_empty() const { return nodes_.size() == 0; }
  Node& operator[](std::uint32_t node) { return nodes_[node]; }
  const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  bool is_leaf(std::uint32_t node) const { return nodes_[node].count == 1; }
  static std::uint32_t left(std::uint32_t node) { return node + 1; }
  std::uint32_t right(std::uint32_t node) const { return node + 2 * nodes_[node + 1].count; }  // N1

 private:
  struct Area {
    double operator()(const Aabb& box) const { return half_area(box); }
  };

  /// Subtrees smaller than this are not worth a task.
  static constexpr std::uint32_t task_size = 4096;

  void grow(std::uint32_t node, std::uint32_t first, std::uint32_t count, int depth) {
    const std::span items = items_.part(first, count);
    const Aabb box = bounds_of(items);
    nodes_[node] = {box, count, 0};
    if (count == 1) return;
    const std::size_t chosen = depth < heuristic_depth ? splitter_.cheapest(items, box) : splitter_.median(items);
    const auto below = static_cast<std::uint32_t>(chosen);
    const auto grow_left = [&] { grow(node + 1, first, below, depth + 1); };
    const auto grow_right = [&] { grow(node + 2 * below, first + below, count - below, depth + 1); };
    if (count < task_size) {
      grow_left();
      grow_right();
    } else {
      tbb::parallel_invoke(grow_left, grow_right);
    }
  }

  ObjectSplitter<Area> splitter_;
  LargeBuffer<BoundsReference> items_;
  LargeBuffer<Node> nodes_;
};

}  // namespace sightline
