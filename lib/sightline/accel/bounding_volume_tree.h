#pragma once
/// Bounding volume hierarchies over boxes, balls and cylinders: one structure, the volume a parameter.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <ranges>
#include <span>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/bounding_box.h"
#include "sightline/accel/bounding_cylinder.h"
#include "sightline/accel/bounding_sphere.h"
#include "sightline/accel/fixed_stack.h"
#include "sightline/accel/object_split.h"

namespace sightline {

/// Costs are relative to each other; a hierarchy of boxes opens a node at cost 1.
template <BoundingVolume Volume>
struct BoundingVolumeOptions {
  int max_leaf_size = 8;                     ///< More primitives than this are always divided.
  float traversal_cost = Volume::test_cost;  ///< Opening a node: testing the volumes of both children.
  float intersection_cost = 0.15f;           ///< One primitive test: those of a leaf are made together.
  int bins = 32;                             ///< On each axis, when many primitives are divided.

  static constexpr std::array<OptionField<BoundingVolumeOptions>, 4> fields() {
    using O = BoundingVolumeOptions;
    return {{{"max_leaf_size", &O::max_leaf_size, 1, 64, "most primitives in a leaf"},
             {"traversal_cost", &O::traversal_cost, 0, 1000, "cost of testing the volumes of two children"},
             {"intersection_cost", &O::intersection_cost, 0.001, 1000, "cost of testing one primitive"},
             {"bins", &O::bins, 2, max_split_bins, "intervals of each axis between which a large node is divided"}}};
  }
};

/// Each node bounds the primitives below it by one volume; every primitive is in exactly one leaf.
///   V1  A node's volume contains its primitives.
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

  std::size_t memory_bytes() const { return nodes_.size() * sizeof(Node) + order_.size() * sizeof(std::uint32_t); }
  std::span<const std::uint32_t> leaf_order() const { return order_; }
  bool is_order_final() const { return true; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const;

  template <class See>
  void for_each_cell(See&& see) const {
    if (!nodes_.empty()) see_subtree(0, 0, see);
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

  std::vector<Node> nodes_;
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
      far = visit(node.range());
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
        splitter_({options.traversal_cost, options.intersection_cost, options.max_leaf_size, options.bins}, {}),
        items_(primitives.size()) {}

  void build(BoundingVolumeHierarchy& tree) {
    const std::uint32_t count = primitives_.size();
    tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t id) { items_[id] = {primitives_.bounds(id), id}; });
    if constexpr (Volume::needs_points) {
      points_per_item_ = most_points();
      points_.resize(count * points_per_item_);
    }
    tree.bounds_ = bounds_of(items_);
    tree.order_.resize(count);
    order_ = tree.order_;
    grow(tree.nodes_, 0, count, 0);
    tree.nodes_.shrink_to_fit();
  }

 private:
  using Nodes = std::vector<Node>;
  struct Area {
    double operator()(const Aabb& box) const { return Volume::half_area_around(box); }
  };

  /// Subtrees smaller than this are not worth a task.
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

  /// Appends the subtree of items [first, first + count), whose leaves take the same positions of the leaf order.
  void grow(Nodes& nodes, std::uint32_t first, std::uint32_t count, int depth) {
    const std::span items = std::span(items_).subspan(first, count);
    const Aabb box = bounds_of(items);
    const std::size_t below = depth < heuristic_depth ? splitter_.cheapest(items, box) : splitter_.median(items);
    const std::size_t self = nodes.size();
    nodes.emplace_back();
    if (below == 0) {
      nodes[self].link = first;
      nodes[self].count = count;
      finish_leaf(items, first);
    } else {
      const auto middle = first + static_cast<std::uint32_t>(below);
      const auto grow_left = [&] { grow(nodes, first, middle - first, depth + 1); };
      const auto grow_right = [&](Nodes& into) { grow(into, middle, first + count - middle, depth + 1); };
      Nodes apart;
      if (count < task_size) {
        grow_left();
      } else {
        tbb::parallel_invoke(grow_left, [&] { grow_right(apart); });
      }
      nodes[self].link = static_cast<std::uint32_t>(nodes.size() - self);
      nodes[self].count = 0;
      if (count < task_size) {
        grow_right(nodes);
      } else {
        nodes.insert(nodes.end(), apart.begin(), apart.end());
      }
    }
    nodes[self].volume =
        Volume::around(box, std::span(points_).subspan(first * points_per_item_, count * points_per_item_));
  }

  void finish_leaf(std::span<const BoundsReference> items, std::uint32_t position) {
    for (const BoundsReference& item : items) {
      order_[position] = item.id;
      if constexpr (Volume::needs_points) {
        const Hull hull = primitives_.hull(item.id);
        for (std::size_t i = 0; i < points_per_item_; ++i) {
          points_[position * points_per_item_ + i] = hull.points[std::min(static_cast<int>(i), hull.points.size() - 1)];
        }
      }
      ++position;
    }
  }

  const Primitives& primitives_;
  ObjectSplitter<Area> splitter_;
  std::vector<BoundsReference> items_;
  /// Hulls in leaf order, the last point repeated to make them equally long: a subtree's points lie side by side.
  std::vector<Vec3f> points_;
  std::size_t points_per_item_ = 0;
  std::span<std::uint32_t> order_;
};

using BoxTree = BoundingVolumeHierarchy<BoundingBox>;
using SphereTree = BoundingVolumeHierarchy<BoundingSphere>;
using CylinderTree = BoundingVolumeHierarchy<BoundingCylinder>;

static_assert(BoxTree::node_bytes == 32 && SphereTree::node_bytes == 24 && CylinderTree::node_bytes == 40);
static_assert(Accelerator<BoxTree>);
static_assert(Accelerator<SphereTree>);
static_assert(Accelerator<CylinderTree>);

}  // namespace sightline
