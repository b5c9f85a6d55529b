#pragma once
/// The binary tree of boxes from which wide ones are made.

#include <tbb/parallel_invoke.h>

#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "sightline/accel/bounds_reference.h"
#include "sightline/accel/large_pages.h"
#include "sightline/accel/object_split.h"
#include "sightline/accel/object_sweep.h"
#include "sightline/accel/reference_sweep.h"

namespace sightline {

/// Divided by the surface area heuristic down to single primitives, or at the quality `fast` to leaves of several.
///   N1  A subtree of n primitives has 2 n - 1 places: its root, then the left child's, then the right child's. So
///       subtrees are built apart without moving them, and no node needs a link. Leaves of several leave places empty.
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

  /// Of references, whose ids may repeat. `bins`: on each axis, when many are divided. `leaf_size`: of the quality
  /// `fast`.
  BinaryTree(LargeBuffer<BoundsReference> references, Quality quality, int bins, int leaf_size)
      : order(references.size()), costs_{1, 1, quality == Quality::fast ? leaf_size : 1, bins, quality} {
    const std::size_t count = references.size();
    if (count == 0) return;
    nodes_ = LargeBuffer<Node>(2 * count - 1);
    if (quality == Quality::best) {
      ReferenceSweep<HalfArea> sweep(std::move(references), costs_);
      grow(sweep, sweep.whole(), 0, 0, 0);
    } else {
      ObjectSplitter<HalfArea> splitter(costs_);
      grow(splitter, whole_of(references.part(0, count)), 0, 0, 0);
    }
  }

  std::vector<std::uint32_t> order;  ///< Ids by position (N2).

  bool is_empty() const { return nodes_.size() == 0; }
  Node& operator[](std::uint32_t node) { return nodes_[node]; }
  const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  bool is_leaf(std::uint32_t node) const {
    return nodes_[node].count <= static_cast<std::uint32_t>(costs_.max_leaf_size);
  }
  static std::uint32_t left(std::uint32_t node) { return node + 1; }
  std::uint32_t right(std::uint32_t node) const { return node + 2 * nodes_[node + 1].count; }  // N1

 private:
  using Sweep = ObjectSweep<HalfArea>;

  /// Subtrees smaller than this are not worth a task.
  static constexpr std::uint32_t task_size = 4096;

  template <class Divider, class Part>
  void grow(Divider& divider, const Part& part, std::uint32_t node, std::uint32_t first, int depth) {
    if constexpr (!std::is_same_v<Divider, Sweep>) {
      if (part.count() <= Sweep::most && costs_.quality != Quality::fast) {
        Sweep sweep(part.references(), costs_);
        return grow(sweep, sweep.whole(), node, first, depth);
      }
    }
    nodes_[node] = {part.box(), part.count(), 0};
    const auto halves = depth < heuristic_depth ? divider.cheapest(part) : divider.median(part);
    if (!halves) {
      for (std::uint32_t i = 0; i < part.count(); ++i) order[first + i] = part.id(i);
      return;
    }
    const std::uint32_t below = halves->below.count();
    const auto grow_below = [&] { grow(divider, halves->below, node + 1, first, depth + 1); };
    const auto grow_above = [&] { grow(divider, halves->above, node + 2 * below, first + below, depth + 1); };
    if (part.count() < task_size) {
      grow_below();
      grow_above();
    } else {
      tbb::parallel_invoke(grow_below, grow_above);
    }
  }

  ObjectSplitCosts costs_;
  LargeBuffer<Node> nodes_;
};

}  // namespace sightline
