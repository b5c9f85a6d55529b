#pragma once
/// A ray on its way through a wide tree.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/binary_tree.h"
#include "sightline/accel/slab_ray.h"
#include "sightline/accel/wide_tree_node.h"

namespace sightline {

/// What waits, nearest last as far as the order of octants tells. Times and links are apart because they are written
/// whole registers at a time. The owner counts, so that compilers keep the count in a register.
template <class T>
struct WideStack {
  static constexpr std::size_t first = 128;  ///< Most that a ray may begin with, see WidePacket.
  static constexpr std::size_t capacity =
      first + BinaryTree::max_depth * (WideNode::width - 1) + 2 * WideNode::width;  // W3, and a register more

  std::array<T, capacity> enters;
  std::array<std::uint32_t, capacity> links;
};

/// Tests the children of a node one by one.
template <class T, class NodeType>
class WideOpener {
 public:
  using Node = NodeType;

  WideOpener(const Ray<T>& ray, const Aabb& bounds) : ray_(ray, bounds) {
    for (int axis = 0; axis < 3; ++axis) octant_ |= std::uint32_t{ray_.is_negative[axis]} << axis;
  }

  static constexpr bool serves() { return true; }
  T t_min() const { return ray_.t_min; }
  T t_max() const { return ray_.t_max; }

  /// Puts the children that the ray meets before `far` on the stack, after the first `count`, but for one: that is
  /// `link`, entered at `enter`. False when there is none. Farther ones go first and the nearest is left, unless in any
  /// order.
  template <bool any_order>
  bool open(const Node& node, T far, WideStack<T>& stack, std::size_t& count, std::uint32_t& link, T& enter) const {
    std::uint32_t order = node.order(octant_);
    bool is_any = false;
    for (int i = 0; i < Node::width; ++i, order >>= 3) {
      const int child = static_cast<int>(order & 7);
      const Interval<T> range = ray_.clip(node.box(child), far);
      if (range.is_empty()) continue;
      if (is_any) {
        stack.enters[count] = enter;
        stack.links[count++] = link;
      }
      is_any = true;
      link = node.links[child];
      enter = range.lo;
    }
    return is_any;
  }

 private:
  PaddedRay<T> ray_;
  std::uint32_t octant_ = 0;
};

/// Tests all children at once, as WideOpener does, for ordinary rays (slab_ray.h). A template, so that it need not
/// compile where there are fewer lanes.
template <class T, class NodeType>
class WideSlabOpener {
 public:
  using Node = NodeType;
  using D = hn::CappedTag<float, Node::width>;

  [[gnu::always_inline]] WideSlabOpener(const Ray<T>& ray, const Aabb& bounds)
      : WideSlabOpener(SlabRay<D>(ray, bounds), ray.t_min, ray.t_max) {}

  [[gnu::always_inline]] WideSlabOpener(const SlabRay<D>& slabs, T t_min, T t_max)
      : slabs_(slabs), t_min_(t_min), t_max_(t_max), octant_(slabs.octant()) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_negative = octant_ >> axis & 1;
      near_[axis] = Node::row_at(axis, is_negative);
      far_[axis] = Node::row_at(axis, !is_negative);
    }
  }

  /// False for a ray that is not ordinary, which WideOpener has to take.
  bool serves() const { return slabs_.is_ordinary(); }
  T t_min() const { return t_min_; }
  T t_max() const { return t_max_; }

  template <bool any_order>
  [[gnu::always_inline]] bool open(const Node& node, T far, WideStack<T>& stack, std::size_t& count,
                                   std::uint32_t& link, T& enter) const {
    const auto entered = [&](int axis) { return slabs_.enter(axis, node.row(f, axis, near_[axis])); };
    const auto left = [&](int axis) { return slabs_.leave(axis, node.row(f, axis, far_[axis])); };
    auto lo = hn::Max(hn::Max(entered(0), entered(1)), hn::Max(entered(2), hn::Set(f, t_min_)));
    auto hi = hn::Min(hn::Min(left(0), left(1)), hn::Min(left(2), hn::Set(f, far)));
    auto links = hn::Load(u, node.links.data());
    const std::uint32_t order = node.order(octant_);
    if constexpr (!any_order) {
      const auto shifts = hn::Mul(hn::Iota(u, 0), hn::Set(u, 3));
      const auto sorted = hn::And(hn::Shr(hn::Set(u, order), shifts), hn::Set(u, 7));
      lo = hn::TableLookupLanes(lo, hn::IndicesFromVec(f, sorted));
      hi = hn::TableLookupLanes(hi, hn::IndicesFromVec(f, sorted));
      links = hn::TableLookupLanes(links, hn::IndicesFromVec(u, sorted));
    }
    auto is_met = hn::Le(lo, hi);
    if constexpr (Node::may_meet_none) {
      is_met = hn::And(is_met, hn::RebindMask(f, hn::Ne(links, hn::Set(u, WideLink::none))));
    }
    const std::uint32_t bits = bits_of(f, is_met);
    if (bits == 0) return false;
    hn::StoreU(hn::Compress(lo, is_met), f, stack.enters.data() + count);
    hn::StoreU(hn::Compress(links, hn::RebindMask(u, is_met)), u, stack.links.data() + count);
    count += static_cast<std::size_t>(std::popcount(bits)) - 1;
    const auto last = static_cast<std::uint32_t>(31 - std::countl_zero(bits));
    link = node.links[any_order ? last : order >> (3 * last) & 7];
    enter = stack.enters[count];
    return true;
  }

 private:
  using U = hn::RebindToUnsigned<D>;
  static constexpr D f{};
  static constexpr U u{};

  SlabRay<D> slabs_;
  T t_min_, t_max_;
  std::uint32_t octant_;
  std::uint32_t near_[3], far_[3];  ///< Where the rows of planes begin in a node.
};

template <class T>
inline constexpr bool wide_has_slabs =
    std::is_same_v<T, float>&& hn::MaxLanes(hn::CappedTag<float, WideNode::width>()) == WideNode::width;

template <class T, class Node>
using WideOpenerOf = std::conditional_t<wide_has_slabs<T>, WideSlabOpener<T, Node>, WideOpener<T, Node>>;

/// Goes on step by step, so that many rays can be under way at once and none waits for memory alone. Refers to the
/// nodes. The stack is the caller's, so that compilers keep the rest in registers.
template <class T, class Opener>
class WideWalk {
  using Node = typename Opener::Node;

 public:
  [[gnu::always_inline]] WideWalk(std::span<const Node> nodes, const Aabb& bounds, const Ray<T>& ray)
      : nodes_(nodes), opener_(ray, bounds), far_(opener_.t_max()), enter_(opener_.t_min()) {
    link_ = !nodes.empty() && enter_ <= far_ ? 0 : WideLink::none;
  }

  /// Begins with what is on the stack already.
  [[gnu::always_inline]] WideWalk(std::span<const Node> nodes, const Opener& opener, std::size_t count)
      : nodes_(nodes),
        opener_(opener),
        far_(opener_.t_max()),
        enter_(opener_.t_min()),
        link_(WideLink::none),
        count_(count) {}

  /// False for a ray that this opener cannot take.
  bool serves() const { return opener_.serves(); }

  /// Opens a node or visits a leaf; false when none is left.
  template <class Visit, class Probe>
  [[gnu::always_inline]] bool step(WideStack<T>& stack, Visit&& visit, Probe& probe) {
    if (!WideLink::is_leaf(link_)) {
      probe.node(number_of(link_), static_cast<double>(enter_));
      const Node& node = nodes_[WideLink::node(link_)];
      if (opener_.template open<takes_any_order<Visit>>(node, far_, stack, count_, link_, enter_)) return true;
    } else if (link_ != WideLink::none) {
      const LeafRange range = WideLink::leaf(link_);
      probe.leaf(number_of(link_), range, static_cast<double>(enter_));
      far_ = visit(range);
      if (far_ < opener_.t_min()) return false;
    }
    while (count_ > 0) {
      --count_;
      link_ = stack.links[count_];
      enter_ = stack.enters[count_];
      if (enter_ <= far_) return true;
      probe.cull(number_of(link_), static_cast<double>(enter_));
    }
    return false;
  }

  /// Has what the next step reads brought near.
  template <class Visit>
  void fetch_next(const Visit& visit) const {
    fetch(link_, visit);
  }

  /// Has what is read after the next step's subtree brought near.
  template <class Visit>
  [[gnu::always_inline]] void fetch_waiting(const WideStack<T>& stack, const Visit& visit) const {
    if (count_ > 0) fetch(stack.links[count_ - 1], visit);
  }

 private:
  std::uint32_t number_of(std::uint32_t link) const { return WideLink::number(link, nodes_.size()); }

  template <class Visit>
  [[gnu::always_inline]] void fetch(std::uint32_t link, const Visit& visit) const {
    if (!WideLink::is_leaf(link)) {
      prefetch(&nodes_[WideLink::node(link)], sizeof(Node));
    } else if (link != WideLink::none) {
      fetch_leaf(visit, WideLink::leaf(link));
    }
  }

  std::span<const Node> nodes_;
  Opener opener_;
  T far_, enter_;
  std::uint32_t link_;  ///< Of the next step.
  std::size_t count_ = 0;
};

}  // namespace sightline
