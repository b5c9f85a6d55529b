#pragma once
/// How a kd-tree is built: the binary tree, whose splits are then packed as treelets.
///
/// Wald and Havran, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)", 2006.

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sightline/accel/kd_tree_events.h"
#include "sightline/accel/kd_tree_packing.h"
#include "sightline/accel/primitives.h"
#include "sightline/math/rounding.h"

namespace sightline::detail {

/// A binary tree, depth first, and the primitives of its leaves.
struct KdSubtree {
  std::vector<KdNode> nodes;
  std::vector<std::uint32_t> order;
};

struct KdSettings {
  std::uint32_t max_leaf_size;  ///< A cell that holds no more is never split.
  int max_depth;                ///< Of splits along a path.
  KdCosts costs;
  std::uint32_t reference_limit;  ///< Of the leaves together, for each primitive.
  bool is_widest_only;            ///< Planes are sought along the widest axis of each cell.
};

/// Every cell has a list of events for each axis, sorted once, for the root. A split deals them out to the children in
/// order; only the events of clipped straddlers are new, and merged in.
/// Trees are the same however many threads build: what is built apart is decided by size alone.
class KdTreeBuilder {
 public:
  KdTreeBuilder(const Primitives& primitives, const KdSettings& settings)
      : primitives_(primitives), settings_(settings), scratch_([&primitives] { return Scratch(primitives.size()); }) {}

  /// Sets `bounds` to the root's cell.
  KdSubtree build(Aabb& bounds);

 private:
  using Event = KdEvent;
  using EventList = KdEventList;
  using Kind = EventKind;
  using Subtree = KdSubtree;
  using Node = KdNode;

  static constexpr std::uint32_t serial_size = 1u << 14;  ///< Cells that hold fewer are built by one thread.
  static constexpr std::uint32_t crowd_size = 64;         ///< Cells that hold more are divided at a loss, too.
  static constexpr double least_gain = 0.1;               ///< Share of its cost that a split saves of a crowded cell.
  static constexpr double most_parts = 1.8;               ///< Of a primitive in the halves of one, on average.

  /// What a cell holds. A cell that will be a leaf may have the first list only, with one event a primitive.
  struct Content {
    std::array<EventList, 3> events;
    std::uint32_t count = 0;
    std::uint64_t budget = 0;  ///< References that its leaves may have: at least `count`.
  };

  struct Scratch {
    explicit Scratch(std::size_t size) : sides(new KdSide[size]) {}
    std::unique_ptr<KdSide[]> sides;  ///< By primitive; valid for those of the cell being split.
    std::vector<std::uint32_t> straddlers;
    std::array<EventList, 3> fresh;
    std::array<std::array<Content, 2>, kd_depth_limit> levels;  ///< The children along the path of a serial build.
  };

  Content root_content(Aabb& bounds) const;
  void grow(Content& content, const Aabb& cell, int depth, Subtree& tree);
  KdSplit split_of(const Content& content, const Aabb& cell) const;
  void divide(Content& content, const KdSplit& split, const std::array<Aabb, 2>& cells, int child_depth,
              std::array<Content, 2>& children, Scratch& scratch) const;
  void add_straddlers(const Aabb& cell, Content& child, Scratch& scratch) const;
  bool is_leaf(std::uint32_t count, int depth) const {
    return count <= settings_.max_leaf_size || depth >= settings_.max_depth;
  }
  static void make_leaf(const Content& content, Subtree& tree);
  static void append(Subtree& tree, const Subtree& other);

  const Primitives& primitives_;
  const KdSettings settings_;
  double clip_slack_ = 0;
  tbb::enumerable_thread_specific<Scratch> scratch_;
};

inline KdSubtree KdTreeBuilder::build(Aabb& bounds) {
  if (primitives_.size() > KdChild::position_limit) throw std::length_error("kd-tree: more than 2^26 primitives");
  Content root = root_content(bounds);
  // Clipping works in double, relative to the cell, and its six cuts misplace points and planes by less than 32 u of
  // the scene's extent. On a primitive almost parallel to a face that is enough to lose what K4 promises.
  clip_slack_ = 0x1p-48 * max_norm(Vec3d(bounds.hi) - Vec3d(bounds.lo));
  Subtree all;
  grow(root, bounds, 0, all);
  return all;
}

inline auto KdTreeBuilder::root_content(Aabb& bounds) const -> Content {
  Content root;
  root.count = primitives_.size();
  root.budget =
      std::min<std::uint64_t>(std::uint64_t(settings_.reference_limit) * root.count, KdChild::position_limit);  // K5
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
    sort_by_place(events);
  });
  return root;
}

/// Appends the subtree of `content`, which it uses up.
inline void KdTreeBuilder::grow(Content& content, const Aabb& cell, int depth, Subtree& tree) {
  if (is_leaf(content.count, depth)) return make_leaf(content, tree);
  const KdSplit split = split_of(content, cell);
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

/// The cheapest split. A crowded cell that it does not make much cheaper is halved instead: where long primitives lie
/// askew, a cell has to be halved across all three axes before that pays. Parts that still hold almost everything are
/// not worth it: primitives that lie upon one another.
inline KdSplit KdTreeBuilder::split_of(const Content& content, const Aabb& cell) const {
  const double unsplit = settings_.costs.intersection * content.count;
  const KdSplit cheapest =
      cheapest_split(content.events, content.count, cell, settings_.costs, settings_.is_widest_only);
  if (content.count <= crowd_size || (cheapest.axis >= 0 && cheapest.cost < (1 - least_gain) * unsplit)) {
    return cheapest;
  }
  const KdSplit half = halving_split(content.events, content.count, cell);
  if (half.axis < 0 || double(half.count_below) + half.count_above > most_parts * content.count) return cheapest;
  return half;
}

inline void KdTreeBuilder::make_leaf(const Content& content, Subtree& tree) {
  const auto first = static_cast<std::uint32_t>(tree.order.size());
  for (const Event& event : content.events[0]) {
    if (event.kind() != Kind::end) tree.order.push_back(event.id());
  }
  tree.nodes.push_back(Node::leaf({first, content.count}));
}

/// Links are relative, so only the leaves' positions move.
inline void KdTreeBuilder::append(Subtree& tree, const Subtree& other) {
  const auto moved = static_cast<std::uint32_t>(tree.order.size());
  for (const Node& node : other.nodes) {
    tree.nodes.push_back(node.is_leaf() ? Node::leaf({node.range().first + moved, node.range().count}) : node);
  }
  tree.order.insert(tree.order.end(), other.order.begin(), other.order.end());
}

/// Deals the events out to the two children, each of which may be left with what a leaf needs.
inline void KdTreeBuilder::divide(Content& content, const KdSplit& split, const std::array<Aabb, 2>& cells,
                                  int child_depth, std::array<Content, 2>& children, Scratch& scratch) const {
  auto& [low, high] = children;
  if (split.count_below == 0 || split.count_above == 0) {
    std::swap(split.count_below == 0 ? high : low, content);
    Content& none = split.count_below == 0 ? low : high;
    none.count = 0;
    return none.events[0].clear();
  }

  KdSide* const sides = scratch.sides.get();
  const EventList& along = content.events[split.axis];
  const std::uint32_t only_high = take_sides(along, split, content.count, sides, scratch.straddlers);
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
    deal(content.events[axis], sides, low.events[axis], high.events[axis]);
  }
  for (const int child : {0, 1}) {
    if (!are_leaves[child]) {
      add_straddlers(cells[child], children[child], scratch);
      continue;
    }
    EventList& list = children[child].events[0];
    list.clear();
    const KdSide other = child == 0 ? KdSide::above : KdSide::below;
    for (const Event& event : along) {
      if (event.kind() != Kind::end && sides[event.id()] != other) list.push_back(event);
    }
  }
}

/// Clips the straddlers to the child's cell and merges their events into its lists.
inline void KdTreeBuilder::add_straddlers(const Aabb& cell, Content& child, Scratch& scratch) const {
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
  for (int axis = 0; axis < 3; ++axis) merge_into(child.events[axis], scratch.fresh[axis]);
}

}  // namespace sightline::detail
