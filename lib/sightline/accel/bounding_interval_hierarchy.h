#pragma once

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/bounding_interval_hierarchy_builder.h"
#include "sightline/accel/bounding_interval_hierarchy_node.h"
#include "sightline/accel/large_pages.h"
#include "sightline/accel/padded_ray.h"
#include "sightline/accel/ray_packet.h"

namespace sightline {

struct BoundingIntervalHierarchyOptions {
  Quality quality = Quality::balanced;  ///< `fast` halves, as in 2006; others weigh 16 or 64 bins by surface area.
  int max_leaf_size = 8;                ///< A node this small may be a leaf, and is one where halving divides.
  int max_depth = 64;                   ///< A node this deep is never divided, whatever it holds.
  bool slabs = true;                    ///< Each node is cut to a slab before it divides.
  bool lazy = false;                    ///< Divide a node when the first ray reaches it.

  static constexpr std::array<OptionField<BoundingIntervalHierarchyOptions>, 5> fields() {
    using O = BoundingIntervalHierarchyOptions;
    return {{{"quality", &O::quality, 0, 2, "fast halves boxes as in 2006; balanced and best try 16 and 64 bins"},
             {"max_leaf_size", &O::max_leaf_size, 1, 1024, "most primitives in a leaf, where they can be parted"},
             {"max_depth", &O::max_depth, 0, 96, "a node this deep is never divided, whatever it holds"},
             {"slabs", &O::slabs, 0, 1, "cut each node to a slab before it divides"},
             {"lazy", &O::lazy, 0, 1, "divide a node when the first ray reaches it"}}};
  }
};

/// Bounding interval hierarchy: primitives parted by their centers, each part cut off by one clip plane.
///   H1  What a node holds lies within its slab; the child below lies below its clip plane and the one above above its
///       own, which may overlap or leave a gap; what a leaf holds lies below the one and above the other.
///   H2  The primitives of a node stand next to each other in the leaf order: first those of the child below.
///   H3  Two children are neighbours, so one number links both.
///   H4  No path exceeds max_depth, so the traversal stack cannot overflow.
///   H5  How a node divides depends on its primitives and its boxes alone, so the order in which nodes are divided, by
///       threads or by rays, does not show in the tree.
/// Clip planes alone leave space open across the other axes, and the farther side of their own. Waechter and Keller cut
/// it off by nodes with one child; here every node is such a node as well, across the axis on which that takes away
/// most of what rays see: one visit for both.
/// Waechter and Keller, "Instant ray tracing: the bounding interval hierarchy", 2006; the weighing of splits: MacDonald
/// and Booth, "Heuristics for ray tracing using space subdivision", 1990, and Wald, "On fast construction of SAH-based
/// bounding volume hierarchies", 2007.
class BoundingIntervalHierarchy {
 public:
  static constexpr std::string_view name = "bih";
  static constexpr std::string_view description =
      "sorted by centers, a slab and two clip planes a node, lazily if asked; Waechter and Keller 2006";
  static constexpr std::size_t node_bytes = 24;
  using Options = BoundingIntervalHierarchyOptions;

  /// \throws std::invalid_argument for options out of their limits, std::length_error beyond 2^28 primitives.
  static BoundingIntervalHierarchy build(const Primitives& primitives, const Options& options = {});

  /// See accelerator.h.
  static BoundingIntervalHierarchy refit(BoundingIntervalHierarchy tree, const Primitives& primitives);
  bool can_refit() const { return !lazy_; }

  /// Of a lazy tree: the nodes made so far, and what it keeps to make the others.
  std::size_t memory_bytes() const;
  std::span<const std::uint32_t> leaf_order() const { return order_; }
  bool is_order_final() const { return !lazy_; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
    if (!order_.empty()) walk(PaddedRay<T>(ray, bounds_), visit, probe);
  }

  /// All leaves that any ray of a packet meets; the far limit is that of all. Made with bounds(), and coherent.
  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const RayPacket<T>& rays, Visit&& visit, Probe& probe) const {
    if (!order_.empty()) walk(rays, visit, probe);
  }
  const Aabb& bounds() const { return bounds_; }

  /// Children before siblings. What a lazy tree has not divided yet shows as a leaf.
  template <class See>
  void for_each_cell(See&& see) const;

  template <class See>
  void for_each_leaf(See&& see) const;

 private:
  static constexpr int most_levels = 96;
  using Node = detail::BihNode;
  static_assert(sizeof(Node) == node_bytes);

  template <class Padded, class Visit, class Probe>
  void walk(const Padded& padded, Visit& visit, Probe& probe) const;
  void copy(const Node* from, std::size_t source, std::size_t target);
  template <class See>
  void show(See& see, std::uint32_t number, const Aabb& region, int depth) const;

  Aabb bounds_;
  std::vector<std::uint32_t> order_;
  Node* nodes_ = nullptr;                     ///< own_nodes_ or the builder's: neither moves when the tree does.
  LargeVector<Node> own_nodes_;               ///< Of an eager tree.
  std::unique_ptr<detail::BihBuilder> lazy_;  ///< Makes the nodes of a lazy tree; null in an eager one.
};

inline BoundingIntervalHierarchy BoundingIntervalHierarchy::build(const Primitives& primitives,
                                                                  const Options& options) {
  validate(name, options);
  if (primitives.size() > Node::most_primitives) {
    throw std::length_error("bih: " + std::to_string(primitives.size()) + " primitives; expected at most " +
                            std::to_string(Node::most_primitives));
  }
  BoundingIntervalHierarchy tree;
  if (primitives.size() == 0) return tree;
  tree.order_.resize(primitives.size());
  const detail::BihSettings settings{options.quality, options.max_leaf_size, options.max_depth, options.slabs};
  auto builder = std::make_unique<detail::BihBuilder>(primitives, settings, tree.order_.data());
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
  if (Node::state_of(link) == Node::leaf) return;
  const std::size_t pair = own_nodes_.size() / 2;
  own_nodes_[target].link = Node::link_of(Node::inner, pair);
  own_nodes_.resize(own_nodes_.size() + 2);
  for (const int side : {0, 1}) copy(from, 2 * std::size_t(Node::number_of(link)) + side, 2 * pair + side);
}

/// Children stand behind their parents, so the last nodes come first.
inline BoundingIntervalHierarchy BoundingIntervalHierarchy::refit(BoundingIntervalHierarchy tree,
                                                                  const Primitives& primitives) {
  std::vector<Aabb> boxes(tree.own_nodes_.size());
  for (std::size_t i = tree.own_nodes_.size(); i-- > 0;) {
    if (i == 1) continue;  // the root has no sibling
    Node& node = tree.own_nodes_[i];
    const bool is_leaf = Node::state_of(node.link) == Node::leaf;
    const std::size_t below = is_leaf ? i : 2 * std::size_t(Node::number_of(node.link)),
                      above = is_leaf ? i : below + 1;
    if (is_leaf) {
      boxes[i] = bounds_of(primitives, tree.order_, node.leaf_range(node.link));
    } else {
      boxes[i] = boxes[below];
      boxes[i].extend(boxes[above]);
    }
    const auto slab = static_cast<int>(node.slab_axis()), clip = static_cast<int>(node.clip_axis());
    node.slab[0] = boxes[i].lo[slab];
    node.slab[1] = boxes[i].hi[slab];
    node.clip[0] = boxes[below].hi[clip];  // H1
    node.clip[1] = boxes[above].lo[clip];
  }
  if (!boxes.empty()) tree.bounds_ = boxes[0];
  return tree;
}

inline std::size_t BoundingIntervalHierarchy::memory_bytes() const {
  const std::size_t nodes = lazy_ ? lazy_->memory_bytes() : own_nodes_.size() * sizeof(Node);
  return nodes + order_.size() * sizeof(std::uint32_t);
}

// ---- Traversal

/// Of a padded ray, or of a packet that is taken for one.
template <class Padded, class Visit, class Probe>
void BoundingIntervalHierarchy::walk(const Padded& padded, Visit& visit, Probe& probe) const {
  using T = std::remove_cv_t<decltype(padded.t_max)>;
  T far = padded.t_max;
  const Interval<T> inside = padded.clip(bounds_, far);
  if (inside.is_empty()) return;

  typename Padded::Axis axes[3];
  std::uint32_t downward = 0;  // a bit for each axis
  for (int axis = 0; axis < 3; ++axis) {
    axes[axis] = padded.along(axis);
    downward |= static_cast<std::uint32_t>(padded.is_negative[axis]) << axis;
  }
  struct Entry {
    std::uint32_t node;
    T lo, hi;  ///< Parameters at which the padded ray is within the planes on the path.
  };
  Entry stack[most_levels + 1];  // H4; and one that is written but not kept
  Entry* top = stack;
  std::uint32_t at = 0;
  T lo = inside.lo, hi = inside.hi;
  for (;;) {
    Node& node = nodes_[at];
    std::uint32_t link = Node::link_in(node);
    if (!Node::is_made(link)) [[unlikely]]
      link = lazy_->require(node, link);

    // All four planes at once: their reads wait for each other, the arithmetic does not. NaN keeps what was.
    const auto &slab = axes[node.slab_axis()], &clip = axes[node.clip_axis()];
    const std::uint32_t slab_near = downward >> node.slab_axis() & 1, near = downward >> node.clip_axis() & 1;
    const T into = slab.enter(node.slab[slab_near]), out = slab.leave(node.slab[1 - slab_near]);
    const T enter = clip.enter(node.clip[1 - near]), leave = clip.leave(node.clip[near]);
    lo = into > lo ? into : lo;
    hi = out < hi ? out : hi;
    const T enter_second = enter > lo ? enter : lo, leave_first = leave < hi ? leave : hi;

    if (Node::state_of(link) == Node::leaf) {
      if (enter_second <= leave_first) {  // H1: between the clip planes
        const LeafRange range = node.leaf_range(link);
        probe.leaf(at, range, enter_second);
        far = visit(range);
        if (!(far > padded.t_min)) return;  // hits lie beyond t_min
      } else {
        probe.node(at, lo);
      }
    } else {
      probe.node(at, lo);
      const std::uint32_t first = 2 * Node::number_of(link) + near, second = first ^ 1;  // H3
      const bool meets_second = enter_second <= hi;
      if (lo <= leave_first) {
        *top = {second, enter_second, hi};
        top += meets_second;  // no branch: whether both are met is hard to foretell
        at = first;
        hi = leave_first;
        continue;
      }
      if (meets_second) {
        at = second;
        lo = enter_second;
        continue;
      }
    }

    // Overlapping regions: what was put aside earlier may lie nearer, so the walk goes on after a cull.
    for (;;) {
      if (top == stack) return;
      --top;
      at = top->node;
      lo = top->lo;
      if (!(lo > far)) break;
      probe.cull(at, lo);
    }
    hi = std::min(top->hi, far);
  }
}

template <class See>
void BoundingIntervalHierarchy::for_each_cell(See&& see) const {
  if (!order_.empty()) show(see, 0, bounds_, 0);
}

/// Those of an eager tree without the regions.
template <class See>
void BoundingIntervalHierarchy::for_each_leaf(See&& see) const {
  for (const Node& node : own_nodes_) {
    if (Node::state_of(node.link) == Node::leaf) see(node.leaf_range(node.link));
  }
  if (!lazy_) return;
  for_each_cell([&](const Cell& cell) {
    if (cell.is_leaf) see(cell.range);
  });
}

template <class See>
void BoundingIntervalHierarchy::show(See& see, std::uint32_t number, const Aabb& region, int depth) const {
  const Node& node = nodes_[number];
  const std::uint32_t link = Node::link_in(node);
  if (!Node::is_made(link)) {
    return see(Cell{region, depth, true, lazy_->postponed(Node::number_of(link)).range, number});
  }
  const int slab = static_cast<int>(node.slab_axis()), clip = static_cast<int>(node.clip_axis());
  Aabb below = region;
  below.lo[slab] = std::max(below.lo[slab], node.slab[0]);
  below.hi[slab] = std::min(below.hi[slab], node.slab[1]);
  Aabb above = below;
  below.hi[clip] = std::min(below.hi[clip], node.clip[0]);
  above.lo[clip] = std::max(above.lo[clip], node.clip[1]);
  if (Node::state_of(link) == Node::leaf) {
    return see(Cell{intersection(below, above), depth, true, node.leaf_range(link), number});
  }
  see(Cell{region, depth, false, {}, number});
  show(see, 2 * Node::number_of(link), below, depth + 1);
  show(see, 2 * Node::number_of(link) + 1, above, depth + 1);
}

static_assert(Refittable<BoundingIntervalHierarchy>);
static_assert(Accelerator<BoundingIntervalHierarchy>);

}  // namespace sightline
