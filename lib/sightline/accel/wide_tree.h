#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/large_pages.h"
#include "sightline/accel/padded_ray.h"
#include "sightline/accel/wide_tree_builder.h"
#include "sightline/accel/wide_tree_node.h"
#include "sightline/math/simd.h"

namespace sightline {

struct WideTreeOptions {
  int max_leaf_size = 8;        ///< Leaves are tested whole: eight triangles cost hardly more than one.
  float traversal_cost = 1;     ///< Opening a node: testing the boxes of eight children at once.
  float intersection_cost = 1;  ///< Testing a leaf.
  int bins = 32;                ///< On each axis, when many primitives are divided.

  static constexpr std::array<OptionField<WideTreeOptions>, 4> fields() {
    using O = WideTreeOptions;
    return {{{"max_leaf_size", &O::max_leaf_size, 1, 8, "most primitives in a leaf"},
             {"traversal_cost", &O::traversal_cost, 0, 1000, "cost of testing the boxes of eight children"},
             {"intersection_cost", &O::intersection_cost, 0.001, 1000, "cost of testing a leaf"},
             {"bins", &O::bins, 2, max_split_bins, "intervals of each axis between which a large node is divided"}}};
  }
};

/// Bounding boxes, eight to a node, so that one SIMD register tests a plane of each.
///   W1  A child's box contains its primitives; every primitive is in exactly one leaf.
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

  /// A node has the number of its place, a leaf that of its first position, counted on from the last node's.
  template <class See>
  void for_each_cell(See&& see) const {
    if (!nodes_.empty()) see_cells(bounds_, 0, 0, see);
  }

 private:
  template <class T>
  struct Waiting;
  template <class T>
  class Opener;

  std::uint32_t number_of(std::uint32_t link) const {
    return Link::node(link) + (Link::is_leaf(link) ? static_cast<std::uint32_t>(nodes_.size()) : 0);
  }

  template <class See>
  void see_cells(const Aabb& box, std::uint32_t link, int depth, See& see) const {
    const bool is_leaf = Link::is_leaf(link);
    see(Cell{box, depth, is_leaf, is_leaf ? Link::leaf(link) : LeafRange{}, number_of(link)});
    if (is_leaf) return;
    const Node& node = nodes_[Link::node(link)];
    for (int child = 0; child < width && node.links[child] != Link::none; ++child) {
      see_cells(node.box(child), node.links[child], depth + 1, see);
    }
  }

  LargeVector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  Aabb bounds_;
};

// ---- Traversal

/// What waits, nearest last as far as the order of octants tells. Times and links are apart because they are written
/// whole registers at a time. The owner counts, so that compilers keep the count in a register.
template <class T>
struct WideTree::Waiting {
  static constexpr std::size_t capacity = BinaryTree::max_depth * (width - 1) + 2 * width;  // W3, and a register more

  std::array<T, capacity> enters;
  std::array<std::uint32_t, capacity> links;
};

/// Tests the children of a node: PaddedRay::clip of eight boxes.
template <class T>
class WideTree::Opener {
 public:
  explicit Opener(const PaddedRay<T>& ray)
      : enter_(ray.enter_origin), leave_(ray.leave_origin), inverse_(ray.inverse), t_min_(ray.t_min) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      near_[axis] = (ray.is_negative[axis] ? axis + 3 : axis) * width;
      far_[axis] = (ray.is_negative[axis] ? axis : axis + 3) * width;
      octant_ |= std::size_t{ray.is_negative[axis]} << axis;
    }
  }

  /// Puts the children that the ray meets before `far` into `waiting`, after the first `count`, farther ones first, but
  /// for the nearest: that is `link`, entered at `enter`. False when there is none.
  [[gnu::always_inline]] bool open(const Node& node, T far, Waiting<T>& waiting, std::size_t& count,
                                   std::uint32_t& link, T& enter) const {
    if constexpr (is_one_register) {
      return open_at_once(node, far, waiting, count, link, enter);
    } else {
      std::uint32_t order = node.orders[octant_];
      bool is_any = false;
      for (int i = 0; i < width; ++i, order >>= 3) {
        const std::size_t child = order & 7;
        const Interval<T> range = clip(node, child, far);
        if (range.is_empty()) continue;
        if (is_any) {
          waiting.enters[count] = enter;
          waiting.links[count++] = link;
        }
        is_any = true;
        link = node.links[child];
        enter = range.lo;
      }
      return is_any;
    }
  }

 private:
  using Floats = hn::CappedTag<float, width>;
  static constexpr bool is_one_register = std::is_same_v<T, float> && hn::MaxLanes(Floats()) == std::size_t{width};

  Interval<T> clip(const Node& node, std::size_t child, T far) const {
    Interval<T> range{t_min_, far};
    for (int axis = 0; axis < 3; ++axis) {
      const T near_plane = (node.planes[near_[axis] + child] - enter_[axis]) * inverse_[axis];
      const T far_plane = (node.planes[far_[axis] + child] - leave_[axis]) * inverse_[axis];
      range.lo = near_plane > range.lo ? near_plane : range.lo;  // a NaN bounds nothing
      range.hi = far_plane < range.hi ? far_plane : range.hi;
    }
    return range;
  }

  [[gnu::always_inline]] bool open_at_once(const Node& node, float far, Waiting<T>& waiting, std::size_t& count,
                                           std::uint32_t& link, float& enter) const {
    const Floats f;
    const hn::RebindToUnsigned<Floats> u;
    const auto met = [&](std::size_t plane, T origin, T inverse) {
      return hn::Mul(hn::Sub(hn::Load(f, node.planes.data() + plane), hn::Set(f, origin)), hn::Set(f, inverse));
    };
    const auto entered = [&](int axis) { return met(near_[axis], enter_[axis], inverse_[axis]); };
    const auto left = [&](int axis) { return met(far_[axis], leave_[axis], inverse_[axis]); };
    // A NaN bounds nothing: the second pair's partner is none, so neither is the result.
    const auto lo = larger(larger(entered(0), entered(1)), larger(entered(2), hn::Set(f, t_min_)));
    const auto hi = smaller(smaller(left(0), left(1)), smaller(left(2), hn::Set(f, far)));

    const std::uint32_t order = node.orders[octant_];
    const auto shifts = hn::Mul(hn::Iota(u, 0), hn::Set(u, 3));
    const auto sorted = hn::And(hn::Shr(hn::Set(u, order), shifts), hn::Set(u, 7));
    const auto sorted_lo = hn::TableLookupLanes(lo, hn::IndicesFromVec(f, sorted));
    const auto sorted_hi = hn::TableLookupLanes(hi, hn::IndicesFromVec(f, sorted));
    const auto is_met = hn::Le(sorted_lo, sorted_hi);
    const std::uint32_t bits = bits_of(f, is_met);
    if (bits == 0) return false;
    const auto links = hn::TableLookupLanes(hn::Load(u, node.links.data()), hn::IndicesFromVec(u, sorted));
    hn::StoreU(hn::Compress(sorted_lo, is_met), f, waiting.enters.data() + count);
    hn::StoreU(hn::Compress(links, hn::RebindMask(u, is_met)), u, waiting.links.data() + count);
    count += static_cast<std::size_t>(std::popcount(bits)) - 1;
    link = node.links[order >> (3 * (31 - std::countl_zero(bits))) & 7];
    enter = waiting.enters[count];
    return true;
  }

  Vec3<T> enter_, leave_, inverse_;
  T t_min_;
  std::array<std::size_t, 3> near_, far_;
  std::size_t octant_ = 0;
};

/// A traversal that goes on step by step, so that many can be under way at once and none waits for memory alone.
/// Refers to the tree.
template <class T>
class WideTree::Walk {
 public:
  Walk(const WideTree& tree, const Ray<T>& ray) : Walk(tree, PaddedRay<T>(ray, tree.bounds_)) {}

  /// Opens a node or visits a leaf; false when none is left.
  template <LeafVisitor<T> Visit, class Probe>
  [[gnu::always_inline]] bool step(Visit&& visit, Probe& probe) {
    if (!Link::is_leaf(link_)) {
      probe.node(tree_.number_of(link_), static_cast<double>(enter_));
      if (opener_.open(tree_.nodes_[Link::node(link_)], far_, waiting_, count_, link_, enter_)) return true;
    } else if (link_ != Link::none) {
      const LeafRange range = Link::leaf(link_);
      probe.leaf(tree_.number_of(link_), range, static_cast<double>(enter_));
      far_ = visit(range);
      if (far_ < t_min_) return false;
    }
    while (count_ > 0) {
      --count_;
      link_ = waiting_.links[count_];
      enter_ = waiting_.enters[count_];
      if (enter_ <= far_) return true;
      probe.cull(tree_.number_of(link_), static_cast<double>(enter_));
    }
    return false;
  }

  /// Has what the next step reads brought near: a node, or the leaf that fetch_leaf(range) is told of.
  template <class FetchLeaf>
  void fetch(FetchLeaf&& fetch_leaf) const {
    if (!Link::is_leaf(link_)) {
      prefetch(&tree_.nodes_[Link::node(link_)], sizeof(Node));
    } else if (link_ != Link::none) {
      fetch_leaf(Link::leaf(link_));
    }
  }

 private:
  Walk(const WideTree& tree, const PaddedRay<T>& ray)
      : tree_(tree),
        opener_(ray),
        t_min_(ray.t_min),
        far_(ray.t_max),
        enter_(ray.t_min),
        link_(ray.t_min <= ray.t_max ? 0 : Link::none) {}

  const WideTree& tree_;
  Opener<T> opener_;
  T t_min_, far_, enter_;
  std::uint32_t link_;  ///< Of the next step.
  std::size_t count_ = 0;
  Waiting<T> waiting_;
};

template <class T, LeafVisitor<T> Visit, class Probe>
void WideTree::traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
  Walk<T> walk(*this, ray);
  while (walk.step(visit, probe)) {
  }
}

// ---- Construction

inline WideTree WideTree::build(const Primitives& primitives, const Options& options) {
  validate(name, options);
  if (primitives.size() > Link::limit) throw std::length_error("wide-tree: more than 2^28 primitives");
  WideTree tree;
  BinaryTree binary(primitives, options.bins);
  if (binary.is_empty()) return tree;
  tree.bounds_ = binary[0].box;
  const TreeCollapse<width> collapse(binary,
                                     {options.traversal_cost, options.intersection_cost, options.max_leaf_size});
  WideTreeBuilder(binary, collapse, tree.nodes_).build();
  tree.order_ = std::move(binary.order);
  return tree;
}

static_assert(Accelerator<WideTree>);

}  // namespace sightline
