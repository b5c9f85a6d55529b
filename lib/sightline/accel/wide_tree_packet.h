#pragma once
/// The first steps of coherent rays through a wide tree, taken together.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sightline/accel/wide_tree_walk.h"

namespace sightline {

/// Up to sixteen rays that look the same way. Near the root they meet the same nodes, so a node is opened once for all
/// of them, by intervals that hold all rays; each child is then tested by all rays at once, which tells who meets it.
/// Subtrees that few meet, and leaves, are left to the rays, each of which goes on alone with what is its own.
///   K1  A ray starts with every subtree that M2 (padded_ray.h) keeps for it, so its hits are the same: it is tested as
///       SlabRay tests, and an interval is as early as its earliest ray but for 3 u of reach, of which M2 has more.
///   K2  `budget` bounds the work that a ray whose hit is near makes for nothing, and how many subtrees there are.
/// Boulos, Edwards, Lacewell, Kniss, Kautz, Shirley and Wald, "Packet-based Whitted and Distribution Ray Tracing", 2007
/// (intervals); Benthin, Wald, Woop, Ernst and Mark, "Combining Single and Packet-Ray Tracing for Arbitrary Ray
/// Distributions on the Intel MIC Architecture", 2012 (packets that fall apart into single rays).
template <class T, class Node>
class WidePacket {
 public:
  static constexpr std::size_t size = 16;

  /// At least one ray; refers to the nodes.
  WidePacket(std::span<const Node> nodes, const Aabb& bounds, std::span<const Ray<T>> rays)
      : nodes_(nodes), count_(rays.size()) {
    take(rays);
    is_coherent_ = !nodes.empty() && prepare(bounds);
    if (is_coherent_) descend();
  }

  /// Whether the rays could go together; else each has to start at the root.
  bool is_coherent() const { return is_coherent_; }

  /// Whether a ray has anything to do at all.
  bool is_met(std::size_t ray) const { return met_ >> ray & 1; }

  SlabRay<typename WideSlabOpener<T, Node>::D> slabs(std::size_t ray) const {
    const auto of = [&](const Rows& rows) { return std::array{rows[0][ray], rows[1][ray], rows[2][ray]}; };
    return {of(inverse_), of(enter_), of(leave_), octant_};
  }
  T t_min(std::size_t ray) const { return t_min_[ray]; }
  T t_max(std::size_t ray) const { return t_max_[ray]; }

  /// Puts what a ray meets on its stack, nearest last, and returns how much.
  std::size_t start(std::size_t ray, WideStack<T>& stack) const {
    std::size_t count = 0;
    for (std::size_t i = part_count_; i-- > 0;) {
      stack.enters[count] = parts_[i].enters[ray];
      stack.links[count] = parts_[i].link;
      count += parts_[i].rays >> ray & 1;
    }
    return count;
  }

 private:
  using Rows = std::array<std::array<T, size>, 3>;
  using P = hn::CappedTag<T, size>;  ///< Of rays.
  using D = typename WideSlabOpener<T, Node>::D;
  using V = hn::Vec<P>;
  static constexpr std::size_t budget = 16;                        ///< Nodes.
  static constexpr std::size_t most_parts = budget * Node::width;  ///< K2: each is a child of an opened node.
  static_assert(most_parts <= WideStack<T>::first);
  static constexpr int few = 4;  ///< Rays for which a node is not worth opening together.

  /// A subtree that some rays meet.
  struct Part {
    alignas(64) std::array<T, size> enters;
    std::uint32_t link;
    std::uint32_t rays;
  };

  /// A child of a node.
  struct Child {
    std::uint32_t node;
    std::uint32_t index;
  };

  /// The interval of a number over the rays.
  struct Range {
    T lo, hi;
  };

  void take(std::span<const Ray<T>> rays) {
    for (std::size_t i = 0; i < size; ++i) {
      const Ray<T>& ray = rays[std::min(i, rays.size() - 1)];
      for (int axis = 0; axis < 3; ++axis) {
        origin_[axis][i] = ray.origin[axis];
        direction_[axis][i] = ray.direction[axis];
      }
      t_min_[i] = ray.t_min;
      t_max_[i] = ray.t_max;
    }
  }

  /// False unless all rays are ordinary and of one octant.
  bool prepare(const Aabb& bounds) {
    const P p;
    bool is_ordinary = true;
    std::uint32_t negative[3] = {};
    for (std::size_t i = 0; i < size; i += hn::Lanes(p)) {
      V reach = hn::Zero(p), speed = hn::Zero(p);
      for (int axis = 0; axis < 3; ++axis) {
        const V origin = hn::Load(p, &origin_[axis][i]);
        const V to_lo = hn::Abs(hn::Sub(hn::Set(p, bounds.lo[axis]), origin));
        const V to_hi = hn::Abs(hn::Sub(hn::Set(p, bounds.hi[axis]), origin));
        reach = hn::Max(reach, hn::Max(to_lo, to_hi));
        speed = hn::Max(speed, hn::Abs(hn::Load(p, &direction_[axis][i])));
      }
      is_ordinary &= hn::AllTrue(p, hn::Le(hn::Load(p, &t_min_[i]), hn::Load(p, &t_max_[i])));
      for (int axis = 0; axis < 3; ++axis) {
        const auto moved =
            moved_slabs(p, hn::Load(p, &origin_[axis][i]), hn::Load(p, &direction_[axis][i]), reach, speed);
        is_ordinary &= hn::AllTrue(p, moved.is_ordinary);
        hn::Store(moved.inverse, p, &inverse_[axis][i]);
        hn::Store(moved.enter_origin, p, &enter_origin_[axis][i]);
        hn::Store(moved.leave_origin, p, &leave_origin_[axis][i]);
        hn::Store(hn::Mul(moved.enter_origin, moved.inverse), p, &enter_[axis][i]);
        hn::Store(hn::Mul(moved.leave_origin, moved.inverse), p, &leave_[axis][i]);
        negative[axis] += static_cast<std::uint32_t>(hn::CountTrue(p, hn::Lt(moved.inverse, hn::Zero(p))));
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (negative[axis] != 0 && negative[axis] != size) return false;
      octant_ |= std::uint32_t{negative[axis] != 0} << axis;
    }
    return is_ordinary;
  }

  static Range range_of(const std::array<T, size>& numbers) {
    const auto [lo, hi] = std::minmax_element(numbers.begin(), numbers.end());
    return {*lo, *hi};
  }

  /// What holds all rays on an axis: entering and leaving are as early, or as late, as for the moved origins and
  /// inverses at the ends of their intervals.
  struct Bounds {
    T enter_origin, leave_origin;
    Range inverse;
  };

  void descend() {
    for (int axis = 0; axis < 3; ++axis) {
      const Range enters = range_of(enter_origin_[axis]), leaves = range_of(leave_origin_[axis]);
      const bool is_negative = octant_ >> axis & 1;
      bounds_[axis] = {is_negative ? enters.lo : enters.hi, is_negative ? leaves.hi : leaves.lo,
                       range_of(inverse_[axis])};
    }
    range_ = {range_of(t_min_).lo, range_of(t_max_).hi};
    std::array<Child, most_parts + Node::width> waiting;
    std::size_t waiting_count = open(0, waiting.data());
    for (std::size_t opened = 1; waiting_count > 0;) {
      const Child child = waiting[--waiting_count];
      Part& part = parts_[part_count_];
      part.link = nodes_[child.node].links[child.index];
      part.rays = test(child, part.enters);
      if (part.rays == 0) continue;
      if (!WideLink::is_leaf(part.link) && std::popcount(part.rays) > few && opened < budget) {
        ++opened;
        waiting_count += open(WideLink::node(part.link), waiting.data() + waiting_count);
      } else {
        met_ |= part.rays;
        ++part_count_;
      }
    }
  }

  /// Lists the children that the intervals meet, nearest last, and returns how many there are.
  std::size_t open(std::uint32_t index, Child* children) const {
    const D f;
    const Node& node = nodes_[index];
    auto lo = hn::Set(f, range_.lo), hi = hn::Set(f, range_.hi);
    for (int axis = 0; axis < 3; ++axis) {
      const Bounds& bounds = bounds_[axis];
      const bool is_negative = octant_ >> axis & 1;
      const auto slow = hn::Set(f, bounds.inverse.lo), fast = hn::Set(f, bounds.inverse.hi);
      const auto from_enter =
          hn::Sub(node.row(f, axis, Node::row_at(axis, is_negative)), hn::Set(f, bounds.enter_origin));
      const auto from_leave =
          hn::Sub(node.row(f, axis, Node::row_at(axis, !is_negative)), hn::Set(f, bounds.leave_origin));
      lo = hn::Max(lo, hn::Min(hn::Mul(from_enter, slow), hn::Mul(from_enter, fast)));
      hi = hn::Min(hi, hn::Max(hn::Mul(from_leave, slow), hn::Mul(from_leave, fast)));
    }
    const std::uint32_t met = bits_of(f, hn::Le(lo, hi));
    std::size_t count = 0;
    for (std::uint32_t order = node.order(octant_), i = 0; i < Node::width; ++i, order >>= 3) {
      children[count] = {index, order & 7};
      count += met >> (order & 7) & 1;
    }
    return count;
  }

  /// Which rays meet a child's box, and when.
  std::uint32_t test(const Child& child, std::array<T, size>& enters) const {
    const P p;
    const Aabb box = nodes_[child.node].box(static_cast<int>(child.index));
    std::uint32_t met = 0;
    for (std::size_t i = 0; i < size; i += hn::Lanes(p)) {
      V lo = hn::Load(p, &t_min_[i]), hi = hn::Load(p, &t_max_[i]);
      for (int axis = 0; axis < 3; ++axis) {
        const bool is_negative = octant_ >> axis & 1;
        const V inverse = hn::Load(p, &inverse_[axis][i]);
        const V near_plane = hn::Set(p, (is_negative ? box.hi : box.lo)[axis]);
        const V far_plane = hn::Set(p, (is_negative ? box.lo : box.hi)[axis]);
        lo = hn::Max(lo, hn::MulSub(near_plane, inverse, hn::Load(p, &enter_[axis][i])));
        hi = hn::Min(hi, hn::MulSub(far_plane, inverse, hn::Load(p, &leave_[axis][i])));
      }
      hn::Store(lo, p, &enters[i]);
      met |= bits_of(p, hn::Le(lo, hi)) << i;
    }
    return met & ((1u << count_) - 1);
  }

  std::span<const Node> nodes_;
  std::size_t count_;
  alignas(64) Rows origin_, direction_, inverse_;
  alignas(64) Rows enter_origin_, leave_origin_;  ///< Moved, see SlabRay.
  alignas(64) Rows enter_, leave_;                ///< Offsets of slabs.
  alignas(64) std::array<T, size> t_min_, t_max_;
  std::uint32_t octant_ = 0;
  std::array<Bounds, 3> bounds_;
  Range range_;
  std::array<Part, most_parts + 1> parts_;  ///< And one in the making.
  std::size_t part_count_ = 0;
  std::uint32_t met_ = 0;
  bool is_coherent_;
};

}  // namespace sightline
