#pragma once
/// From the binary tree that a kd-tree's builder makes to treelets.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sightline/accel/kd_tree_treelet.h"
#include "sightline/accel/large_pages.h"
#include "sightline/math/aabb.h"

namespace sightline::detail {

/// Of the binary tree: a plane and the distance to the half above (the half below follows its parent), or a leaf's
/// range.
class KdNode {
 public:
  static constexpr std::size_t link_limit = (1u << 30) - 1;

  KdNode() = default;
  static KdNode inner(int axis, float plane, std::uint32_t to_above) {
    return {std::bit_cast<std::uint32_t>(plane), to_above << 2 | std::uint32_t(axis)};
  }
  static KdNode leaf(LeafRange range) { return {range.first, range.count << 2 | leaf_tag}; }

  bool is_leaf() const { return (link_ & leaf_tag) == leaf_tag; }
  int axis() const { return static_cast<int>(link_ & leaf_tag); }
  float plane() const { return std::bit_cast<float>(value_); }
  std::uint32_t to_above() const { return link_ >> 2; }
  LeafRange range() const { return {value_, link_ >> 2}; }

 private:
  static constexpr std::uint32_t leaf_tag = 3;
  KdNode(std::uint32_t value, std::uint32_t link) : value_(value), link_(link) {}
  std::uint32_t value_, link_;
};

/// Chooses which splits share a treelet, so that a random ray meets as few treelets as possible: the chance that it
/// meets one goes by the surface of its cell. The optimum is found from the leaves up, as for the wide trees of
/// Ylitie, Karras and Laine, "Efficient incoherent ray traversal on GPUs through compressed wide BVHs", 2017.
class KdPacking {
 public:
  /// `nodes` are depth first and not none; `bounds` are the root's cell.
  KdPacking(const std::vector<KdNode>& nodes, const Aabb& bounds) : nodes_(nodes), costs_(nodes.size()) {
    weigh(bounds);
  }

  /// The root comes first, and a treelet's children lie together.
  LargeVector<KdTreelet> pack() {
    treelets_.emplace_back();
    fill(0, 0);
    return {treelets_.begin(), treelets_.end()};  // without the spare room of growing
  }

 private:
  /// Treelets that a ray is expected to meet below a node with so many levels left in its parent's treelet.
  struct Costs {
    float apart;  ///< None: a treelet of its own.
    std::array<float, KdTreelet::levels - 1> within;
  };

  std::uint32_t below(std::uint32_t node) const { return node + 1; }
  std::uint32_t above(std::uint32_t node) const { return node + nodes_[node].to_above(); }

  float cost_of_halves(std::uint32_t node, int levels_left) const {
    const auto cost = [&](const Costs& half) { return levels_left == 0 ? half.apart : half.within[levels_left - 1]; };
    return cost(costs_[below(node)]) + cost(costs_[above(node)]);
  }
  /// Whether to place a node's split in its parent's treelet, of which so many levels are left.
  bool is_within(std::uint32_t node, int levels_left) const {
    return levels_left > 0 && !nodes_[node].is_leaf() && cost_of_halves(node, levels_left - 1) <= costs_[node].apart;
  }

  void weigh(const Aabb& bounds) {
    const double whole = half_area(bounds);
    std::vector<std::pair<std::uint32_t, Aabb>> stack{{0, bounds}};
    while (!stack.empty()) {
      const auto [node, cell] = stack.back();
      stack.pop_back();
      if (nodes_[node].is_leaf()) continue;
      costs_[node].apart = whole > 0 ? static_cast<float>(half_area(cell) / whole) : 1.0f;
      Aabb low = cell, high = cell;
      low.hi[nodes_[node].axis()] = high.lo[nodes_[node].axis()] = nodes_[node].plane();
      stack.push_back({above(node), high});
      stack.push_back({below(node), low});
    }
    for (auto node = static_cast<std::uint32_t>(nodes_.size()); node-- > 0;) {
      Costs& costs = costs_[node];
      if (nodes_[node].is_leaf()) {
        costs = {};
        continue;
      }
      costs.apart += cost_of_halves(node, KdTreelet::levels - 1);
      for (int left = 1; left < KdTreelet::levels; ++left) {
        costs.within[left - 1] = std::min(costs.apart, cost_of_halves(node, left - 1));
      }
    }
  }

  std::uint32_t allot(std::size_t count) {
    const std::size_t first = treelets_.size();
    if (first + count > KdChild::treelet_limit) throw std::length_error("kd-tree: more nodes than can be numbered");
    treelets_.resize(first + count);
    return static_cast<std::uint32_t>(first);
  }

  void fill(std::uint32_t treelet, std::uint32_t root) {
    KdTreelet made;
    made.planes.fill(std::numeric_limits<float>::infinity());
    made.axes = 0;
    made.children.fill(KdChild::none());
    std::array<std::uint32_t, KdTreelet::width> roots;
    std::uint32_t apart = 0;  // bits of the children that are treelets
    place(root, 0, KdTreelet::levels, made, roots, apart);
    if (apart != 0) {
      const std::uint32_t first = allot(static_cast<std::size_t>(std::popcount(apart)));
      std::uint32_t next = first;
      for (std::uint32_t child = 0; child < KdTreelet::width; ++child) {
        if (apart >> child & 1) made.children[child] = KdChild::treelet(next++);
      }
      next = first;
      for (std::uint32_t child = 0; child < KdTreelet::width; ++child) {
        if (apart >> child & 1) fill(next++, roots[child]);
      }
    }
    treelets_[treelet] = made;
  }

  /// Places the subtree of `node` where the plane or child is that the heap numbers `at`.
  void place(std::uint32_t node, int at, int levels_left, KdTreelet& made,
             std::array<std::uint32_t, KdTreelet::width>& roots, std::uint32_t& apart) {
    if (levels_left == KdTreelet::levels ? !nodes_[node].is_leaf() : is_within(node, levels_left)) {
      made.planes[at] = nodes_[node].plane();
      made.set_axis(at, nodes_[node].axis());
      place(below(node), KdTreelet::below(at), levels_left - 1, made, roots, apart);
      place(above(node), KdTreelet::above(at), levels_left - 1, made, roots, apart);
      return;
    }
    for (; levels_left > 0; --levels_left) at = KdTreelet::below(at);
    const int child = at - KdTreelet::plane_count;
    if (nodes_[node].is_leaf()) {
      made.children[child] = leaf(nodes_[node].range());
    } else {
      roots[child] = node;
      apart |= 1u << child;
    }
  }

  /// A leaf that is too large for one child becomes a treelet that every ray goes through.
  KdChild leaf(LeafRange range) {
    if (range.count <= KdChild::count_limit) return KdChild::leaf(range);
    const std::uint32_t treelet = allot(1);
    KdTreelet made;
    made.planes.fill(std::numeric_limits<float>::quiet_NaN());
    made.axes = 0;
    const std::uint32_t share = (range.count + 63) / 64 * 8;  // whole blocks of eight, as leaves are tested
    for (KdChild& child : made.children) {
      const std::uint32_t count = std::min(share, range.count);
      child = leaf({range.first, count});
      range = {range.first + count, range.count - count};
    }
    treelets_[treelet] = made;
    return KdChild::treelet(treelet);
  }

  const std::vector<KdNode>& nodes_;
  std::vector<Costs> costs_;
  LargeVector<KdTreelet> treelets_;
};

}  // namespace sightline::detail
