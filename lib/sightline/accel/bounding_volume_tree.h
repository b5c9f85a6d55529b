#pragma once
/// Bounding volume hierarchies over boxes, balls and cylinders: one structure, the volume a parameter.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <memory>
#include <ranges>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/bounding_box.h"
#include "sightline/accel/bounding_cylinder.h"
#include "sightline/accel/bounding_sphere.h"
#include "sightline/accel/fixed_stack.h"
#include "sightline/accel/large_pages.h"
#include "sightline/accel/object_split.h"
#include "sightline/accel/object_sweep.h"
#include "sightline/accel/reference_split.h"
#include "sightline/accel/reference_sweep.h"
#include "sightline/accel/visit_leaf.h"

namespace sightline {

/// Costs are relative to each other; a hierarchy of boxes opens a node at cost 1.
template <BoundingVolume Volume>
struct BoundingVolumeOptions {
  Quality quality = Quality::balanced;       ///< `fast` weighs cuts along one axis only, `best` all there are.
  int max_leaf_size = 8;                     ///< More primitives than this are always divided.
  float traversal_cost = Volume::test_cost;  ///< Opening a node: testing the volumes of both children.
  float intersection_cost = 0.15f;           ///< One primitive test: those of a leaf are made together.
  int bins = 32;                             ///< On each axis, when many primitives are divided.
  int splits = -1;  ///< References that long primitives may have beyond one each, in percent of all. Boxes only.

  static constexpr auto fields() {
    using O = BoundingVolumeOptions;
    using Field = OptionField<O>;
    constexpr Field quality{"quality", &O::quality, 0, 2, object_quality_help};
    constexpr Field leaf{"max_leaf_size", &O::max_leaf_size, 1, 64, "most primitives in a leaf"};
    constexpr Field inner{"traversal_cost", &O::traversal_cost, 0, 1000, "cost of testing the volumes of two children"};
    constexpr Field test{"intersection_cost", &O::intersection_cost, 0.001, 1000, "cost of testing one primitive"};
    constexpr Field bin{"bins", &O::bins, 2, max_split_bins, object_bins_help};
    constexpr Field split{"splits", &O::splits, -1, 1000, reference_splits_help};
    if constexpr (Volume::needs_points) {
      return std::array{quality, leaf, inner, test, bin};
    } else {
      return std::array{quality, leaf, inner, test, bin, split};
    }
  }
};

/// Each node bounds the primitives below it by one volume; every primitive is in exactly one leaf, unless it was split
/// (reference_split.h).
///   V1  A node's volume contains its primitives, or the parts of split ones that it has references to. A leaf holds a
///       primitive once.
///   V2  Nodes stand depth first: the left child follows its parent, and only the right one is linked, relative to the
///       parent, so that subtrees built apart are joined by copying.
///   V3  Of a path's nodes at most heuristic_depth divide by cost; from then on they halve, so a leaf is at most
///       heuristic_depth + 32 deep. A traversal holds one node back for each level: its stack cannot overflow.
template <BoundingVolume Volume>
class BoundingVolumeHierarchy {
  struct Node {
    Volume volume;
    std::uint32_t link;   ///< Leaf: first position. Inner node: from here to the right child.
    std::uint32_t count;  ///< Primitives of a leaf; 0 for inner nodes.

    bool is_leaf() const { return count > 0; }
    LeafRange range() const { return is_leaf() ? LeafRange{link, count} : LeafRange{}; }
  };

 public:
  static constexpr std::string_view name = Volume::tree_name;
  static constexpr std::string_view description = Volume::tree_description;
  static constexpr std::size_t node_bytes = sizeof(Node);
  using Options = BoundingVolumeOptions<Volume>;

  static BoundingVolumeHierarchy build(const Primitives& primitives, const Options& options = {}) {
    validate(name, options);
    BoundingVolumeHierarchy tree;
    if (primitives.size() > 0) Builder(primitives, options).build(tree);
    return tree;
  }

  /// See accelerator.h. Of boxes: other volumes are not made of those below them.
  static BoundingVolumeHierarchy refit(BoundingVolumeHierarchy tree,
                                       const Primitives& primitives) requires(!Volume::needs_points);
  bool can_refit() const { return true; }

  std::size_t memory_bytes() const { return nodes_.size() * sizeof(Node) + order_.size() * sizeof(std::uint32_t); }
  std::span<const std::uint32_t> leaf_order() const { return order_; }
  bool is_order_final() const { return true; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const;

  template <class See>
  void for_each_cell(See&& see) const {
    if (!nodes_.empty()) see_subtree(0, 0, see);
  }

  /// See for_each_leaf in accelerator.h.
  template <class See>
  void for_each_leaf(See&& see) const {
    for (const Node& node : nodes_) {
      if (node.is_leaf()) see(node.range());
    }
  }

 private:
  static constexpr int heuristic_depth = 48;
  static constexpr int max_depth = heuristic_depth + 32;

  class Builder;

  template <class See>
  void see_subtree(std::uint32_t index, int depth, See& see) const {
    const Node& node = nodes_[index];
    see(Cell{node.volume.region(), depth, node.is_leaf(), node.range(), index});
    if (node.is_leaf()) return;
    see_subtree(index + 1, depth + 1, see);
    see_subtree(index + node.link, depth + 1, see);
  }

  LargeBuffer<Node> nodes_;
  std::vector<std::uint32_t> order_;
  Aabb bounds_;
};

// ---- Traversal

template <BoundingVolume Volume>
template <class T, LeafVisitor<T> Visit, class Probe>
void BoundingVolumeHierarchy<Volume>::traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
  using Time = typename Volume::template Test<T>::Time;
  struct Waiting {
    std::uint32_t node;
    Time enter;
  };
  const PaddedRay<T> padded(ray, bounds_);
  if (!(padded.t_min <= padded.t_max)) return;
  const typename Volume::template Test<T> test(padded);
  T far = padded.t_max;
  FixedStack<Waiting, max_depth> stack;  // V3

  const Interval<Time> whole = test(nodes_[0].volume, nodes_[0].volume, far).first;
  if (whole.is_empty()) return;
  Waiting at{0, whole.lo};
  while (true) {
    const Node& node = nodes_[at.node];
    if (node.is_leaf()) {
      probe.leaf(at.node, node.range(), static_cast<double>(at.enter));
      far = detail::visit_leaf<T>(visit, node.range());
      if (far < padded.t_min) return;
    } else {
      probe.node(at.node, static_cast<double>(at.enter));
      const std::uint32_t left = at.node + 1, right = at.node + node.link;
      const auto [in_left, in_right] = test(nodes_[left].volume, nodes_[right].volume, far);
      const Waiting to_left{left, in_left.lo}, to_right{right, in_right.lo};
      const bool meets_left = !in_left.is_empty(), meets_right = !in_right.is_empty();
      if (meets_left && meets_right) {
        const bool is_left_nearer = to_left.enter <= to_right.enter;
        stack.push(is_left_nearer ? to_right : to_left);
        at = is_left_nearer ? to_left : to_right;
        continue;
      }
      if (meets_left || meets_right) {
        at = meets_left ? to_left : to_right;
        continue;
      }
    }
    // Those put aside are in no order of distance: their volumes overlap.
    while (true) {
      if (stack.empty()) return;
      at = stack.pop();
      if (at.enter <= far) break;
      probe.cull(at.node, static_cast<double>(at.enter));
    }
  }
}

// ---- Construction

template <BoundingVolume Volume>
class BoundingVolumeHierarchy<Volume>::Builder {
 public:
  Builder(const Primitives& primitives, const Options& options)
      : primitives_(primitives),
        options_(options),
        costs_{options.traversal_cost, options.intersection_cost, options.max_leaf_size, options.bins,
               options.quality} {}

  void build(BoundingVolumeHierarchy& tree) {
    LargeBuffer<BoundsReference> references = references_of(
        primitives_, Volume::needs_points ? 0 : splits_of(primitives_, options_.splits, options_.quality));
    const std::size_t count = references.size();
    if constexpr (Volume::needs_points) {
      points_per_item_ = most_points();
      points_.resize(count * points_per_item_);
    }
    tree.order_.resize(count);
    order_ = tree.order_;
    if (costs_.quality == Quality::best) {
      ReferenceSweep<Area> sweep(std::move(references), costs_);
      grow_all(sweep, sweep.whole(), tree);
    } else {
      ObjectSplitter<Area> splitter(costs_);
      grow_all(splitter, whole_of(references.part(0, count)), tree);
    }
    if (count > primitives_.size()) merge_leaves(tree);
  }

 private:
  using Nodes = std::vector<Node>;
  struct Area {
    float operator()(float x, float y, float z) const { return Volume::half_area_around(x, y, z); }
  };
  using Sweep = ObjectSweep<Area>;

  /// Subtrees smaller than this are not worth a task. Leaves are smaller.
  static constexpr std::uint32_t task_size = 4096;

  std::size_t most_points() const {
    using Range = tbb::blocked_range<std::uint32_t>;
    const auto most_in = [&](const Range& ids, int most) {
      for (std::uint32_t id : std::views::iota(ids.begin(), ids.end())) {
        most = std::max(most, primitives_.hull(id).points.size());
      }
      return most;
    };
    const int most =
        tbb::parallel_reduce(Range(0, primitives_.size()), 1, most_in, [](int a, int b) { return std::max(a, b); });
    return static_cast<std::size_t>(most);
  }

  /// A subtree while it is built: either all its nodes, or the root and the subtrees below it.
  struct Piece {
    Nodes nodes;
    std::unique_ptr<Piece> below, above;
    std::size_t size = 0;  ///< Nodes of all.
  };

  template <class Divider, class Part>
  void grow_all(Divider& divider, const Part& all, BoundingVolumeHierarchy& tree) {
    tree.bounds_ = all.box();
    Piece root;
    grow_apart(divider, all, root, 0, 0);
    tree.nodes_ = joined(root);
  }

  /// Makes the subtree of a part, whose leaves take the positions from `first` on, with as many threads as there are.
  template <class Divider, class Part>
  void grow_apart(Divider& divider, const Part& part, Piece& piece, std::uint32_t first, int depth) {
    if (part.count() < task_size) {
      grow(divider, part, piece.nodes, first, depth);
      piece.size = piece.nodes.size();
      return;
    }
    const auto halves = divide(divider, part, depth);
    const std::uint32_t middle = first + halves->below.count();
    piece.below = std::make_unique<Piece>();
    piece.above = std::make_unique<Piece>();
    tbb::parallel_invoke([&] { grow_apart(divider, halves->below, *piece.below, first, depth + 1); },
                         [&] { grow_apart(divider, halves->above, *piece.above, middle, depth + 1); });
    piece.size = 1 + piece.below->size + piece.above->size;
    piece.nodes.push_back({volume_of(part, first), static_cast<std::uint32_t>(1 + piece.below->size), 0});
  }

  static LargeBuffer<Node> joined(const Piece& root) {
    LargeBuffer<Node> nodes(root.size);
    std::vector<std::pair<const Piece*, std::size_t>> places{{&root, 0}};
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto [piece, place] = places[i];
      if (!piece->below) continue;
      places.emplace_back(piece->below.get(), place + 1);
      places.emplace_back(piece->above.get(), place + 1 + piece->below->size);  // V2
    }
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
      std::copy(places[i].first->nodes.begin(), places[i].first->nodes.end(), nodes.data() + places[i].second);
    });
    return nodes;
  }

  /// Drops ids that repeat within a leaf.
  static void merge_leaves(BoundingVolumeHierarchy& tree) {
    LeafMerger merger(tree.order_);
    for (Node& node : tree.nodes_.part(0, tree.nodes_.size())) {  // in order of position: V2
      if (!node.is_leaf()) continue;
      const LeafRange merged = merger.merge(node.range());
      node.link = merged.first;
      node.count = merged.count;
    }
    merger.finish();
  }

  /// Appends the subtree of a part, whose leaves take the positions from `first` on.
  template <class Divider, class Part>
  void grow(Divider& divider, const Part& part, Nodes& nodes, std::uint32_t first, int depth) {
    if constexpr (!std::is_same_v<Divider, Sweep>) {
      if (part.count() <= Sweep::most && costs_.quality != Quality::fast) {
        Sweep sweep(part.references(), costs_);
        return grow(sweep, sweep.whole(), nodes, first, depth);
      }
    }
    const std::size_t self = nodes.size();
    nodes.emplace_back();
    if (const auto halves = divide(divider, part, depth)) {
      grow(divider, halves->below, nodes, first, depth + 1);
      nodes[self].link = static_cast<std::uint32_t>(nodes.size() - self);
      nodes[self].count = 0;
      grow(divider, halves->above, nodes, first + halves->below.count(), depth + 1);
    } else {
      nodes[self].link = first;
      nodes[self].count = part.count();
      finish_leaf(part, first);
    }
    nodes[self].volume = volume_of(part, first);
  }

  template <class Divider, class Part>
  static auto divide(Divider& divider, const Part& part, int depth) {
    return depth < heuristic_depth ? divider.cheapest(part) : divider.median(part);  // V3
  }

  /// Of a part whose leaves are finished.
  template <class Part>
  Volume volume_of(const Part& part, std::uint32_t first) const {
    const std::span<const Vec3f> points = points_;
    return Volume::around(part.box(), points.subspan(first * points_per_item_, part.count() * points_per_item_));
  }

  template <class Part>
  void finish_leaf(const Part& part, std::uint32_t first) {
    for (std::uint32_t i = 0; i < part.count(); ++i) {
      const std::uint32_t id = part.id(i), position = first + i;
      order_[position] = id;
      if constexpr (Volume::needs_points) {
        const Hull hull = primitives_.hull(id);
        for (std::size_t k = 0; k < points_per_item_; ++k) {
          points_[position * points_per_item_ + k] = hull.points[std::min(static_cast<int>(k), hull.points.size() - 1)];
        }
      }
    }
  }

  const Primitives& primitives_;
  const Options options_;
  const ObjectSplitCosts costs_;
  /// Hulls in leaf order, the last point repeated to make them equally long: a subtree's points lie side by side.
  std::vector<Vec3f> points_;
  std::size_t points_per_item_ = 0;
  std::span<std::uint32_t> order_;
};

template <BoundingVolume Volume>
BoundingVolumeHierarchy<Volume> BoundingVolumeHierarchy<Volume>::refit(
    BoundingVolumeHierarchy tree, const Primitives& primitives) requires(!Volume::needs_points) {
  for (std::size_t i = tree.nodes_.size(); i-- > 0;) {  // children first: V2
    Node& node = tree.nodes_[i];
    Aabb box;
    if (node.is_leaf()) {
      box = bounds_of(primitives, tree.order_, node.range());
    } else {
      box = tree.nodes_[i + 1].volume.region();
      box.extend(tree.nodes_[i + node.link].volume.region());
    }
    node.volume = Volume::around(box, {});
    if (i == 0) tree.bounds_ = box;
  }
  return tree;
}

using BoxTree = BoundingVolumeHierarchy<BoundingBox>;
using SphereTree = BoundingVolumeHierarchy<BoundingSphere>;
using CylinderTree = BoundingVolumeHierarchy<BoundingCylinder>;

static_assert(BoxTree::node_bytes == 32 && SphereTree::node_bytes == 24 && CylinderTree::node_bytes == 40);
static_assert(Refittable<BoxTree>);
static_assert(Accelerator<BoxTree>);
static_assert(Accelerator<SphereTree>);
static_assert(Accelerator<CylinderTree>);

}  // namespace sightline
