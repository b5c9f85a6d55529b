#pragma once
/// Binary space partitioning by planes of any orientation.
///
/// Every inner node halves its convex cell by a plane: an axis plane at a primitive's clipped bounds, a polygon's own
/// plane, or a plane through one of its edges. The surface area heuristic chooses, over the convex cells themselves.
///   B1  Two children tile their parent's cell.
///   B2  The child below follows its parent; the child above is linked, relative to its parent.
///   B3  No path exceeds max_depth <= 64, so the traversal stack cannot overflow: a path leaves one entry a node.
///   B4  What a cell holds below a plane has heights of at most `thickness` over it, above at least -thickness.
///       A polygon lying on the plane, as that which gave it does, goes to one side and is never cut.
///   B5  Leaves hold at most reference_growth times as many references as there are primitives.
/// B4's thickness: coordinates are relative to the scene's center, within r (half the diagonal). A unit normal and an
/// offset rounded to float (u = 2^-24) move a point of the plane by at most u r each (Cauchy-Schwarz), 2 u r in all, so
/// that polygons within 2 u r of a stored plane may lie on it. Building computes in double against exactly the stored
/// planes; clipping rounds some 2^-50 r a level, at most 2^-44 r along a path. Hence thickness = 4 u r suffices.
/// Fuchs, Kedem and Naylor, "On visible surface generation by a priori tree structures", 1980; Ize, Wald and Parker,
/// "Ray tracing with the BSP tree", 2008; Kammaje and Mora, "A study of restricted BSP trees for ray tracing", 2007.

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/fixed_stack.h"
#include "sightline/accel/fragments.h"
#include "sightline/accel/padded_ray.h"
#include "sightline/accel/split_search.h"
#include "sightline/math/convex_cell.h"

namespace sightline {

struct BspTreeOptions {
  int max_leaf_size = 3;        ///< A node this small is never split.
  float traversal_cost = 0.8f;  ///< One test of a general plane, relative to ...
  float intersection_cost = 1;  ///< ... one primitive test.
  bool general_planes = true;   ///< Off: axis planes only, which makes it a kd-tree.
  int max_depth = 0;            ///< 0: 12 + 1.6 log2 of the primitives' number, at most 64.

  static constexpr std::array<OptionField<BspTreeOptions>, 5> fields() {
    using O = BspTreeOptions;
    return {{{"max_leaf_size", &O::max_leaf_size, 1, 1 << 20, "a node this small is never split"},
             {"traversal_cost", &O::traversal_cost, 0, 1000, "cost of testing a general plane"},
             {"intersection_cost", &O::intersection_cost, 0.001, 1000, "cost of testing a primitive"},
             {"general_planes", &O::general_planes, 0, 1, "false: axis planes only, for comparison"},
             {"max_depth", &O::max_depth, 0, 64, "longest path; 0: from the number of primitives"}}};
  }
};

class BspTree {
  struct Node;

 public:
  static constexpr std::string_view name = "bsp-tree";
  static constexpr std::string_view description =
      "planes of any orientation by a surface-area cost over convex cells (Ize, Wald and Parker 2008)";
  static constexpr std::size_t node_bytes = 20;
  using Options = BspTreeOptions;

  /// \throws std::invalid_argument for options out of their limits, std::length_error beyond 2^28 primitives or 2^29
  /// nodes.
  static BspTree build(const Primitives& primitives, const Options& options = {});

  std::size_t memory_bytes() const { return nodes_.size() * sizeof(Node) + order_.size() * sizeof(std::uint32_t); }
  std::span<const std::uint32_t> leaf_order() const { return order_; }
  bool is_order_final() const { return true; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const;

  /// Cells are cut by the planes moved outward by the thickness, so that they contain what their nodes hold.
  template <class See>
  void for_each_cell(See&& see) const;
  template <class See>
  void for_each_leaf(See&& see) const {
    for (const Node& node : nodes_) {
      if (node.kind() == leaf) see(node.range());
    }
  }

 private:
  static constexpr int stack_size = 64;
  static constexpr std::uint32_t reference_growth = 12;      // B5
  static constexpr std::uint32_t size_limit = 1u << 28;      ///< Keeps positions, by B5, within 32 bits.
  static constexpr std::size_t node_limit = (1u << 29) - 1;  ///< Links have 29 bits for distances and counts.
  static_assert(std::uint64_t(size_limit) * reference_growth < 1ull << 32 && size_limit <= node_limit);

  /// Axis planes know their axis, which saves traversal the dot products.
  enum Kind : std::uint32_t { x_plane, y_plane, z_plane, general_plane, leaf };
  struct Node {
    Vec3f normal{0};         ///< Below is normal . (x - center) <= offset.
    std::uint32_t bits = 0;  ///< The offset; of a leaf the first position.
    std::uint32_t link = 0;  ///< Kind, and eight times the distance to the child above, or the leaf's count.

    Kind kind() const { return static_cast<Kind>(link & 7); }
    float offset() const { return std::bit_cast<float>(bits); }
    std::uint32_t to_above() const { return link >> 3; }
    LeafRange range() const { return {bits, link >> 3}; }
    Plane plane() const { return {Vec3d(normal), offset()}; }

    static Node inner(const SplitPlane& split) {
      return {split.normal, std::bit_cast<std::uint32_t>(split.offset), static_cast<std::uint32_t>(split.axis)};
    }
  };
  static_assert(sizeof(Node) == node_bytes);

  class Builder;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  Aabb bounds_;
  Vec3d center_{0};
  double thickness_ = 0;
};

// ---- Traversal

/// The ray is in the lower half-space while its height is at most w = thickness + pad times the normal's 1-norm: then
/// and only then can a point within `pad` of the ray, per axis, have a height of at most `thickness` (M2 and B4). A
/// unit vector's 1-norm is at most the square root of 3. Heights are rounded some ten times in double, a 2^-49 of the
/// reach, against the half of the margin, at least 2^-35 of it, that M1 leaves for that.
template <class T, LeafVisitor<T> Visit, class Probe>
void BspTree::traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
  if (nodes_.empty()) return;
  const PaddedRay<T> padded(ray, bounds_);
  const Interval<T> inside = padded.clip(bounds_, padded.t_max);
  if (inside.lo > inside.hi) return;

  const Vec3d origin = Vec3d(ray.origin) - center_, direction(ray.direction);
  const double w = thickness_ + 1.7321 * static_cast<double>(padded.pad);
  struct Visited {
    std::uint32_t node;
    double enter, leave;
  };
  FixedStack<Visited, stack_size> waiting;
  Visited at{0, inside.lo, inside.hi};
  T far = padded.t_max;
  for (;;) {
    while (nodes_[at.node].kind() != leaf) {
      const Node& node = nodes_[at.node];
      probe.node(at.node, at.enter);
      const Kind kind = node.kind();
      double height, slope;
      if (kind == general_plane) {
        const Vec3d normal(node.normal);
        height = glm::dot(normal, origin) - node.offset();
        slope = glm::dot(normal, direction);
      } else {
        height = origin[kind] - node.offset();
        slope = direction[kind];
      }
      // Seen as if the ray rises: it leaves the near side where its height is w, and enters the far side at -w. A NaN,
      // of a ray parallel to the plane at just that height, keeps both sides.
      const bool is_falling = std::signbit(slope);
      const double start = is_falling ? -height : height, rise = std::fabs(slope);
      const double near_leave = (w - start) / rise, far_enter = (-w - start) / rise;
      const std::uint32_t below = at.node + 1, above = at.node + node.to_above();
      const std::uint32_t near_side = is_falling ? above : below, far_side = is_falling ? below : above;
      if (near_leave < at.enter) {
        at.node = far_side;  // entered already
      } else if (far_enter > at.leave) {
        at.node = near_side;
      } else {
        waiting.push({far_side, far_enter > at.enter ? far_enter : at.enter, at.leave});
        at = {near_side, at.enter, near_leave < at.leave ? near_leave : at.leave};
      }
    }
    const LeafRange range = nodes_[at.node].range();
    if (range.count == 0) {
      probe.node(at.node, at.enter);
    } else {
      probe.leaf(at.node, range, at.enter);
      far = visit(range);
      if (far < ray.t_min) return;
    }
    for (;;) {
      if (waiting.empty()) return;
      at = waiting.pop();
      if (!(at.enter > static_cast<double>(far))) break;
      probe.cull(at.node, at.enter);
    }
    at.leave = at.leave > static_cast<double>(far) ? static_cast<double>(far) : at.leave;
  }
}

template <class See>
void BspTree::for_each_cell(See&& see) const {
  if (nodes_.empty()) return;
  struct Pending {
    std::uint32_t node;
    int depth;
    ConvexCell cell;
  };
  const double tolerance = thickness_ * 0x1p-20;
  std::vector<Pending> pending;
  pending.push_back({0, 0, ConvexCell::box(Vec3d(bounds_.lo) - center_, Vec3d(bounds_.hi) - center_)});
  while (!pending.empty()) {
    const Pending at = std::move(pending.back());
    pending.pop_back();
    const Node& node = nodes_[at.node];
    const bool is_leaf = node.kind() == leaf;
    see(Cell{at.cell.polyhedron(center_), at.depth, is_leaf, is_leaf ? node.range() : LeafRange{}, at.node});
    if (is_leaf) continue;
    const Vec3d normal(node.normal);
    Pending above{at.node + node.to_above(), at.depth + 1, {}}, below{at.node + 1, at.depth + 1, {}};
    at.cell.keep_below({-normal, -(node.offset() - thickness_)}, tolerance, above.cell);
    at.cell.keep_below({normal, node.offset() + thickness_}, tolerance, below.cell);
    pending.push_back(std::move(above));
    pending.push_back(std::move(below));
  }
}

// ---- Construction

/// Builds one subtree, depth first.
class BspTree::Builder {
 public:
  struct Scene {
    const Primitives& primitives;
    Options options;
    Vec3d center;
    double thickness;
    int max_depth;
  };
  explicit Builder(const Scene& scene)
      : scene_(scene),
        search_(scene.primitives, scene.center, scene.thickness / 2, costs_of(scene.options),
                scene.options.general_planes) {}

  /// `budget` is how many references the subtree's leaves may hold (B5), at least as many as there are fragments.
  void build(const ConvexCell& cell, const Fragments& fragments, double budget, int depth) {
    const auto& [primitives, options, center, thickness, max_depth] = scene_;
    const auto is_never_split = [&](const Fragments& of, int at_depth) {
      return of.size() <= static_cast<std::uint32_t>(options.max_leaf_size) || at_depth >= max_depth;
    };
    if (is_never_split(fragments, depth)) return add_leaf(fragments);
    const std::optional<SplitSearch::Choice> choice = search_.best(cell, fragments);
    if (!choice) return add_leaf(fragments);
    if (static_cast<int>(levels_.size()) <= depth) levels_.resize(depth + 1);
    if (!levels_[depth]) levels_[depth] = std::make_unique<Level>();
    Level& level = *levels_[depth];
    const Plane plane = choice->split.plane();
    fragments.split(plane, thickness / 2, choice->keeps_on_below, primitives, center, level.below, level.above);
    const double share = budget / (double(level.below.size()) + double(level.above.size()));
    if (share < 1 || std::min(level.below.size(), level.above.size()) == fragments.size()) return add_leaf(fragments);
    const double tolerance = thickness * 0x1p-20;
    if (!is_never_split(level.below, depth + 1)) cell.keep_below(plane, tolerance, level.cell_below);
    if (!is_never_split(level.above, depth + 1)) {
      cell.keep_below({-plane.normal, -plane.offset}, tolerance, level.cell_above);
    }
    const std::size_t inner = nodes_.size();
    add_node(Node::inner(choice->split));
    const auto build_below = [&](Builder& builder) {
      builder.build(level.cell_below, level.below, share * level.below.size(), depth + 1);
    };
    const auto build_above = [&](Builder& builder) {
      builder.build(level.cell_above, level.above, share * level.above.size(), depth + 1);
    };
    const auto link_above = [&] { nodes_[inner].link |= static_cast<std::uint32_t>(nodes_.size() - inner) << 3; };
    if (fragments.size() < parallel_size) {
      build_below(*this);
      link_above();
      build_above(*this);
    } else {
      Builder lower(scene_), upper(scene_);
      tbb::parallel_invoke([&] { build_below(lower); }, [&] { build_above(upper); });
      append(lower);
      link_above();
      append(upper);
    }
  }

  void finish(BspTree& tree) {
    tree.nodes_ = std::move(nodes_);
    tree.order_ = std::move(order_);
    tree.nodes_.shrink_to_fit();
    tree.order_.shrink_to_fit();
  }

 private:
  static constexpr std::uint32_t parallel_size = 4096;  ///< Subtrees this large are built side by side.

  struct Level {
    Fragments below, above;
    ConvexCell cell_below, cell_above;
  };

  void add_node(const Node& node) {
    if (nodes_.size() == node_limit) throw std::length_error("bsp-tree: more nodes than a link can span");
    nodes_.push_back(node);
  }

  void add_leaf(const Fragments& fragments) {
    add_node({Vec3f(0), static_cast<std::uint32_t>(order_.size()), fragments.size() << 3 | leaf});
    for (std::uint32_t i = 0; i < fragments.size(); ++i) order_.push_back(fragments[i].id);
  }

  void append(const Builder& subtree) {
    const auto shift = static_cast<std::uint32_t>(order_.size());
    for (Node node : subtree.nodes_) {
      if (node.kind() == leaf) node.bits += shift;
      add_node(node);
    }
    order_.insert(order_.end(), subtree.order_.begin(), subtree.order_.end());
  }

  static constexpr double axis_cost_share = 0.7;  ///< Of a general plane's test.
  static SplitSearch::Costs costs_of(const Options& options) {
    return {axis_cost_share * options.traversal_cost, options.traversal_cost, options.intersection_cost};
  }

  const Scene& scene_;
  SplitSearch search_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::vector<std::unique_ptr<Level>> levels_;  ///< By depth, reused from node to node.
};

inline BspTree BspTree::build(const Primitives& primitives, const Options& options) {
  validate(name, options);
  BspTree tree;
  const std::uint32_t count = primitives.size();
  if (count > size_limit) {
    throw std::length_error("bsp-tree: " + std::to_string(count) + " primitives; expected at most " +
                            std::to_string(size_limit));
  }
  if (count == 0) return tree;
  for (std::uint32_t id = 0; id < count; ++id) tree.bounds_.extend(primitives.bounds(id));
  const Vec3d lo(tree.bounds_.lo), hi(tree.bounds_.hi);
  tree.center_ = 0.5 * lo + 0.5 * hi;
  const double radius = 0.5 * glm::length(hi - lo);
  tree.thickness_ = 0x1p-22 * radius + 4 * double(std::numeric_limits<float>::denorm_min());
  const int automatic_depth = std::min(stack_size, static_cast<int>(12 + 1.6 * std::log2(double(count))));
  const Builder::Scene scene{primitives, options, tree.center_, tree.thickness_,
                             options.max_depth > 0 ? options.max_depth : automatic_depth};
  // A cell as thick as its planes at least, so that flat scenes have areas to weigh.
  const Vec3d half = 0.5 * (hi - lo) + tree.thickness_;
  Builder builder(scene);
  builder.build(ConvexCell::box(-half, half), Fragments::of(primitives, tree.center_), double(reference_growth) * count,
                0);
  builder.finish(tree);
  return tree;
}

static_assert(Accelerator<BspTree>);

}  // namespace sightline
