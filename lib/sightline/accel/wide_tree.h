#pragma once

#include <tbb/parallel_for.h>

#include <array>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/large_pages.h"
#include "sightline/accel/reference_split.h"
#include "sightline/accel/wide_tree_builder.h"
#include "sightline/accel/wide_tree_compressed.h"
#include "sightline/accel/wide_tree_view.h"

namespace sightline {

struct WideTreeOptions {
  Quality quality = Quality::balanced;  ///< `fast` weighs cuts along one axis only, `best` all there are.
  int max_leaf_size = 8;                ///< Leaves are tested whole: eight triangles cost hardly more than one.
  float traversal_cost = 1;             ///< Opening a node: testing the boxes of eight children at once.
  float intersection_cost = 1;          ///< Testing a leaf.
  int bins = 32;                        ///< On each axis, when many primitives are divided.
  int splits = -1;          ///< References that long primitives may have beyond one each, in percent of all.
  bool compressed = false;  ///< Nodes of half the size, whose boxes are a little larger (wide_tree_compressed.h).

  static constexpr std::array<OptionField<WideTreeOptions>, 7> fields() {
    using O = WideTreeOptions;
    return {{{"quality", &O::quality, 0, 2, object_quality_help},
             {"max_leaf_size", &O::max_leaf_size, 1, 8, "most primitives in a leaf"},
             {"traversal_cost", &O::traversal_cost, 0, 1000, "cost of testing the boxes of eight children"},
             {"intersection_cost", &O::intersection_cost, 0.001, 1000, "cost of testing a leaf"},
             {"bins", &O::bins, 2, max_split_bins, object_bins_help},
             {"splits", &O::splits, -1, 1000, reference_splits_help},
             {"compressed", &O::compressed, 0, 1, "nodes of half the size, whose boxes are a little larger"}}};
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

 public:
  static constexpr std::string_view name = "wide-tree";
  static constexpr std::string_view description =
      "bounding boxes, eight to a node, collapsed at least cost; Wald et al. 2008, Ylitie et al. 2017";
  static constexpr std::size_t node_bytes = sizeof(Node);  ///< Half of that for compressed ones.
  using Options = WideTreeOptions;

  /// \throws std::invalid_argument for options out of their limits, std::length_error for more primitives than links
  /// can number (2^28).
  static WideTree build(const Primitives& primitives, const Options& options = {});

  /// See accelerator.h. The order in which rays take the children of a node stays as it was.
  static WideTree refit(WideTree tree, const Primitives& primitives);
  bool can_refit() const { return true; }

  std::size_t memory_bytes() const {
    return nodes_.size() * sizeof(Node) + compressed_.size() * sizeof(CompressedWideNode) +
           order_.size() * sizeof(std::uint32_t);
  }
  std::span<const std::uint32_t> leaf_order() const { return order_; }
  bool is_order_final() const { return true; }

  /// Returns use(view) of what rays go through.
  template <class Use>
  [[gnu::always_inline]] decltype(auto) with_view(Use&& use) const {
    if (compressed_.empty()) return use(WideTreeView<Node>({nodes_.data(), nodes_.size()}, bounds_));
    return use(WideTreeView<CompressedWideNode>({compressed_.data(), compressed_.size()}, bounds_));
  }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
    with_view([&](const auto& view) { view.traverse(ray, visit, probe); });
  }

  template <class See>
  void for_each_cell(See&& see) const {
    with_view([&](const auto& view) { view.for_each_cell(see); });
  }

  template <class See>
  void for_each_leaf(See&& see) const {
    with_view([&](const auto& view) { view.for_each_leaf(see); });
  }

 private:
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

  /// Bounds each child anew, those of later nodes first: no node stands before its parent.
  template <class N>
  void refit(LargeBuffer<N>& nodes, const Primitives& primitives) {
    for (std::size_t i = nodes.size(); i-- > 0;) {
      std::array<Aabb, N::width> boxes;
      for (int child = 0; child < N::width; ++child) {
        const std::uint32_t link = nodes[i].links[child];
        if (link == Link::none) continue;
        boxes[child] =
            Link::is_leaf(link) ? bounds_of(primitives, order_, Link::leaf(link)) : nodes[Link::node(link)].bounds();
      }
      nodes[i].set_boxes(boxes);
    }
    if (nodes.size() > 0) bounds_ = nodes[0].bounds();
  }

  void compress() {
    compressed_ = LargeBuffer<CompressedWideNode>(nodes_.size());
    tbb::parallel_for(std::size_t{0}, nodes_.size(),
                      [&](std::size_t i) { compressed_[i] = CompressedWideNode::of(nodes_[i]); });
    nodes_ = {};
  }

  LargeBuffer<Node> nodes_;
  LargeBuffer<CompressedWideNode> compressed_;  ///< Instead of nodes_.
  std::vector<std::uint32_t> order_;
  Aabb bounds_;
};

// ---- Construction

inline WideTree WideTree::build(const Primitives& primitives, const Options& options) {
  validate(name, options);
  if (primitives.size() > Link::limit) throw std::length_error("wide-tree: more than 2^28 primitives");
  WideTree tree;
  const int splits = splits_of(primitives, options.splits, options.quality);
  BinaryTree binary(references_of(primitives, splits, Link::limit), options.quality, options.bins,
                    options.max_leaf_size);
  if (binary.is_empty()) return tree;
  tree.bounds_ = binary[0].box;
  const TreeCollapse<Node::width> collapse(binary,
                                           {options.traversal_cost, options.intersection_cost, options.max_leaf_size});
  tree.nodes_ = WideTreeBuilder(binary, collapse).build();
  tree.order_ = std::move(binary.order);
  if (tree.order_.size() > primitives.size()) tree.merge_leaves();
  if (options.compressed) tree.compress();
  return tree;
}

inline WideTree WideTree::refit(WideTree tree, const Primitives& primitives) {
  tree.refit(tree.nodes_, primitives);
  tree.refit(tree.compressed_, primitives);
  return tree;
}

static_assert(Refittable<WideTree>);
static_assert(Accelerator<WideTree>);

}  // namespace sightline
