#pragma once

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/fixed_stack.h"
#include "sightline/accel/kd_events.h"
#include "sightline/accel/padded_ray.h"

namespace sightline {

struct KdTreeOptions {
  int max_leaf_size = 4;           ///< A cell that holds no more is never split.
  float traversal_cost = 1;        ///< One plane test, relative to ...
  float intersection_cost = 1.5f;  ///< ... one primitive test.
  float empty_bonus = 0.2f;        ///< Share of the cost that a split is spared when it cuts off empty space.
  int max_depth = 0;               ///< 0: 8 + 1.3 log2(primitives).

  static constexpr std::array<OptionField<KdTreeOptions>, 5> fields() {
    using O = KdTreeOptions;
    return {{{"max_leaf_size", &O::max_leaf_size, 1, 1024, "a cell that holds no more is never split"},
             {"traversal_cost", &O::traversal_cost, 0, 1000, "cost of one plane test"},
             {"intersection_cost", &O::intersection_cost, 0.001, 1000, "cost of one primitive test"},
             {"empty_bonus", &O::empty_bonus, 0, 0.99, "share of the cost spared by cutting off empty space"},
             {"max_depth", &O::max_depth, 0, 64, "longest path of splits; 0 chooses 8 + 1.3 log2(primitives)"}}};
  }
};

/// Kd-tree: space halved by axis-aligned planes, chosen by the surface area heuristic.
///   K1  Two children tile their parent's cell; the root's cell is the bounds of the scene.
///   K2  The child below follows its parent; only the child above is linked, by its distance.
///   K3  No path makes more than max_depth <= 64 splits, so the traversal stack cannot overflow.
///   K4  A leaf refers to every primitive with a point in its cell, the part of one that a plane cuts being on both
///       sides of it; a primitive that only touches a plane is on its own side.
///   K5  There are at most reference_limit references for each primitive.
/// Wald and Havran, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)", 2006; the nodes'
/// layout is that of Wald, "Realtime Ray Tracing and Interactive Global Illumination", 2004.
class KdTree {
 public:
  static constexpr std::string_view name = "kd-tree";
  static constexpr std::string_view description =
      "space halved by axis-aligned planes, surface area heuristic, clipped straddlers (Wald and Havran 2006)";
  static constexpr std::size_t node_bytes = 8;
  using Options = KdTreeOptions;

  /// \throws std::length_error for more than 2^27 primitives.
  static KdTree build(const Primitives& primitives, const Options& options = {});

  std::size_t memory_bytes() const { return nodes_.size() * sizeof(Node) + order_.size() * sizeof(std::uint32_t); }
  std::span<const std::uint32_t> leaf_order() const { return order_; }
  bool is_order_final() const { return true; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const;

  template <class See>
  void for_each_cell(See&& see) const {
    if (!nodes_.empty()) show(0, bounds_, 0, see);
  }

 private:
  class Builder;  // owns all scratch; dies after build

  static constexpr int depth_limit = 64;

  /// A plane and the distance to the child above, or a leaf's range.
  class Node {
   public:
    Node() = default;
    static constexpr std::size_t link_limit = (1u << 30) - 1;
    static Node inner(int axis, float plane, std::uint32_t to_above) {
      return {std::bit_cast<std::uint32_t>(plane), to_above << 2 | std::uint32_t(axis)};
    }
    static Node leaf(LeafRange range) { return {range.first, range.count << 2 | leaf_tag}; }

    bool is_leaf() const { return (link_ & leaf_tag) == leaf_tag; }
    int axis() const { return static_cast<int>(link_ & leaf_tag); }
    float plane() const { return std::bit_cast<float>(value_); }
    std::uint32_t to_above() const { return link_ >> 2; }
    LeafRange range() const { return {value_, link_ >> 2}; }

   private:
    static constexpr std::uint32_t leaf_tag = 3;
    Node(std::uint32_t value, std::uint32_t link) : value_(value), link_(link) {}
    std::uint32_t value_, link_;
  };
  static_assert(sizeof(Node) == node_bytes);

  template <class See>
  void show(std::uint32_t index, const Aabb& cell, int depth, See& see) const {
    const Node node = nodes_[index];
    if (node.is_leaf()) {
      see(Cell{cell, depth, true, node.range(), index});
      return;
    }
    see(Cell{cell, depth, false, {}, index});
    Aabb below = cell, above = cell;
    below.hi[node.axis()] = above.lo[node.axis()] = node.plane();
    show(index + 1, below, depth + 1, see);
    show(index + node.to_above(), above, depth + 1, see);
  }

  std::vector<Node> nodes_;  ///< Depth first.
  std::vector<std::uint32_t> order_;
  Aabb bounds_;
};

// ---- Traversal

/// The padded ray is in the near half until `leave` and in the far half from `enter` on. The halves overlap by the
/// margin, so that whatever is put aside is met in order, but for that margin.
template <class T, LeafVisitor<T> Visit, class Probe>
void KdTree::traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
  struct Entry {
    std::uint32_t node;
    T enter, leave;
  };
  const PaddedRay<T> padded(ray, bounds_);
  const Interval<T> range = padded.clip(bounds_, padded.t_max);
  if (nodes_.empty() || range.is_empty()) return;

  FixedStack<Entry, depth_limit> stack;  // K3: each split puts at most one half aside
  std::uint32_t index = 0;
  T t_enter = range.lo, t_leave = range.hi, t_far = padded.t_max;
  for (;;) {
    Node node = nodes_[index];
    while (!node.is_leaf()) {
      probe.node(index, t_enter);
      const int axis = node.axis();
      const T enter_far = padded.enter(axis, node.plane()), leave_near = padded.leave(axis, node.plane());
      const std::uint32_t below = index + 1, above = index + node.to_above();  // K2
      const std::uint32_t near = padded.is_negative[axis] ? above : below;
      const std::uint32_t far = padded.is_negative[axis] ? below : above;
      if (enter_far > t_leave) {
        index = near;
      } else if (leave_near < t_enter) {
        index = far;
      } else {  // NaN, too, leads here
        stack.push({far, enter_far > t_enter ? enter_far : t_enter, t_leave});
        index = near;
        t_leave = leave_near < t_leave ? leave_near : t_leave;
      }
      node = nodes_[index];
    }

    const LeafRange leaf = node.range();
    if (leaf.count == 0) {
      probe.node(index, t_enter);
    } else {
      probe.leaf(index, leaf, t_enter);
      t_far = visit(leaf);
    }

    for (;;) {
      if (stack.empty()) return;
      const Entry next = stack.pop();
      if (next.enter > t_far) {
        probe.cull(next.node, next.enter);
        continue;  // halves overlap, so one put aside earlier may still begin sooner
      }
      index = next.node;
      t_enter = next.enter;
      t_leave = next.leave < t_far ? next.leave : t_far;
      break;
    }
  }
}

// ---- Construction

/// Every cell has a list of events for each axis, sorted once, for the root. A split deals them out to the children in
/// order; only the events of clipped straddlers are new, and merged in.
/// Trees are the same however many threads build: what is built apart is decided by size alone.
class KdTree::Builder {
 public:
  Builder(const Primitives& primitives, const Options& options)
      : primitives_(primitives),
        max_leaf_size_(static_cast<std::uint32_t>(options.max_leaf_size)),
        max_depth_(options.max_depth > 0 ? options.max_depth
                                         : static_cast<int>(8 + 1.3 * std::log2(primitives.size()))),
        costs_{options.traversal_cost, options.intersection_cost, 1 - double(options.empty_bonus)},
        scratch_([&primitives] { return Scratch(primitives.size()); }) {}

  KdTree build();

 private:
  using Event = detail::KdEvent;
  using EventList = detail::KdEventList;
  using Kind = detail::EventKind;

  static constexpr std::uint32_t size_limit = 1u << 27;   ///< Keeps positions, by K5, within 32 bits.
  static constexpr std::uint32_t reference_limit = 16;    // K5
  static constexpr std::uint32_t serial_size = 1u << 14;  ///< Cells that hold fewer are built by one thread.

  /// What a cell holds. A cell that will be a leaf may have the first list only, with one event a primitive.
  struct Content {
    std::array<EventList, 3> events;
    std::uint32_t count = 0;
    std::uint64_t budget = 0;  ///< References that its leaves may have: at least `count`.
  };

  struct Scratch {
    explicit Scratch(std::size_t size) : sides(new detail::KdSide[size]) {}
    std::unique_ptr<detail::KdSide[]> sides;  ///< By primitive; valid for those of the cell being split.
    std::vector<std::uint32_t> straddlers;
    std::array<EventList, 3> fresh;
    std::array<std::array<Content, 2>, depth_limit> levels;  ///< The children along the path of a serial build.
  };

  struct Subtree {
    std::vector<Node> nodes;
    std::vector<std::uint32_t> order;
  };

  Content root_content(Aabb& bounds) const;
  void grow(Content& content, const Aabb& cell, int depth, Subtree& tree);
  void divide(Content& content, const detail::KdSplit& split, const std::array<Aabb, 2>& cells, int child_depth,
              std::array<Content, 2>& children, Scratch& scratch) const;
  void add_straddlers(const Aabb& cell, Content& child, Scratch& scratch) const;
  bool is_leaf(std::uint32_t count, int depth) const { return count <= max_leaf_size_ || depth >= max_depth_; }
  static void make_leaf(const Content& content, Subtree& tree);
  static void append(Subtree& tree, const Subtree& other);

  const Primitives& primitives_;
  const std::uint32_t max_leaf_size_;
  const int max_depth_;
  const detail::KdCosts costs_;
  double clip_slack_ = 0;
  tbb::enumerable_thread_specific<Scratch> scratch_;
};

inline KdTree KdTree::build(const Primitives& primitives, const Options& options) {
  validate(name, options);
  return primitives.size() == 0 ? KdTree{} : Builder(primitives, options).build();
}

inline KdTree KdTree::Builder::build() {
  if (primitives_.size() > size_limit) throw std::length_error("kd-tree: more than 2^27 primitives");
  KdTree tree;
  Content root = root_content(tree.bounds_);
  // Clipping works in double, relative to the cell, and its six cuts misplace points and planes by less than 32 u of
  // the scene's extent. On a primitive almost parallel to a face that is enough to lose what K4 promises.
  clip_slack_ = 0x1p-48 * max_norm(Vec3d(tree.bounds_.hi) - Vec3d(tree.bounds_.lo));
  Subtree all;
  grow(root, tree.bounds_, 0, all);
  tree.nodes_.assign(all.nodes.begin(), all.nodes.end());  // without the spare room of growing
  tree.order_.assign(all.order.begin(), all.order.end());
  return tree;
}

inline auto KdTree::Builder::root_content(Aabb& bounds) const -> Content {
  Content root;
  root.count = primitives_.size();
  root.budget = std::uint64_t(reference_limit) * root.count;
  std::vector<Aabb> boxes(root.count);
  tbb::parallel_for(0u, root.count, [&](std::uint32_t id) { boxes[id] = primitives_.bounds(id); });
  for (const Aabb& box : boxes) bounds.extend(box);
  tbb::parallel_for(0, 3, [&](int axis) {
    EventList& events = root.events[axis];
    events.reserve(2 * boxes.size());
    for (const Kind kind : {Kind::end, Kind::flat, Kind::start}) {
      for (std::uint32_t id = 0; id < root.count; ++id) {
        const float lo = boxes[id].lo[axis], hi = boxes[id].hi[axis];
        if ((kind == Kind::flat) == (lo == hi)) events.emplace_back(kind == Kind::end ? hi : lo, kind, id);
      }
    }
    detail::sort_by_place(events);
  });
  return root;
}

/// Appends the subtree of `content`, which it uses up.
inline void KdTree::Builder::grow(Content& content, const Aabb& cell, int depth, Subtree& tree) {
  if (is_leaf(content.count, depth)) return make_leaf(content, tree);
  const detail::KdSplit split = detail::cheapest_split(content.events, content.count, cell, costs_);
  if (split.axis < 0 || std::uint64_t(split.count_below) + split.count_above > content.budget) {
    return make_leaf(content, tree);
  }
  std::array<Aabb, 2> cells{cell, cell};  // K1
  cells[0].hi[split.axis] = cells[1].lo[split.axis] = split.place;

  const std::size_t index = tree.nodes.size();
  tree.nodes.emplace_back();
  std::size_t to_above;
  Scratch& scratch = scratch_.local();
  if (content.count < serial_size) {
    std::array<Content, 2>& children = scratch.levels[depth];
    divide(content, split, cells, depth + 1, children, scratch);
    grow(children[0], cells[0], depth + 1, tree);
    to_above = tree.nodes.size() - index;
    grow(children[1], cells[1], depth + 1, tree);
  } else {
    std::array<Content, 2> children;
    divide(content, split, cells, depth + 1, children, scratch);
    content = {};
    Subtree upper;
    tbb::parallel_invoke([&] { grow(children[0], cells[0], depth + 1, tree); },
                         [&] { grow(children[1], cells[1], depth + 1, upper); });
    to_above = tree.nodes.size() - index;
    append(tree, upper);
  }
  if (to_above > Node::link_limit) throw std::length_error("kd-tree: more nodes than a link can span");
  tree.nodes[index] = Node::inner(split.axis, split.place, static_cast<std::uint32_t>(to_above));  // K2
}

inline void KdTree::Builder::make_leaf(const Content& content, Subtree& tree) {
  const auto first = static_cast<std::uint32_t>(tree.order.size());
  for (const Event& event : content.events[0]) {
    if (event.kind() != Kind::end) tree.order.push_back(event.id());
  }
  tree.nodes.push_back(Node::leaf({first, content.count}));
}

/// Links are relative, so only the leaves' positions move.
inline void KdTree::Builder::append(Subtree& tree, const Subtree& other) {
  const auto moved = static_cast<std::uint32_t>(tree.order.size());
  for (const Node& node : other.nodes) {
    tree.nodes.push_back(node.is_leaf() ? Node::leaf({node.range().first + moved, node.range().count}) : node);
  }
  tree.order.insert(tree.order.end(), other.order.begin(), other.order.end());
}

/// Deals the events out to the two children, each of which may be left with what a leaf needs.
inline void KdTree::Builder::divide(Content& content, const detail::KdSplit& split, const std::array<Aabb, 2>& cells,
                                    int child_depth, std::array<Content, 2>& children, Scratch& scratch) const {
  auto& [low, high] = children;
  if (split.count_below == 0 || split.count_above == 0) {
    std::swap(split.count_below == 0 ? high : low, content);
    Content& none = split.count_below == 0 ? low : high;
    none.count = 0;
    return none.events[0].clear();
  }

  detail::KdSide* const sides = scratch.sides.get();
  const EventList& along = content.events[split.axis];
  const std::uint32_t only_high = detail::take_sides(along, split, content.count, sides, scratch.straddlers);
  high.count = only_high + static_cast<std::uint32_t>(scratch.straddlers.size());
  low.count = content.count - only_high;
  low.budget = content.budget * low.count / (std::uint64_t(low.count) + high.count);
  high.budget = content.budget - low.budget;

  const std::array<bool, 2> are_leaves{is_leaf(low.count, child_depth), is_leaf(high.count, child_depth)};
  for (int axis = 0; axis < 3 && !(are_leaves[0] && are_leaves[1]); ++axis) {
    for (Content& child : children) {
      child.events[axis].clear();  // so that nothing is moved
      child.events[axis].resize(2 * std::size_t(child.count) + 1);
    }
    detail::deal(content.events[axis], sides, low.events[axis], high.events[axis]);
  }
  for (const int child : {0, 1}) {
    if (!are_leaves[child]) {
      add_straddlers(cells[child], children[child], scratch);
      continue;
    }
    EventList& list = children[child].events[0];
    list.clear();
    const detail::KdSide other = child == 0 ? detail::KdSide::above : detail::KdSide::below;
    for (const Event& event : along) {
      if (event.kind() != Kind::end && sides[event.id()] != other) list.push_back(event);
    }
  }
}

/// Clips the straddlers to the child's cell and merges their events into its lists.
inline void KdTree::Builder::add_straddlers(const Aabb& cell, Content& child, Scratch& scratch) const {
  if (scratch.straddlers.empty()) return;
  Aabb widened;
  for (int axis = 0; axis < 3; ++axis) {
    widened.lo[axis] = round_down(cell.lo[axis] - clip_slack_);
    widened.hi[axis] = round_up(cell.hi[axis] + clip_slack_);
    scratch.fresh[axis].clear();
  }
  for (const std::uint32_t id : scratch.straddlers) {
    Aabb part = intersection(primitives_.clip(id, widened), cell);
    if (part.is_empty()) part = intersection(primitives_.bounds(id), cell);  // a straddler is never dropped
    if (part.is_empty()) part = cell;
    for (int axis = 0; axis < 3; ++axis) {
      EventList& fresh = scratch.fresh[axis];
      const bool is_flat = part.lo[axis] == part.hi[axis];
      fresh.emplace_back(part.lo[axis], is_flat ? Kind::flat : Kind::start, id);
      if (!is_flat) fresh.emplace_back(part.hi[axis], Kind::end, id);
    }
  }
  for (int axis = 0; axis < 3; ++axis) detail::merge_into(child.events[axis], scratch.fresh[axis]);
}

static_assert(Accelerator<KdTree>);

}  // namespace sightline
