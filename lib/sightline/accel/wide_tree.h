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
#include "sightline/accel/tree_collapse.h"
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
  static constexpr int width = 8;

  /// How a node and the stack name a child; 0, which would be the root, where there is none.
  class Link {
   public:
    static constexpr std::uint32_t limit = std::uint32_t{1} << 28;  ///< Of nodes and of positions.

    static std::uint32_t to_node(std::uint32_t index) { return index << 4; }
    static std::uint32_t to_leaf(LeafRange range) { return range.first << 4 | range.count; }
    static bool is_leaf(std::uint32_t link) { return link & 15; }
    static std::uint32_t node(std::uint32_t link) { return link >> 4; }
    static LeafRange leaf(std::uint32_t link) { return {link >> 4, link & 15}; }
  };

  struct alignas(64) Node {
    std::array<std::array<float, width>, 6> planes;  ///< Of all children: low x, y, z, high x, y, z. Empty: inverted.
    std::array<std::uint32_t, width> links;
    /// For each octant of directions (a bit is set where a component is negative) the children, those farther along
    /// first: three bits each.
    std::array<std::uint32_t, 8> orders;

    Aabb box(int child) const {
      return {{planes[0][child], planes[1][child], planes[2][child]},
              {planes[3][child], planes[4][child], planes[5][child]}};
    }
  };
  static_assert(sizeof(Node) == 256);

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

  /// A node has the number of its place, a leaf that of its first position, counted on from the last node's.
  template <class See>
  void for_each_cell(See&& see) const {
    if (!nodes_.empty()) see_cells(bounds_, 0, 0, see);
  }

  /// Calls see(LeafRange) for every leaf, in order of position.
  template <class See>
  void for_each_leaf(See&& see) const {
    if (nodes_.empty()) return;
    for_each_cell([&](const Cell& cell) {
      if (cell.is_leaf) see(cell.range);
    });
  }

 private:
  class Builder;
  template <class T>
  class Stack;
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
    for (int child = 0; child < width && node.links[child] != 0; ++child) {
      see_cells(node.box(child), node.links[child], depth + 1, see);
    }
  }

  LargeVector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  Aabb bounds_;
};

// ---- Traversal

/// What waits, nearest last as far as the order of octants tells. Times and links are apart because they are written
/// and sifted whole registers at a time.
template <class T>
class WideTree::Stack {
 public:
  void push(T enter, std::uint32_t link) {
    enters_[size_] = enter;
    links_[size_++] = link;
  }

  /// The next one that the ray enters at `far` or before; false when there is none.
  template <class Cull>
  bool pop(T far, T& enter, std::uint32_t& link, Cull&& cull) {
    while (size_ > 0) {
      --size_;
      enter = enters_[size_];
      link = links_[size_];
      if (enter <= far) return true;
      cull(link, enter);
    }
    return false;
  }

  T* enters_end() { return enters_.data() + size_; }
  std::uint32_t* links_end() { return links_.data() + size_; }
  void grow(std::size_t count) { size_ += count; }

 private:
  static constexpr std::size_t capacity = BinaryTree::max_depth * (width - 1) + 2 * width;  // W3, and a register more

  std::array<T, capacity> enters_;
  std::array<std::uint32_t, capacity> links_;
  std::size_t size_ = 0;
};

/// Tests the children of a node: PaddedRay::clip of eight boxes.
template <class T>
class WideTree::Opener {
 public:
  explicit Opener(const PaddedRay<T>& ray) : ray_(ray) {
    for (int axis = 0; axis < 3; ++axis) {
      near_[axis] = ray.is_negative[axis] ? axis + 3 : axis;
      far_[axis] = ray.is_negative[axis] ? axis : axis + 3;
      octant_ |= std::size_t{ray.is_negative[axis]} << axis;
    }
  }

  /// Pushes the children that the ray meets before `far`, farther ones first.
  [[gnu::always_inline]] void open(const Node& node, T far, Stack<T>& stack) const {
    if constexpr (is_one_register) {
      open_at_once(node, far, stack);
    } else {
      std::uint32_t order = node.orders[octant_];
      for (int i = 0; i < width; ++i, order >>= 3) {
        const int child = static_cast<int>(order & 7);
        if (node.links[child] == 0) continue;
        const Interval<T> range = ray_.clip(node.box(child), far);
        if (!range.is_empty()) stack.push(range.lo, node.links[child]);
      }
    }
  }

 private:
  using Floats = hn::CappedTag<float, width>;
  static constexpr bool is_one_register =
      std::is_same_v<T, float> && hn::MaxLanes(Floats()) == std::size_t{width};

  /// max(a, b) that is b where a is NaN; where b is, it may be NaN.
  template <class V>
  static V larger(V a, V b) {
    if constexpr (HWY_ARCH_X86) {
      return hn::Max(a, b);
    } else {
      return hn::IfThenElse(hn::Gt(a, b), a, b);
    }
  }
  template <class V>
  static V smaller(V a, V b) {
    if constexpr (HWY_ARCH_X86) {
      return hn::Min(a, b);
    } else {
      return hn::IfThenElse(hn::Lt(a, b), a, b);
    }
  }

  [[gnu::always_inline]] void open_at_once(const Node& node, float far, Stack<T>& stack) const {
    const Floats f;
    const hn::RebindToUnsigned<Floats> u;
    const auto enter = [&](int axis) {
      const auto plane = hn::Load(f, node.planes[near_[axis]].data());
      return hn::Mul(hn::Sub(plane, hn::Set(f, ray_.enter_origin[axis])), hn::Set(f, ray_.inverse[axis]));
    };
    const auto leave = [&](int axis) {
      const auto plane = hn::Load(f, node.planes[far_[axis]].data());
      return hn::Mul(hn::Sub(plane, hn::Set(f, ray_.leave_origin[axis])), hn::Set(f, ray_.inverse[axis]));
    };
    // A NaN bounds nothing: the second pair's partner is none, so neither is the result.
    const auto lo = larger(larger(enter(0), enter(1)), larger(enter(2), hn::Set(f, ray_.t_min)));
    const auto hi = smaller(smaller(leave(0), leave(1)), smaller(leave(2), hn::Set(f, far)));
    const auto links = hn::Load(u, node.links.data());
    const auto shifts = hn::Mul(hn::Iota(u, 0), hn::Set(u, 3));
    const auto order = hn::IndicesFromVec(f, hn::And(hn::Shr(hn::Set(u, node.orders[octant_]), shifts), hn::Set(u, 7)));
    const auto lo_sorted = hn::TableLookupLanes(lo, order), hi_sorted = hn::TableLookupLanes(hi, order);
    const auto links_sorted = hn::TableLookupLanes(
        links, hn::IndicesFromVec(u, hn::And(hn::Shr(hn::Set(u, node.orders[octant_]), shifts), hn::Set(u, 7))));
    const auto meets = hn::And(hn::Le(lo_sorted, hi_sorted), hn::RebindMask(f, hn::Ne(links_sorted, hn::Zero(u))));
    hn::StoreU(hn::Compress(lo_sorted, meets), f, stack.enters_end());
    hn::StoreU(hn::Compress(links_sorted, hn::RebindMask(u, meets)), u, stack.links_end());
    stack.grow(hn::CountTrue(f, meets));
  }

  const PaddedRay<T>& ray_;
  std::array<int, 3> near_, far_;
  std::size_t octant_ = 0;
};

template <class T, LeafVisitor<T> Visit, class Probe>
void WideTree::traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
  const PaddedRay<T> padded(ray, bounds_);
  if (!(padded.t_min <= padded.t_max)) return;
  const Opener<T> opener(padded);
  const auto cull = [&](std::uint32_t link, T enter) { probe.cull(number_of(link), static_cast<double>(enter)); };
  T far = padded.t_max, enter = padded.t_min;
  std::uint32_t link = 0;
  Stack<T> stack;
  do {
    if (Link::is_leaf(link)) {
      const LeafRange range = Link::leaf(link);
      probe.leaf(number_of(link), range, static_cast<double>(enter));
      far = visit(range);
      if (far < padded.t_min) return;
    } else {
      probe.node(number_of(link), static_cast<double>(enter));
      opener.open(nodes_[Link::node(link)], far, stack);
    }
  } while (stack.pop(far, enter, link, cull));
}

// ---- Construction

class WideTree::Builder {
 public:
  Builder(const BinaryTree& binary, const TreeCollapse<width>& collapse, LargeVector<Node>& nodes)
      : binary_(binary), collapse_(collapse), nodes_(nodes) {}

  void build() {
    nodes_.emplace_back();
    make(0, 0, 0);
    nodes_.shrink_to_fit();
  }

 private:
  /// Makes the wide node `index` of a binary one whose primitives begin at position `first`.
  void make(std::uint32_t index, std::uint32_t root, std::uint32_t first) {
    const auto children = collapse_.children(root);
    const std::uint32_t first_child = static_cast<std::uint32_t>(nodes_.size());
    std::uint32_t inner_count = 0;
    Node node;
    for (auto& planes : node.planes) planes.fill(0);
    node.links.fill(0);
    std::array<std::uint32_t, width> positions;
    for (int child = 0; child < children.count; ++child) {
      const BinaryTree::Node& from = binary_[children.nodes[child]];
      for (int axis = 0; axis < 3; ++axis) {
        node.planes[axis][child] = from.box.lo[axis];
        node.planes[axis + 3][child] = from.box.hi[axis];
      }
      positions[child] = first;
      const bool is_leaf = collapse_.is_leaf(children.nodes[child]);
      node.links[child] = is_leaf ? Link::to_leaf({first, from.count}) : Link::to_node(first_child + inner_count++);
      first += from.count;
    }
    for (std::uint32_t octant = 0; octant < 8; ++octant) node.orders[octant] = order_along(node, octant);
    nodes_[index] = node;
    nodes_.resize(nodes_.size() + inner_count);
    for (int child = 0; child < children.count; ++child) {
      const std::uint32_t link = node.links[child];
      if (!Link::is_leaf(link)) make(Link::node(link), children.nodes[child], positions[child]);
    }
  }

  static std::uint32_t order_along(const Node& node, std::uint32_t octant) {
    std::array<std::pair<double, std::uint32_t>, width> reach;
    for (std::uint32_t child = 0; child < width; ++child) {
      double sum = 0;
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const double center = double(node.planes[axis][child]) + double(node.planes[axis + 3][child]);
        sum += octant >> axis & 1 ? center : -center;
      }
      reach[child] = {sum, child};
    }
    std::sort(reach.begin(), reach.end());
    std::uint32_t order = 0;
    for (std::uint32_t i = 0; i < width; ++i) order |= reach[i].second << (3 * i);
    return order;
  }

  const BinaryTree& binary_;
  const TreeCollapse<width>& collapse_;
  LargeVector<Node>& nodes_;
};

inline WideTree WideTree::build(const Primitives& primitives, const Options& options) {
  validate(name, options);
  if (primitives.size() > Link::limit) throw std::length_error("wide-tree: more than 2^28 primitives");
  WideTree tree;
  BinaryTree binary(primitives, options.bins);
  if (binary.is_empty()) return tree;
  tree.bounds_ = binary[0].box;
  const TreeCollapse<width> collapse(binary,
                                     {options.traversal_cost, options.intersection_cost, options.max_leaf_size});
  Builder(binary, collapse, tree.nodes_).build();
  tree.order_ = std::move(binary.order);
  return tree;
}

static_assert(Accelerator<WideTree>);

}  // namespace sightline
