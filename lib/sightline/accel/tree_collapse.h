#pragma once
/// Making a wide tree of a binary one.

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "sightline/accel/binary_tree.h"

namespace sightline {

/// Relative to each other.
struct CollapseCosts {
  double node;  ///< Opening a wide node.
  double leaf;  ///< Testing a leaf, however full.
  int max_leaf_size;
};

/// Chooses which nodes of a binary tree are kept, so that the wide tree made of them costs least by the surface area
/// heuristic. The cheapest forest of at most i roots that stands for a subtree follows from those of its children; so
/// do the leaves, which are subtrees cut off.
/// Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", 2017.
template <int Width>
class TreeCollapse {
 public:
  /// Writes the choices into the tree's notes.
  TreeCollapse(BinaryTree& tree, const CollapseCosts& costs) : tree_(tree), costs_(costs) {
    if (!tree.is_empty()) plan(0);
  }

  /// Whether the subtree of `node`, when it stands alone, becomes a leaf.
  bool is_leaf(std::uint32_t node) const { return tree_[node].note & leaf_bit; }

  struct Children {
    std::array<std::uint32_t, Width> nodes;
    int count = 0;
  };
  /// What becomes the children, at most Width, of the wide node that stands for `node`; from left to right.
  Children children(std::uint32_t node) const {
    Children all;
    if (is_leaf(node)) {
      all.nodes[all.count++] = node;
    } else {
      divide(node, Width, all);
    }
    return all;
  }

 private:
  /// Least cost of a subtree as at most i + 1 roots.
  using ForestCosts = std::array<double, Width - 1>;

  static constexpr std::uint32_t task_size = 4096;
  static constexpr std::uint32_t leaf_bit = 1;

  // Three bits of the note for each number of roots from 2 to Width: how many of them are the left child's; 0 where one
  // root less costs no more.
  static std::uint32_t share_bits(std::uint32_t share, int roots) { return share << (1 + 3 * (roots - 2)); }
  int share(std::uint32_t node, int roots) const {
    return static_cast<int>(tree_[node].note >> (1 + 3 * (roots - 2)) & 7);
  }
  static_assert(Width <= 8 && 1 + 3 * (Width - 1) <= 32);

  ForestCosts plan(std::uint32_t node) {
    BinaryTree::Node& here = tree_[node];
    const double area = half_area(here.box);
    const double as_leaf = here.count <= static_cast<std::uint32_t>(costs_.max_leaf_size)
                               ? costs_.leaf * area
                               : std::numeric_limits<double>::infinity();
    ForestCosts costs;
    if (tree_.is_leaf(node)) {
      costs.fill(as_leaf);
      here.note = leaf_bit;
      return costs;
    }
    ForestCosts left, right;
    const auto plan_left = [&] { left = plan(tree_.left(node)); };
    const auto plan_right = [&] { right = plan(tree_.right(node)); };
    if (here.count < task_size) {
      plan_left();
      plan_right();
    } else {
      tbb::parallel_invoke(plan_left, plan_right);
    }
    // More roots than primitives are no use.
    const int left_most = most_roots(tree_.left(node)), right_most = most_roots(tree_.right(node));
    const int most = std::min(left_most + right_most, Width);
    std::uint32_t note = 0;
    std::array<double, Width + 1> divided;
    std::array<std::uint32_t, Width + 1> shares;
    for (int roots = 2; roots <= most; ++roots) {
      divided[roots] = std::numeric_limits<double>::infinity();
      shares[roots] = 1;
      for (int to_left = std::max(1, roots - right_most); to_left <= std::min(roots - 1, left_most); ++to_left) {
        const double cost = left[to_left - 1] + right[roots - to_left - 1];
        if (!(cost < divided[roots])) continue;
        divided[roots] = cost;
        shares[roots] = static_cast<std::uint32_t>(to_left);
      }
    }
    std::fill(divided.begin() + most + 1, divided.end(), divided[most]);
    std::fill(shares.begin() + most + 1, shares.end(), shares[most]);
    const double as_node = divided[Width] + costs_.node * area;
    note |= share_bits(shares[Width], Width);
    if (as_leaf <= as_node) note |= leaf_bit;
    costs[0] = std::min(as_leaf, as_node);
    for (int roots = 2; roots < Width; ++roots) {
      costs[roots - 1] = std::min(divided[roots], costs[roots - 2]);
      if (divided[roots] < costs[roots - 2]) note |= share_bits(shares[roots], roots);
    }
    here.note = note;
    return costs;
  }

  int most_roots(std::uint32_t node) const {
    if (tree_.is_leaf(node)) return 1;
    return static_cast<int>(std::min(tree_[node].count, static_cast<std::uint32_t>(Width)));
  }

  void divide(std::uint32_t node, int roots, Children& all) const {
    const int to_left = share(node, roots);
    gather(tree_.left(node), to_left, all);
    gather(tree_.right(node), roots - to_left, all);
  }

  /// Appends the roots of the forest of at most `roots` that stands for `node`.
  void gather(std::uint32_t node, int roots, Children& all) const {
    while (roots > 1 && share(node, roots) == 0) --roots;
    if (roots == 1) {
      all.nodes[all.count++] = node;
    } else {
      divide(node, roots, all);
    }
  }

  BinaryTree& tree_;
  CollapseCosts costs_;
};

}  // namespace sightline
