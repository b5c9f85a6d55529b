#pragma once
/// Dividing the nodes of a bounding interval hierarchy, when building or when reached.

#include <tbb/blocked_range.h>
#include <tbb/concurrent_vector.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>

#include "sightline/accel/bounding_interval_hierarchy_node.h"
#include "sightline/accel/bounding_interval_hierarchy_split.h"
#include "sightline/accel/primitives.h"

namespace sightline::detail {

/// What is needed to divide a node.
struct BihTask {
  LeafRange range;
  BihExtent extent;  ///< Of the primitives.
  Aabb region;       ///< What rays see of the node: the scene's bounds, cut by the planes on the path.
  Aabb candidate;    ///< Is halved for split planes and never fitted to what it holds.
  int depth = 0;
};

struct BihSettings {
  Quality quality;
  int max_leaf_size;
  int max_depth;
  bool slabs;
};

/// The pair of children that part at position m of the leaf order has the number m, which no other pair can have. So
/// threads need not agree on numbers, and a node's number does not depend on when it was made. Pair 0 is the root and
/// nothing.
/// H1 to H5: see bounding_interval_hierarchy.h.
class BihBuilder {
 public:
  BihBuilder(const Primitives& primitives, const BihSettings& settings, std::uint32_t* order)
      : splitter_(settings.quality, settings.max_leaf_size),
        max_depth_(settings.max_depth),
        has_slabs_(settings.slabs),
        order_(order),
        nodes_(std::make_unique_for_overwrite<BihNode[]>(2 * std::size_t(primitives.size()))),
        boxes_(std::make_unique_for_overwrite<BihBox[]>(primitives.size())) {
    using Range = tbb::blocked_range<std::uint32_t>;
    const auto take = [&](const Range& ids, BihExtent extent) {
      for (std::uint32_t id = ids.begin(); id != ids.end(); ++id) {
        boxes_[id] = BihBox::of(primitives.bounds(id));
        extent.extend(boxes_[id]);
        order_[id] = id;
      }
      return extent;
    };
    const auto join = [](BihExtent a, const BihExtent& b) {
      a.extend(b);
      return a;
    };
    root_.range.count = primitives.size();
    root_.extent = tbb::parallel_reduce(Range(0, primitives.size(), parallel_size), BihExtent(), take, join);
    root_.region = root_.candidate = bounds();
  }

  Aabb bounds() const { return root_.extent.bounds.box(); }
  BihNode* nodes() { return nodes_.get(); }
  const BihTask& postponed(std::uint32_t number) const { return postponed_[number]; }
  std::size_t memory_bytes() const {
    return root_.range.count * sizeof(BihBox) + postponed_.size() * sizeof(BihTask) +
           made_count_.load() * sizeof(BihNode);
  }

  /// Number of nodes.
  std::size_t make_tree() { return make_all(nodes_[0], root_); }

  void postpone_tree() {
    made_count_ = 1;
    postpone(nodes_[0], root_, postponed_.grow_by(1) - postponed_.begin());
  }

  /// Has the node made, by this thread or by another that has begun with it; returns its link. Waiting ends, because
  /// making a node waits for nothing; if it fails, the node is as before, and whoever waits tries in turn.
  std::uint32_t require(BihNode& node, std::uint32_t link) {
    const std::atomic_ref state(node.link);
    for (; !BihNode::is_made(link); link = state.load(std::memory_order_acquire)) {
      if (BihNode::state_of(link) == BihNode::being_made) {
        state.wait(link, std::memory_order_acquire);
      } else if (state.compare_exchange_strong(link, BihNode::link_of(BihNode::being_made, BihNode::number_of(link)))) {
        try {
          make_step(node, postponed_[BihNode::number_of(link)]);
        } catch (...) {
          state.store(link, std::memory_order_release);
          state.notify_all();
          throw;
        }
        state.notify_all();
      }
    }
    return link;
  }

 private:
  static constexpr std::uint32_t parallel_size = 4096;  ///< Two subtrees of more than this are built side by side.
  static constexpr std::uint32_t step_size = 64;        ///< A subtree of at most this is made in one step.

  void postpone(BihNode& node, const BihTask& task, std::ptrdiff_t place) {
    postponed_[static_cast<std::size_t>(place)] = task;
    std::atomic_ref(node.link).store(BihNode::link_of(BihNode::unmade, static_cast<std::size_t>(place)),
                                     std::memory_order_release);
  }

  static void publish(BihNode& node, const BihNode& made) {
    node.shape = made.shape;
    std::copy_n(made.slab, 2, node.slab);
    std::copy_n(made.clip, 2, node.clip);
    std::atomic_ref(node.link).store(made.link, std::memory_order_release);
  }

  /// Makes the node and all below it; returns how many. Recursion ends by H4.
  std::size_t make_all(BihNode& node, const BihTask& task) {
    const Division division = divide(task);
    std::size_t below = 0, above = 0;
    if (division.is_inner) {
      BihNode* children = nodes_.get() + 2 * BihNode::number_of(division.node.link);
      const auto make_below = [&] { below = make_all(children[0], division.below); };
      const auto make_above = [&] { above = make_all(children[1], division.above); };
      if (task.range.count > parallel_size) {
        tbb::parallel_invoke(make_below, make_above);
      } else {
        make_below(), make_above();
      }
    }
    publish(node, division.node);
    return 1 + below + above;
  }

  /// Makes the node, and its children too if they are few; else these are postponed. What can fail, taking the memory
  /// for that, comes before any primitive moves, so that a second attempt makes the same tree (H5).
  void make_step(BihNode& node, const BihTask& task) {
    if (task.range.count <= std::max(step_size, splitter_.max_leaf_size())) {
      made_count_ += make_all(node, task) - 1;
      return;
    }
    const std::ptrdiff_t place = postponed_.grow_by(2) - postponed_.begin();
    const Division division = divide(task);
    if (division.is_inner) {
      BihNode* children = nodes_.get() + 2 * BihNode::number_of(division.node.link);
      made_count_ += 2;
      postpone(children[0], division.below, place);
      postpone(children[1], division.above, place + 1);
    }
    publish(node, division.node);
  }

  struct Division {
    BihNode node;
    bool is_inner = false;
    BihTask below, above;
  };

  Division divide(const BihTask& task) {
    Division division;
    const Aabb bounds = has_slabs_ ? task.extent.bounds.box() : task.region;
    const int slab_axis = best_cut(task.region, bounds);
    const Aabb region = cut(task.region, bounds, slab_axis);
    BihNode& node = division.node;
    node.slab[0] = bounds.lo[slab_axis];
    node.slab[1] = bounds.hi[slab_axis];
    if (task.depth < max_depth_) {
      Aabb candidate = task.candidate;
      const auto boxes = std::span(boxes_.get(), root_.range.count).subspan(task.range.first, task.range.count);
      const BihSplit split = splitter_.split(boxes, task.extent, candidate);
      if (split.axis >= 0) {
        part(task, split, division);
        node.link = BihNode::link_of(BihNode::inner, division.above.range.first);
        node.shape = BihNode::shape_of(slab_axis, split.axis, 0);
        node.clip[0] = division.below.extent.bounds.hi[split.axis];
        node.clip[1] = division.above.extent.bounds.lo[split.axis];
        hand_down(region, candidate, split, division);
        return division;
      }
    }
    const int clip_axis = best_cut(region, bounds, slab_axis);
    node.link = BihNode::link_of(BihNode::leaf, task.range.first);
    node.shape = BihNode::shape_of(slab_axis, clip_axis, task.range.count);
    node.clip[0] = bounds.hi[clip_axis];
    node.clip[1] = bounds.lo[clip_axis];
    return division;
  }

  /// H2: moves the primitives whose centers lie below the split to the front.
  void part(const BihTask& task, const BihSplit& split, Division& division) {
    const std::uint32_t first = task.range.first, end = first + task.range.count;
    BihExtent below, above;
    std::uint32_t parting = end;
    for (std::uint32_t i = first; i != parting;) {
      if (split.is_below(boxes_[i])) {
        below.extend(boxes_[i]);
        ++i;
      } else {
        above.extend(boxes_[i]);
        std::swap(boxes_[i], boxes_[--parting]);
        std::swap(order_[i], order_[parting]);
      }
    }
    division.is_inner = true;
    division.below.range = {first, parting - first};
    division.above.range = {parting, end - parting};
    division.below.extent = below;
    division.above.extent = above;
    division.below.depth = division.above.depth = task.depth + 1;
  }

  void hand_down(const Aabb& region, const Aabb& candidate, const BihSplit& split, Division& division) const {
    BihTask &below = division.below, &above = division.above;
    const int axis = split.axis;
    below.region = above.region = region;
    below.region.hi[axis] = std::min(region.hi[axis], division.node.clip[0]);
    above.region.lo[axis] = std::max(region.lo[axis], division.node.clip[1]);
    below.candidate = above.candidate = candidate;
    if (splitter_.halves()) below.candidate.hi[axis] = above.candidate.lo[axis] = split.limit;
  }

  static Aabb cut(Aabb region, const Aabb& bounds, int axis) {
    region.lo[axis] = std::max(region.lo[axis], bounds.lo[axis]);
    region.hi[axis] = std::min(region.hi[axis], bounds.hi[axis]);
    return region;
  }

  /// The axis, other than `except`, on which cutting the region to the bounds leaves the least area.
  static int best_cut(const Aabb& region, const Aabb& bounds, int except = -1) {
    int best = -1;
    double least = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (axis == except) continue;
      const double area = half_area(cut(region, bounds, axis));
      if (best >= 0 && !(area < least)) continue;
      best = axis;
      least = area;
    }
    return best;
  }

  const BihSplitter splitter_;
  const int max_depth_;
  const bool has_slabs_;
  std::uint32_t* order_;
  std::unique_ptr<BihNode[]> nodes_;  ///< Memory is taken by those that are made.
  std::unique_ptr<BihBox[]> boxes_;   ///< Of the primitives, in the order of order_.
  BihTask root_;
  tbb::concurrent_vector<BihTask, std::allocator<BihTask>> postponed_;  ///< Grows without moving.
  std::atomic<std::size_t> made_count_ = 0;
};

}  // namespace sightline::detail
