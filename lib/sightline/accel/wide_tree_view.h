#pragma once

#include <span>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/wide_tree_packet.h"
#include "sightline/accel/wide_tree_walk.h"

namespace sightline {

/// A wide tree as rays see it, whose nodes are of one kind. Refers to them.
template <class NodeType>
class WideTreeView {
 public:
  using Node = NodeType;

  WideTreeView(std::span<const Node> nodes, const Aabb& bounds) : nodes_(nodes), bounds_(bounds) {}

  /// Rays that begin together, for processors with eight lanes.
  template <class T>
  requires wide_has_slabs<T>
  class Packet : public WidePacket<T, Node> {
   public:
    Packet(const WideTreeView& tree, std::span<const Ray<T>> rays)
        : WidePacket<T, Node>(tree.nodes_, tree.bounds_, rays) {}
  };

  /// A ray on its way, with its stack.
  template <class T>
  class Walk {
   public:
    Walk(const WideTreeView& tree, const Ray<T>& ray) : walk_(tree.nodes_, tree.bounds_, ray) {}

    /// Goes on alone from where the packet has come to.
    Walk(const WideTreeView& tree, const WidePacket<T, Node>& packet, std::size_t ray)
        : walk_(tree.nodes_, {packet.slabs(ray), packet.t_min(ray), packet.t_max(ray)}, packet.start(ray, stack_)) {}

    /// False for a ray that `traverse` has to take.
    bool serves() const { return walk_.serves(); }

    template <LeafVisitor<T> Visit, class Probe>
    [[gnu::always_inline]] bool step(Visit&& visit, Probe& probe) {
      return walk_.step(stack_, visit, probe);
    }

    template <class Visit>
    void fetch_next(const Visit& visit) const {
      walk_.fetch_next(visit);
    }

   private:
    WideStack<T> stack_;
    WideWalk<T, WideOpenerOf<T, Node>> walk_;
  };

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
    WideWalk<T, WideOpenerOf<T, Node>> walk(nodes_, bounds_, ray);
    WideStack<T> stack;
    if (walk.serves()) {
      while (walk.step(stack, visit, probe)) walk.fetch_waiting(stack, visit);
    } else {
      WideWalk<T, WideOpener<T, Node>> any_walk(nodes_, bounds_, ray);
      while (any_walk.step(stack, visit, probe)) {
      }
    }
  }

  /// A node has the number of its place, a leaf that of its first position, counted on from the last node's.
  template <class See>
  void for_each_cell(See&& see) const {
    if (!nodes_.empty()) see_cells(bounds_, 0, 0, see);
  }

  /// See for_each_leaf in accelerator.h.
  template <class See>
  void for_each_leaf(See&& see) const {
    for (const Node& node : nodes_) {
      for (const std::uint32_t link : node.links) {
        if (WideLink::is_leaf(link) && link != WideLink::none) see(WideLink::leaf(link));
      }
    }
  }

 private:
  template <class See>
  void see_cells(const Aabb& box, std::uint32_t link, int depth, See& see) const {
    const bool is_leaf = WideLink::is_leaf(link);
    see(Cell{box, depth, is_leaf, is_leaf ? WideLink::leaf(link) : LeafRange{}, WideLink::number(link, nodes_.size())});
    if (is_leaf) return;
    const Node& node = nodes_[WideLink::node(link)];
    for (int child = 0; child < Node::width && node.links[child] != WideLink::none; ++child) {
      see_cells(node.box(child), node.links[child], depth + 1, see);
    }
  }

  std::span<const Node> nodes_;
  const Aabb& bounds_;
};

}  // namespace sightline
