#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

#include "sightline/accel/binary_tree.h"
#include "sightline/accel/large_pages.h"
#include "sightline/accel/tree_collapse.h"
#include "sightline/accel/wide_tree_node.h"

namespace sightline {

/// Makes the nodes of a wide tree; W2 says how they stand.
class WideTreeBuilder {
 public:
  WideTreeBuilder(const BinaryTree& binary, const TreeCollapse<WideNode::width>& collapse, LargeVector<WideNode>& nodes)
      : binary_(binary), collapse_(collapse), nodes_(nodes) {}

  void build() {
    nodes_.emplace_back();
    make(0, 0, 0);
    nodes_.shrink_to_fit();
  }

 private:
  static constexpr int width = WideNode::width;

  /// Makes the wide node `index` of a binary one whose primitives begin at position `first`.
  void make(std::uint32_t index, std::uint32_t root, std::uint32_t first) {
    const auto children = collapse_.children(root);
    const std::uint32_t first_child = static_cast<std::uint32_t>(nodes_.size());
    std::uint32_t inner_count = 0;
    WideNode node;
    for (int child = 0; child < width; ++child) node.set(child, Aabb(), WideLink::none);
    std::array<std::uint32_t, width> positions;
    for (int child = 0; child < children.count; ++child) {
      const BinaryTree::Node& from = binary_[children.nodes[child]];
      positions[child] = first;
      const bool is_leaf = collapse_.is_leaf(children.nodes[child]);
      node.set(child, from.box,
               is_leaf ? WideLink::to_leaf({first, from.count}) : WideLink::to_node(first_child + inner_count++));
      first += from.count;
    }
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
      node.orders[octant] = order_along(node, children.count, octant);
    }
    nodes_[index] = node;
    nodes_.resize(nodes_.size() + inner_count);
    for (int child = 0; child < children.count; ++child) {
      const std::uint32_t link = node.links[child];
      if (!WideLink::is_leaf(link)) make(WideLink::node(link), children.nodes[child], positions[child]);
    }
  }

  /// By the middles of the boxes along the octant's diagonal; children that are none come first.
  static std::uint32_t order_along(const WideNode& node, int count, std::uint32_t octant) {
    std::array<std::pair<double, std::uint32_t>, width> reach;
    for (int child = 0; child < width; ++child) {
      double sum = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double middle = double(node.plane(axis, child)) + double(node.plane(axis + 3, child));
        sum += octant >> axis & 1 ? middle : -middle;
      }
      reach[child] = {child < count ? sum : -std::numeric_limits<double>::infinity(), child};
    }
    std::sort(reach.begin(), reach.end());
    std::uint32_t order = 0;
    for (int i = 0; i < width; ++i) order |= reach[i].second << (3 * i);
    return order;
  }

  const BinaryTree& binary_;
  const TreeCollapse<WideNode::width>& collapse_;
  LargeVector<WideNode>& nodes_;
};

}  // namespace sightline
