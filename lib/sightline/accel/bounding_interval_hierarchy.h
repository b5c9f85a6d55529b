#pragma once

#include <tbb/concurrent_vector.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/candidate_box.h"
#include "sightline/accel/fixed_stack.h"
#include "sightline/accel/padded_ray.h"

namespace sightline {

struct BoundingIntervalHierarchyOptions {
  int max_leaf_size = 4;  ///< A node this small is never divided.
  int max_depth = 64;     ///< A node this deep is never divided, whatever it holds.
  bool lazy = false;      ///< Divide a node when the first ray reaches it.

  static constexpr std::array<OptionField<BoundingIntervalHierarchyOptions>, 3> fields() {
    using O = BoundingIntervalHierarchyOptions;
    return {{{"max_leaf_size", &O::max_leaf_size, 1, 1024, "a node this small is never divided"},
             {"max_depth", &O::max_depth, 0, 96, "a node this deep is never divided, whatever it holds"},
             {"lazy", &O::lazy, 0, 1, "divide a node when the first ray reaches it"}}};
  }
};

/// Bounding interval hierarchy: primitives parted by their centers, each part cut off by one clip plane.
///   H1  The child below lies below its clip plane and the one above above its own; they may overlap or leave a gap.
///   H2  The primitives of a node stand next to each other in the leaf order: first those of the child below.
///   H3  Two children are neighbours, so one number links both.
///   H4  No path exceeds max_depth, so the traversal stack cannot overflow.
///   H5  How a node divides depends on its primitives and its candidate box alone, so the order in which nodes are
///       divided, by threads or by rays, does not show in the tree.
/// Waechter and Keller, "Instant ray tracing: the bounding interval hierarchy", 2006.
class BoundingIntervalHierarchy {
 public:
  static constexpr std::string_view name = "bih";
  static constexpr std::string_view description =
      "sorted by centers, two clip planes a node, lazily if asked; Waechter and Keller 2006";
  static constexpr std::size_t node_bytes = 12;
  using Options = BoundingIntervalHierarchyOptions;

  /// \throws std::invalid_argument for options out of their limits, std::length_error beyond 2^29 primitives.
  static BoundingIntervalHierarchy build(const Primitives& primitives, const Options& options = {});

  /// Of a lazy tree: the nodes made so far, and what it keeps to make the others.
  std::size_t memory_bytes() const;
  std::span<const std::uint32_t> leaf_order() const { return order_; }
  bool is_order_final() const { return !lazy_; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const;

  /// Children before siblings. What a lazy tree has not divided yet shows as a leaf.
  template <class See>
  void for_each_cell(See&& see) const;

 private:
  static constexpr int most_levels = 96;
  static constexpr std::uint32_t most_primitives = 1u << 29;  ///< Links have 29 bits for numbers.

  /// What the low bits of a node's link say of it.
  enum Kind : std::uint32_t { inner_x, inner_y, inner_z, leaf, unmade, being_made };
  static constexpr int kind_bits = 3;

  /// Once there, a node of a lazy tree changes from unmade through being_made to what it is in an eager tree. Whoever
  /// finds it made, by an acquiring read of the link, sees its clip planes, its children and its part of the leaf order
  /// as well, since the link is written last and with release.
  struct Node {
    std::uint32_t link;  ///< Kind and, above it, the pair of children, a leaf's first position, or the task put aside.
    float clip[2];       ///< Highest point of the child below, lowest of the child above; a leaf's count.

    static std::uint32_t link_of(Kind kind, std::size_t number) {
      return static_cast<std::uint32_t>(number << kind_bits) | kind;
    }
    static Kind kind_of(std::uint32_t link) { return static_cast<Kind>(link & ((1u << kind_bits) - 1)); }
    static std::uint32_t number_of(std::uint32_t link) { return link >> kind_bits; }
    static std::uint32_t link_in(const Node& node) {
      return std::atomic_ref(const_cast<Node&>(node).link).load(std::memory_order_acquire);
    }
    static Node of_leaf(LeafRange at) { return {link_of(leaf, at.first), {std::bit_cast<float>(at.count), 0}}; }
    LeafRange leaf_range(std::uint32_t its_link) const {
      return {number_of(its_link), std::bit_cast<std::uint32_t>(clip[0])};
    }
  };
  static_assert(sizeof(Node) == node_bytes);

  /// What is needed to divide a node.
  struct Task {
    LeafRange range;
    Aabb candidate;  ///< Is halved for split planes and never fitted to what it holds.
    Aabb centers;    ///< Bounds of the primitives' centers.
    int depth = 0;
  };
  class Builder;

  void copy(const Node* from, std::size_t source, std::size_t target);
  template <class See>
  void show(See& see, std::uint32_t number, const Aabb& region, int depth) const;

  Aabb bounds_;
  std::vector<std::uint32_t> order_;
  Node* nodes_ = nullptr;          ///< own_nodes_ or the builder's: neither moves when the tree does.
  std::vector<Node> own_nodes_;    ///< Of an eager tree.
  std::unique_ptr<Builder> lazy_;  ///< Makes the nodes of a lazy tree; null in an eager one.
};

// ---- Construction: dividing nodes, when building or when reached

/// The pair of children that part at position m of the leaf order has the number m, which no other pair can have. So
/// threads need not agree on numbers, and a node's number does not depend on when it was made. Pair 0 is the root and
/// nothing.
class BoundingIntervalHierarchy::Builder {
 public:
  Builder(const Primitives& primitives, const Options& options, std::uint32_t* order)
      : options_(options),
        order_(order),
        nodes_(std::make_unique_for_overwrite<Node[]>(2 * std::size_t(primitives.size()))),
        boxes_(primitives.size()) {
    tbb::parallel_for(std::uint32_t(0), primitives.size(), [&](std::uint32_t id) {
      boxes_[id] = primitives.bounds(id);
      order_[id] = id;
    });
    root_.range.count = primitives.size();
    for (const Aabb& box : boxes_) {
      root_.candidate.extend(box);
      root_.centers.extend(box.center());
    }
  }

  const Aabb& bounds() const { return root_.candidate; }
  Node* nodes() { return nodes_.get(); }
  const Task& postponed(std::uint32_t number) const { return postponed_[number]; }
  std::size_t memory_bytes() const {
    return boxes_.size() * sizeof(Aabb) + postponed_.size() * sizeof(Task) + made_count_.load() * sizeof(Node);
  }

  /// Number of nodes.
  std::size_t make_tree() { return make_all(nodes_[0], root_); }

  void postpone_tree() {
    made_count_ = 1;
    postpone(nodes_[0], root_, postponed_.grow_by(1) - postponed_.begin());
  }

  /// Has the node made, by this thread or by another that has begun with it; returns its link. Waiting ends, because
  /// making a node waits for nothing; if it fails, the node is as before, and whoever waits tries in turn.
  std::uint32_t require(Node& node, std::uint32_t link) {
    const std::atomic_ref state(node.link);
    for (; Node::kind_of(link) > leaf; link = state.load(std::memory_order_acquire)) {
      if (Node::kind_of(link) == being_made) {
        state.wait(link, std::memory_order_acquire);
      } else if (state.compare_exchange_strong(link, Node::link_of(being_made, Node::number_of(link)))) {
        try {
          make_step(node, postponed_[Node::number_of(link)]);
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

  void postpone(Node& node, const Task& task, std::ptrdiff_t place) {
    postponed_[static_cast<std::size_t>(place)] = task;
    publish(node, {Node::link_of(unmade, static_cast<std::size_t>(place)), {}});
  }

  static void publish(Node& node, const Node& made) {
    std::copy_n(made.clip, 2, node.clip);
    std::atomic_ref(node.link).store(made.link, std::memory_order_release);
  }

  /// Makes the node and all below it; returns how many. Recursion ends by H4.
  std::size_t make_all(Node& node, const Task& task) {
    const Division division = divide(task);
    std::size_t below = 0, above = 0;
    if (division.is_inner) {
      Node* children = nodes_.get() + 2 * Node::number_of(division.node.link);
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
  void make_step(Node& node, const Task& task) {
    if (task.range.count <= std::max(step_size, std::uint32_t(options_.max_leaf_size))) {
      made_count_ += make_all(node, task) - 1;
      return;
    }
    const std::ptrdiff_t place = postponed_.grow_by(2) - postponed_.begin();
    const Division division = divide(task);
    if (division.is_inner) {
      Node* children = nodes_.get() + 2 * Node::number_of(division.node.link);
      made_count_ += 2;
      postpone(children[0], division.below, place);
      postpone(children[1], division.above, place + 1);
    }
    publish(node, division.node);
  }

  struct Division {
    Node node;
    bool is_inner = false;
    Task below, above;
  };

  Division divide(const Task& task) {
    Division division;
    division.node = Node::of_leaf(task.range);
    if (task.range.count > std::uint32_t(options_.max_leaf_size) && task.depth < options_.max_depth) {
      Aabb candidate = task.candidate;
      const auto [axis, middle] = halve_until_parted(candidate, task.centers);
      if (axis >= 0) part(task, candidate, axis, middle, division);
    }
    return division;
  }

  /// H2: moves the primitives whose centers lie below the middle to the front.
  void part(const Task& task, const Aabb& candidate, int axis, float middle, Division& division) {
    const std::uint32_t first = task.range.first, end = first + task.range.count;
    Aabb centers_below, centers_above;
    float lowest_above = std::numeric_limits<float>::infinity(), highest_below = -lowest_above;
    std::uint32_t parting = end;
    for (std::uint32_t i = first; i != parting;) {
      const Vec3f center = boxes_[i].center();
      if (center[axis] < middle) {
        centers_below.extend(center);
        highest_below = std::max(highest_below, boxes_[i].hi[axis]);
        ++i;
      } else {
        centers_above.extend(center);
        lowest_above = std::min(lowest_above, boxes_[i].lo[axis]);
        std::swap(boxes_[i], boxes_[--parting]);
        std::swap(order_[i], order_[parting]);
      }
    }
    division.is_inner = true;
    division.node = {Node::link_of(static_cast<Kind>(axis), parting), {highest_below, lowest_above}};
    division.below = {{first, parting - first}, candidate, centers_below, task.depth + 1};
    division.above = {{parting, end - parting}, candidate, centers_above, task.depth + 1};
    division.below.candidate.hi[axis] = division.above.candidate.lo[axis] = middle;
  }

  const Options options_;
  std::uint32_t* order_;
  std::unique_ptr<Node[]> nodes_;  ///< Memory is taken by those that are made.
  std::vector<Aabb> boxes_;        ///< of the primitives, in the order of order_
  Task root_;
  tbb::concurrent_vector<Task, std::allocator<Task>> postponed_;  ///< Grows without moving.
  std::atomic<std::size_t> made_count_ = 0;
};

inline BoundingIntervalHierarchy BoundingIntervalHierarchy::build(const Primitives& primitives,
                                                                  const Options& options) {
  validate(name, options);
  if (primitives.size() > most_primitives) {
    throw std::length_error("bih: " + std::to_string(primitives.size()) + " primitives; expected at most " +
                            std::to_string(most_primitives));
  }
  BoundingIntervalHierarchy tree;
  if (primitives.size() == 0) return tree;
  tree.order_.resize(primitives.size());
  auto builder = std::make_unique<Builder>(primitives, options, tree.order_.data());
  tree.bounds_ = builder->bounds();
  if (options.lazy) {
    builder->postpone_tree();
    tree.nodes_ = builder->nodes();
    tree.lazy_ = std::move(builder);
  } else {
    tree.own_nodes_.reserve(builder->make_tree() + 1);
    tree.own_nodes_.resize(2);
    tree.copy(builder->nodes(), 0, 0);
    tree.nodes_ = tree.own_nodes_.data();
  }
  return tree;
}

/// Brings the nodes of an eager tree together, each before its descendants, in the order in which they are walked.
inline void BoundingIntervalHierarchy::copy(const Node* from, std::size_t source, std::size_t target) {
  own_nodes_[target] = from[source];
  const std::uint32_t link = from[source].link;
  if (Node::kind_of(link) == leaf) return;
  const std::size_t pair = own_nodes_.size() / 2;
  own_nodes_[target].link = Node::link_of(Node::kind_of(link), pair);
  own_nodes_.resize(own_nodes_.size() + 2);
  for (const int side : {0, 1}) copy(from, 2 * std::size_t(Node::number_of(link)) + side, 2 * pair + side);
}

inline std::size_t BoundingIntervalHierarchy::memory_bytes() const {
  const std::size_t nodes = lazy_ ? lazy_->memory_bytes() : own_nodes_.size() * sizeof(Node);
  return nodes + order_.size() * sizeof(std::uint32_t);
}

// ---- Traversal

template <class T, LeafVisitor<T> Visit, class Probe>
void BoundingIntervalHierarchy::traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
  if (order_.empty()) return;
  const PaddedRay<T> padded(ray, bounds_);
  T far = padded.t_max;
  const Interval<T> inside = padded.clip(bounds_, far);
  if (inside.is_empty()) return;

  struct Entry {
    std::uint32_t node;
    Interval<T> t;  ///< in which the padded ray is within the node's clip planes
  };
  FixedStack<Entry, most_levels> stack;  // one for each level above the node: H4
  Entry entry{0, inside};
  for (;;) {
    Node& node = nodes_[entry.node];
    std::uint32_t link = Node::link_in(node);
    if (Node::kind_of(link) > leaf) link = lazy_->require(node, link);

    if (Node::kind_of(link) == leaf) {
      const LeafRange range = node.leaf_range(link);
      probe.leaf(entry.node, range, entry.t.lo);
      far = visit(range);
    } else {
      probe.node(entry.node, entry.t.lo);
      const int axis = static_cast<int>(Node::kind_of(link)), near = padded.is_negative[axis] ? 1 : 0;
      const std::uint32_t children = 2 * Node::number_of(link);
      const T leave = padded.leave(axis, node.clip[near]), enter = padded.enter(axis, node.clip[1 - near]);
      const Entry first{children + near, {entry.t.lo, leave < entry.t.hi ? leave : entry.t.hi}};
      const Entry second{children + 1 - near, {enter > entry.t.lo ? enter : entry.t.lo, entry.t.hi}};
      if (!second.t.is_empty()) {
        if (first.t.is_empty()) {
          entry = second;
          continue;
        }
        stack.push(second);
      }
      if (!first.t.is_empty()) {
        entry = first;
        continue;
      }
    }

    // Overlapping regions: what was put aside earlier may lie nearer, so the walk goes on after a cull.
    for (;;) {
      if (stack.empty()) return;
      entry = stack.pop();
      if (!(entry.t.lo > far)) break;
      probe.cull(entry.node, entry.t.lo);
    }
    entry.t.hi = std::min(entry.t.hi, far);
  }
}

template <class See>
void BoundingIntervalHierarchy::for_each_cell(See&& see) const {
  if (!order_.empty()) show(see, 0, bounds_, 0);
}

template <class See>
void BoundingIntervalHierarchy::show(See& see, std::uint32_t number, const Aabb& region, int depth) const {
  const Node& node = nodes_[number];
  const std::uint32_t link = Node::link_in(node);
  if (Node::kind_of(link) >= leaf) {
    const bool is_made = Node::kind_of(link) == leaf;
    const LeafRange range = is_made ? node.leaf_range(link) : lazy_->postponed(Node::number_of(link)).range;
    return see(Cell{region, depth, true, range, number});
  }
  see(Cell{region, depth, false, {}, number});
  const int axis = static_cast<int>(Node::kind_of(link));
  Aabb below = region, above = region;
  below.hi[axis] = std::min(below.hi[axis], node.clip[0]);
  above.lo[axis] = std::max(above.lo[axis], node.clip[1]);
  show(see, 2 * Node::number_of(link), below, depth + 1);
  show(see, 2 * Node::number_of(link) + 1, above, depth + 1);
}

static_assert(Accelerator<BoundingIntervalHierarchy>);

}  // namespace sightline
