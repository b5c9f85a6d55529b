#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/kd_tree_builder.h"
#include "sightline/accel/kd_tree_packing.h"
#include "sightline/accel/kd_tree_ray.h"
#include "sightline/accel/large_pages.h"

namespace sightline {

struct KdTreeOptions {
  Quality quality = Quality::balanced;  ///< See KdTree.
  int max_leaf_size = 24;               ///< A cell that holds no more is never split.
  float traversal_cost = 1;             ///< One plane test, relative to ...
  float intersection_cost = 0.25f;      ///< ... one primitive test; eight are made at once.
  float empty_bonus = 0.2f;             ///< Share of the cost that a split is spared when it cuts off empty space.
  int max_depth = 0;                    ///< 0: 8 + 1.3 log2(primitives), 8 + 2 log2(primitives) for `best`.

  static constexpr std::array<OptionField<KdTreeOptions>, 6> fields() {
    using O = KdTreeOptions;
    return {{{"quality", &O::quality, 0, 2, "fast: planes along the widest axis; best: deeper, more references"},
             {"max_leaf_size", &O::max_leaf_size, 1, 1024, "a cell that holds no more is never split"},
             {"traversal_cost", &O::traversal_cost, 0, 1000, "cost of one plane test"},
             {"intersection_cost", &O::intersection_cost, 0.001, 1000, "cost of one primitive test"},
             {"empty_bonus", &O::empty_bonus, 0, 0.99, "share of the cost spared by cutting off empty space"},
             {"max_depth", &O::max_depth, 0, 64, "longest path of splits; 0 chooses"}}};
  }
};

/// Kd-tree: space halved by axis-aligned planes, chosen by the surface area heuristic.
///   K1  Two children tile their parent's cell; the root's cell is the bounds of the scene.
///   K2  Up to three levels of splits share a treelet; its children are treelets or leaves, in the order of space.
///   K3  No path makes more than max_depth <= 64 splits, so the traversal stack cannot overflow.
///   K4  A leaf refers to every primitive with a point in its cell, the part of one that a plane cuts being on both
///       sides of it; a primitive that only touches a plane is on its own side.
///   K5  There are at most 64 references for each primitive, 256 in the quality `best`; scanned meshes need two.
/// The quality `fast` seeks planes along the widest axis of each cell, as long as one there is worth it, `balanced` and
/// `best` along all axes. `best` also allows deeper trees and more references, which differ where long thin primitives
/// lie askew. There every single plane brings as much work as it saves, so that a greedy choice ends at the root, while
/// halving across three axes in turn leaves three quarters of the work: a crowded cell that no plane makes cheaper is
/// halved all the same, at the price of memory.
/// Wald and Havran, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)", 2006.
class KdTree {
 public:
  static constexpr std::string_view name = "kd-tree";
  static constexpr std::string_view description =
      "space halved by axis-aligned planes, surface area heuristic, clipped straddlers (Wald and Havran 2006)";
  static constexpr std::size_t node_bytes = sizeof(detail::KdTreelet);
  using Options = KdTreeOptions;

  /// \throws std::length_error for more than 2^26 primitives.
  static KdTree build(const Primitives& primitives, const Options& options = {});

  std::size_t memory_bytes() const { return treelets_.size() * sizeof(Treelet) + order_.size() * sizeof(order_[0]); }
  std::span<const std::uint32_t> leaf_order() const { return order_; }
  bool is_order_final() const { return true; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const;

  template <class See>
  void for_each_cell(See&& see) const {
    if (!treelets_.empty()) show(0, 0, bounds_, 0, see);
  }

  template <class See>
  void for_each_leaf(See&& see) const {
    for (const Treelet& treelet : treelets_) {
      for (const Child child : treelet.children) {
        if (child.is_leaf()) see(child.range());
      }
    }
  }

 private:
  using Treelet = detail::KdTreelet;
  using Child = detail::KdChild;

  /// Numbers of cells: a leaf goes by its first position, what else a treelet holds by its place in the heap.
  static std::uint32_t number_of(std::uint32_t treelet, int place) {
    return treelet << 4 | static_cast<std::uint32_t>(place);
  }
  static std::uint32_t number_of(Child child) {
    return child.is_leaf() ? 1u << 31 | child.range().first : number_of(child.treelet(), 0);
  }

  template <class See>
  void show(std::uint32_t index, int place, const Aabb& cell, int depth, See& see) const {
    const Treelet& treelet = treelets_[index];
    while (place < Treelet::plane_count && !treelet.is_split(place)) place = Treelet::below(place);
    if (place < Treelet::plane_count) {
      see(Cell{cell, depth, false, {}, number_of(index, place)});
      Aabb below = cell, above = cell;
      const float plane = treelet.planes[place];
      if (!std::isnan(plane)) below.hi[treelet.axis(place)] = above.lo[treelet.axis(place)] = plane;  // K1
      show(index, Treelet::below(place), below, depth + 1, see);
      show(index, Treelet::above(place), above, depth + 1, see);
      return;
    }
    const Child child = treelet.children[place - Treelet::plane_count];
    if (child.is_empty()) {
      see(Cell{cell, depth, true, {}, number_of(index, place)});
    } else if (child.is_leaf()) {
      see(Cell{cell, depth, true, child.range(), number_of(child)});
    } else {
      show(child.treelet(), 0, cell, depth, see);
    }
  }

  LargeVector<Treelet> treelets_;
  LargeVector<std::uint32_t> order_;
  Aabb bounds_;
};

// ---- Traversal

template <class T, LeafVisitor<T> Visit, class Probe>
void KdTree::traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
  if (treelets_.empty()) return;
  const detail::KdRayOf<T> splits(ray, bounds_);
  if (splits.range().is_empty()) return;

  detail::KdStack<T> stack;  // K3
  Child next = Child::treelet(0);
  T t_enter = splits.range().lo, t_leave = splits.range().hi, t_far = ray.t_max;
  for (;;) {
    if (next.is_leaf()) {
      const LeafRange leaf = next.range();
      probe.leaf(number_of(next), leaf, t_enter);
      t_far = visit(leaf);
    } else {
      probe.node(number_of(next), t_enter);
      splits.step(treelets_[next.treelet()], t_enter, t_leave, stack);
    }

    for (;;) {
      if (stack.size == 0) return;
      const std::size_t top = --stack.size;
      next = stack.children[top];
      t_enter = stack.enters[top];
      if (!(t_enter > t_far)) {
        t_leave = stack.leaves[top] < t_far ? stack.leaves[top] : t_far;
        break;
      }
      probe.cull(number_of(next), t_enter);  // and go on: halves overlap, so one put aside earlier may begin sooner
    }
  }
}

// ---- Construction

inline KdTree KdTree::build(const Primitives& primitives, const Options& options) {
  validate(name, options);
  KdTree tree;
  if (primitives.size() == 0) return tree;
  const bool is_best = options.quality == Quality::best;
  const int usual_depth = static_cast<int>(8 + (is_best ? 2 : 1.3) * std::log2(primitives.size()));
  const detail::KdSettings settings{
      .max_leaf_size = static_cast<std::uint32_t>(options.max_leaf_size),
      .max_depth = options.max_depth > 0 ? options.max_depth : usual_depth,
      .costs = {options.traversal_cost, options.intersection_cost, 1 - double(options.empty_bonus)},
      .reference_limit = is_best ? 256u : 64u,
      .is_widest_only = options.quality == Quality::fast};
  const detail::KdSubtree binary = detail::KdTreeBuilder(primitives, settings).build(tree.bounds_);
  tree.treelets_ = detail::KdPacking(binary.nodes, tree.bounds_).pack();
  tree.order_.assign(binary.order.begin(), binary.order.end());  // without the spare room of growing
  return tree;
}

static_assert(Accelerator<KdTree>);

}  // namespace sightline
