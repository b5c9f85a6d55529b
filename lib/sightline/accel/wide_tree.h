#pragma once

#include <array>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/large_pages.h"
#include "sightline/accel/reference_split.h"
#include "sightline/accel/wide_tree_builder.h"
#include "sightline/accel/wide_tree_packet.h"
#include "sightline/accel/wide_tree_walk.h"

namespace sightline {

struct WideTreeOptions {
  int max_leaf_size = 8;        ///< Leaves are tested whole: eight triangles cost hardly more than one.
  float traversal_cost = 1;     ///< Opening a node: testing the boxes of eight children at once.
  float intersection_cost = 1;  ///< Testing a leaf.
  int bins = 32;                ///< On each axis, when many primitives are divided.
  int splits = 0;               ///< References that long primitives may have beyond one each, in percent of all.

  static constexpr std::array<OptionField<WideTreeOptions>, 5> fields() {
    using O = WideTreeOptions;
    return {{{"max_leaf_size", &O::max_leaf_size, 1, 8, "most primitives in a leaf"},
             {"traversal_cost", &O::traversal_cost, 0, 1000, "cost of testing the boxes of eight children"},
             {"intersection_cost", &O::intersection_cost, 0.001, 1000, "cost of testing a leaf"},
             {"bins", &O::bins, 2, max_split_bins, "intervals of each axis between which a large node is divided"},
             {"splits", &O::splits, 0, 1000, "most references added for long primitives, in percent of all"}}};
  }
};

/// Bounding boxes, eight to a node, so that one SIMD register tests a plane of each.
///   W1  A child's box contains its references: a primitive is in exactly one leaf, or, where it was split
///       (reference_split.h), in one or more, at most once in each, whose boxes cover it together.
///   W2  The inner children of a node stand side by side, and the leaves below it in order of position.
///   W3  A wide path is no longer than the binary one it was made of, and each node on it leaves at most width - 1
///       children waiting, so the traversal stack cannot overflow.
/// Wald, Benthin and Boulos, "Getting Rid of Packets: Efficient SIMD Single-Ray Traversal using Multi-branching BVHs",
/// 2008; Dammertz, Hanika and Keller, "Shallow Bounding Volume Hierarchies for Fast SIMD Ray Tracing of Incoherent
/// Rays", 2008; children in the order of the direction's octant: Garanzha and Loop, "Fast Ray Sorting and
/// Breadth-First Packet Traversal for GPU Ray Tracing", 2010, and Ylitie, Karras and Laine 2017 (tree_collapse.h).
class WideTree {
  using Node = WideNode;
  using Link = WideLink;
  static constexpr int width = Node::width;

 public:
  static constexpr std::string_view name = "wide-tree";
  static constexpr std::string_view description =
      "bounding boxes, eight to a node, collapsed at least cost; Wald et al. 2008, Ylitie et al. 2017";
  static constexpr std::size_t node_bytes = sizeof(Node);
  using Options = WideTreeOptions;

  /// \throws std::invalid_argument for options out of their limits, std::length_error for more primitives than links
  /// can number (2^28).
  static WideTree build(const Primitives& primitives, const Options& options = {});

  std::size_t memory_bytes() const { return nodes_.size() * sizeof(Node) + order_.size() * sizeof(std::uint32_t); }
  std::span<const std::uint32_t> leaf_order() const { return order_; }
  bool is_order_final() const { return true; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const;

  template <class T>
  class Walk;

  /// Rays that begin together, for processors with eight lanes.
  template <class T>
  requires wide_has_slabs<T>
  class Packet : public WidePacket<T> {
   public:
    Packet(const WideTree& tree, std::span<const Ray<T>> rays) : WidePacket<T>(tree.nodes_, tree.bounds_, rays) {}
  };

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
        if (Link::is_leaf(link) && link != Link::none) see(Link::leaf(link));
      }
    }
  }

 private:
  template <class See>
  void see_cells(const Aabb& box, std::uint32_t link, int depth, See& see) const {
    const bool is_leaf = Link::is_leaf(link);
    see(Cell{box, depth, is_leaf, is_leaf ? Link::leaf(link) : LeafRange{}, Link::number(link, nodes_.size())});
    if (is_leaf) return;
    const Node& node = nodes_[Link::node(link)];
    for (int child = 0; child < width && node.links[child] != Link::none; ++child) {
      see_cells(node.box(child), node.links[child], depth + 1, see);
    }
  }

  /// Drops ids that repeat within a leaf.
  void merge_leaves() {
    LeafMerger merger(order_);
    merge_leaves_below(nodes_[0], merger);
    merger.finish();
  }
  void merge_leaves_below(Node& node, LeafMerger& merger) {  // in order of position: W2
    for (std::uint32_t& link : node.links) {
      if (!Link::is_leaf(link)) {
        merge_leaves_below(nodes_[Link::node(link)], merger);
      } else if (link != Link::none) {
        link = Link::to_leaf(merger.merge(Link::leaf(link)));
      }
    }
  }

  LargeBuffer<Node> nodes_;
  std::vector<std::uint32_t> order_;
  Aabb bounds_;
};

// ---- Traversal

/// With its stack.
template <class T>
class WideTree::Walk {
 public:
  Walk(const WideTree& tree, const Ray<T>& ray) : walk_(tree.nodes_, tree.bounds_, ray) {}

  /// Goes on alone from where the packet has come to.
  Walk(const WideTree& tree, const WidePacket<T>& packet, std::size_t ray)
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
  WideWalk<T, WideOpenerOf<T>> walk_;
};

template <class T, LeafVisitor<T> Visit, class Probe>
void WideTree::traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
  WideWalk<T, WideOpenerOf<T>> walk(nodes_, bounds_, ray);
  WideStack<T> stack;
  if (walk.serves()) {
    while (walk.step(stack, visit, probe)) walk.fetch_waiting(stack, visit);
  } else {
    WideWalk<T, WideOpener<T>> any_walk(nodes_, bounds_, ray);
    while (any_walk.step(stack, visit, probe)) {
    }
  }
}

// ---- Construction

inline WideTree WideTree::build(const Primitives& primitives, const Options& options) {
  validate(name, options);
  if (primitives.size() > Link::limit) throw std::length_error("wide-tree: more than 2^28 primitives");
  WideTree tree;
  BinaryTree binary(references_of(primitives, options.splits, Link::limit), options.bins);
  if (binary.is_empty()) return tree;
  tree.bounds_ = binary[0].box;
  const TreeCollapse<width> collapse(binary,
                                     {options.traversal_cost, options.intersection_cost, options.max_leaf_size});
  tree.nodes_ = WideTreeBuilder(binary, collapse).build();
  tree.order_ = std::move(binary.order);
  if (tree.order_.size() > primitives.size()) tree.merge_leaves();
  return tree;
}

static_assert(Accelerator<WideTree>);

}  // namespace sightline
