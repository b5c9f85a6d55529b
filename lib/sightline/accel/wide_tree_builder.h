#pragma once

#include <tbb/parallel_for.h>

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "sightline/accel/binary_tree.h"
#include "sightline/accel/large_pages.h"
#include "sightline/accel/tree_collapse.h"
#include "sightline/accel/wide_tree_node.h"

namespace sightline {

/// Makes the nodes of a wide tree; W2 says how they stand. Small subtrees are counted first, so that each knows its
/// place and can be made on its own.
class WideTreeBuilder {
 public:
  WideTreeBuilder(const BinaryTree& binary, const TreeCollapse<WideNode::width>& collapse)
      : binary_(binary), collapse_(collapse) {}

  LargeBuffer<WideNode> build() {
    std::uint32_t size = list_subtrees(0);
    tbb::parallel_for(std::size_t{0}, subtrees_.size(),
                      [&](std::size_t i) { subtrees_[i].size = count_nodes(subtrees_[i].root); });
    for (const Subtree& subtree : subtrees_) size += subtree.size;
    nodes_ = LargeBuffer<WideNode>(size);
    std::uint32_t next = 1;
    auto subtree = subtrees_.begin();
    make(0, 0, 0, next, [&](std::uint32_t index, std::uint32_t root, std::uint32_t first) {
      if (!is_small(root)) return false;
      subtree->index = index;
      subtree->first = first;
      subtree->next = next;
      next += subtree->size - 1;
      ++subtree;
      return true;
    });
    tbb::parallel_for(std::size_t{0}, subtrees_.size(), [&](std::size_t i) {
      Subtree& part = subtrees_[i];
      make(part.index, part.root, part.first, part.next, [](auto...) { return false; });
    });
    return std::move(nodes_);
  }

 private:
  static constexpr int width = WideNode::width;

  struct Subtree {
    std::uint32_t root;       ///< In the binary tree.
    std::uint32_t size = 0;   ///< Wide nodes.
    std::uint32_t index = 0;  ///< Of the wide node that stands for the root.
    std::uint32_t first = 0;  ///< Position of the first primitive.
    std::uint32_t next = 0;   ///< Of the places for the nodes below.
  };

  /// Whether its subtree is not worth dividing between tasks.
  bool is_small(std::uint32_t root) const { return binary_[root].count < 4096; }

  template <class See>
  void for_each_inner_child(std::uint32_t root, See&& see) const {
    const auto children = collapse_.children(root);
    for (int child = 0; child < children.count; ++child) {
      if (!collapse_.is_leaf(children.nodes[child])) see(children.nodes[child]);
    }
  }

  /// In the order in which `make` comes to them. Returns the number of wide nodes that are in none.
  std::uint32_t list_subtrees(std::uint32_t root) {
    std::uint32_t count = 1;
    for_each_inner_child(root, [&](std::uint32_t child) {
      if (is_small(child)) {
        subtrees_.push_back({child});
      } else {
        count += list_subtrees(child);
      }
    });
    return count;
  }

  std::uint32_t count_nodes(std::uint32_t root) const {
    std::uint32_t count = 1;
    for_each_inner_child(root, [&](std::uint32_t child) { count += count_nodes(child); });
    return count;
  }

  /// Makes the wide node `index` of a binary one whose primitives begin at position `first`, and those below it, which
  /// take the places from `next` on, but for those that put_off(index, root, first) takes.
  template <class PutOff>
  void make(std::uint32_t index, std::uint32_t root, std::uint32_t first, std::uint32_t& next, PutOff&& put_off) {
    const auto children = collapse_.children(root);
    WideNode& node = nodes_[index];
    for (int child = 0; child < width; ++child) node.set(child, Aabb(), WideLink::none);
    std::array<std::uint32_t, width> positions;
    for (int child = 0; child < children.count; ++child) {
      const BinaryTree::Node& from = binary_[children.nodes[child]];
      positions[child] = first;
      const bool is_leaf = collapse_.is_leaf(children.nodes[child]);
      node.set(child, from.box, is_leaf ? WideLink::to_leaf({first, from.count}) : WideLink::to_node(next++));
      first += from.count;
    }
    set_orders(node, children.count);
    for (int child = 0; child < children.count; ++child) {
      const std::uint32_t link = node.links[child];
      if (WideLink::is_leaf(link)) continue;
      const std::uint32_t below = WideLink::node(link), from = children.nodes[child];
      if (!put_off(below, from, positions[child])) make(below, from, positions[child], next, put_off);
    }
  }

  /// By the middles of the boxes along the octant's diagonal; children that are none come first.
  static void set_orders(WideNode& node, int count) {
    std::array<std::array<double, width>, 3> middles;
    for (int axis = 0; axis < 3; ++axis) {
      for (int child = 0; child < width; ++child) {
        middles[axis][child] = double(node.plane(axis, child)) + double(node.plane(axis + 3, child));
      }
    }
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      std::array<double, width> reach;
      for (int child = 0; child < width; ++child) {
        double sum = 0;
        for (int axis = 0; axis < 3; ++axis) sum += octant >> axis & 1 ? middles[axis][child] : -middles[axis][child];
        reach[child] = child < count ? sum : -std::numeric_limits<double>::infinity();
      }
      std::uint32_t order = 0;
      for (int child = 0; child < width; ++child) {
        std::uint32_t rank = 0;
        for (int other = 0; other < width; ++other) {
          rank += reach[other] < reach[child] || (reach[other] == reach[child] && other < child);
        }
        order |= static_cast<std::uint32_t>(child) << (3 * rank);
      }
      node.orders[octant] = order;
    }
  }

  const BinaryTree& binary_;
  const TreeCollapse<WideNode::width>& collapse_;
  std::vector<Subtree> subtrees_;
  LargeBuffer<WideNode> nodes_;
};

}  // namespace sightline
