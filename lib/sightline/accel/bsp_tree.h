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
///   B5  Leaves hold at most reference_limit times as many references as there are primitives.
/// B4's thickness: coordinates are relative to the scene's center, within r (half the diagonal). A general plane's
/// largest component is 1, so that rounding the others and the offset to float (u = 2^-24) moves heights by at most
/// 2 u r and 2 u r (the offset is at most sqrt(3) r), and polygons within 4 u r of a stored plane may lie on it.
/// Building computes in double against exactly the stored planes; clipping rounds some 2^-50 r a level, at most 2^-44 r
/// along a path. Hence building takes what is within 4 u r as lying on a plane, and thickness = 8 u r suffices. Fuchs,
/// Kedem and Naylor, "On visible surface generation by a priori tree structures", 1980; Ize, Wald and Parker, "Ray
/// tracing with the BSP tree", 2008; Kammaje and Mora, "A study of restricted BSP trees for ray tracing", 2007; Budge,
/// Coming, Norpchen and Joy, "Accelerated building and ray tracing of restricted BSP trees", 2008.

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "sightline/accel/accelerator.h"
#include "sightline/accel/bsp_tree_builder.h"
#include "sightline/accel/bsp_tree_nodes.h"
#include "sightline/accel/fixed_stack.h"
#include "sightline/accel/padded_ray.h"
#include "sightline/math/convex_cell.h"

namespace sightline {

struct BspTreeOptions {
  /// fast: axis planes only, in 16 bins. balanced: 32 bins high up; below, the planes of eight primitives a node, too.
  /// best: all planes of all primitives from some hundred downward, and surface areas of every candidate.
  Quality quality = Quality::balanced;
  int max_leaf_size = 8;            ///< A node this small is never split.
  float traversal_cost = 1.75f;     ///< One test of a general plane, relative to ...
  float intersection_cost = 0.25f;  ///< ... one primitive test and ...
  float leaf_cost = 6;              ///< ... what a leaf costs however many it holds.
  bool general_planes = true;       ///< Off: axis planes only, which makes it a kd-tree.
  int reference_limit = 24;         ///< Leaves hold at most so many times as many references as there are primitives.
  int max_depth = 0;                ///< 0: 12 + 1.6 log2 of the primitives' number, at most 64.

  static constexpr std::array<OptionField<BspTreeOptions>, 8> fields() {
    using O = BspTreeOptions;
    return {{{"quality", &O::quality, 0, 2, "fast: axis planes; best: every plane and area"},
             {"max_leaf_size", &O::max_leaf_size, 1, 1 << 20, "a node this small is never split"},
             {"traversal_cost", &O::traversal_cost, 0, 1000, "cost of testing a general plane"},
             {"intersection_cost", &O::intersection_cost, 0.001, 1000, "cost of testing a primitive"},
             {"leaf_cost", &O::leaf_cost, 0, 1000, "cost of a leaf, however many it holds"},
             {"general_planes", &O::general_planes, 0, 1, "false: axis planes only, for comparison"},
             {"reference_limit", &O::reference_limit, 1, 64, "most references for each primitive"},
             {"max_depth", &O::max_depth, 0, 64, "longest path; 0: from the number of primitives"}}};
  }
};

class BspTree {
 public:
  static constexpr std::string_view name = "bsp-tree";
  static constexpr std::string_view description =
      "planes of any orientation by a surface-area cost over convex cells (Ize, Wald and Parker 2008)";
  static constexpr std::size_t node_bytes = sizeof(BspNodes::Word);
  using Options = BspTreeOptions;

  /// \throws std::invalid_argument for options out of their limits, std::length_error beyond 2^26 primitives or 2^29
  /// nodes.
  static BspTree build(const Primitives& primitives, const Options& options = {});

  std::size_t memory_bytes() const { return nodes_.memory_bytes(); }
  std::span<const std::uint32_t> leaf_order() const { return nodes_.order(); }
  bool is_order_final() const { return true; }

  template <class T, LeafVisitor<T> Visit, class Probe>
  void traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const;

  /// Cells are cut by the planes moved outward by the thickness, so that they contain what their nodes hold.
  template <class See>
  void for_each_cell(See&& see) const;
  template <class See>
  void for_each_leaf(See&& see) const {
    nodes_.for_each_leaf(see);
  }

 private:
  static constexpr int stack_size = 64;
  static constexpr std::uint32_t size_limit = 1u << 26;  ///< Keeps positions, by B5, within 32 bits.

  static constexpr double axis_cost_share = 0.4;  ///< Of a general plane's test.

  template <class T>
  struct PlaneRay;

  BspNodes nodes_;
  Aabb bounds_;
  Vec3d center_{0};
  double thickness_ = 0;
};

// ---- Traversal

/// What a plane test needs of a ray.
///   R1  A point within `pad` of the ray, per axis, has a height of at most the normal's 1-norm times pad over the
///       ray's; that norm is 1 of an axis plane and at most 3 of a general one. With B4, the ray is below a plane while
///       its height is at most `width`, and above while it is at least -width.
///   R2  With u the unit roundoff of T and N the 1-norm, in units of N u reach and within the bounds: the origin is off
///       by 1, the height by 5 more, the slope moves a point by 3, adding the width by 2, inverting and multiplying by
///       4. These 15 are less than the 32 and more that M1 leaves.
///   R3  Where the direction or the bounds are so large or small that numbers might overflow or underflow, no general
///       plane parts anything.
template <class T>
struct BspTree::PlaneRay {
  T origin[5], direction[5];  ///< Relative to the center; repeated, so that every axis has two after it.
  T enter[3], leave[3], inverse[3];
  T width;  ///< Of general planes.
  std::uint32_t falls[3];

  PlaneRay(const PaddedRay<T>& padded, const Vec3d& center, double thickness) {
    const auto thick = static_cast<T>(thickness);
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis] = static_cast<T>(static_cast<double>(padded.origin[axis]) - center[axis]);
      direction[axis] = padded.direction[axis];
      const T in = padded.enter_origin[axis], out = padded.leave_origin[axis];
      enter[axis] = in + std::copysign(thick + std::numeric_limits<T>::epsilon() * std::fabs(in), direction[axis]);
      leave[axis] = out - std::copysign(thick + std::numeric_limits<T>::epsilon() * std::fabs(out), direction[axis]);
      inverse[axis] = padded.inverse[axis];
      falls[axis] = padded.is_negative[axis];
    }
    for (int axis = 0; axis < 2; ++axis) origin[axis + 3] = origin[axis], direction[axis + 3] = direction[axis];
    const auto is_ordinary = [](T x) { return x > T(0x1p-60) && x < T(0x1p60); };
    const bool is_safe = is_ordinary(max_norm(padded.direction)) && is_ordinary(padded.pad);
    width = is_safe ? static_cast<T>(thickness) + 3 * padded.pad : std::numeric_limits<T>::infinity();
  }
};

/// Seen as if the ray rises, it leaves the near side where its height is `width`, and enters the far side at -width. A
/// NaN, of a ray parallel to the plane at just that height, keeps both sides.
template <class T, LeafVisitor<T> Visit, class Probe>
void BspTree::traverse(const Ray<T>& ray, Visit&& visit, Probe& probe) const {
  if (nodes_.size() == 0) return;
  const PaddedRay<T> padded(ray, bounds_);
  const Interval<T> inside = padded.clip(bounds_, padded.t_max);
  if (inside.is_empty()) return;

  const PlaneRay<T> planes(padded, center_, thickness_);
  struct Waiting {
    std::uint32_t node;
    T enter, leave;
  };
  FixedStack<Waiting, stack_size> waiting;  // B3
  std::uint32_t at = 0;
  T enter = inside.lo, leave = inside.hi, far = padded.t_max;
  for (;;) {
    BspNodes::Word word = nodes_[at];
    while (word.kind() != BspNodes::leaf) {
      probe.node(at, enter);
      const std::uint32_t kind = word.kind();
      T near_leave, far_enter;
      std::uint32_t below = at + 1, falls;
      if (kind < BspNodes::general_plane) {
        near_leave = (word.offset() - planes.leave[kind]) * planes.inverse[kind];
        far_enter = (word.offset() - planes.enter[kind]) * planes.inverse[kind];
        falls = planes.falls[kind];
      } else {
        const std::uint32_t axis = kind - BspNodes::general_plane;
        const BspNodes::Word rest = nodes_[at + 1];
        const T* const o = planes.origin + axis;
        const T* const d = planes.direction + axis;
        const T depth = word.offset() - (o[0] + rest.first() * o[1] + rest.second() * o[2]);
        const T slope = d[0] + rest.first() * d[1] + rest.second() * d[2];
        const T inverse = 1 / slope;
        falls = std::signbit(slope);
        const T width = falls ? -planes.width : planes.width;
        near_leave = (depth + width) * inverse;
        far_enter = (depth - width) * inverse;
        ++below;
      }
      const std::uint32_t above = at + word.distance();  // B2
      const std::uint32_t near_side = falls ? above : below, far_side = falls ? below : above;
      if (near_leave < enter) {
        at = far_side;  // entered already
      } else if (far_enter > leave) {
        at = near_side;
      } else {
        waiting.push({far_side, far_enter > enter ? far_enter : enter, leave});
        at = near_side;
        leave = near_leave < leave ? near_leave : leave;
      }
      word = nodes_[at];
    }
    const LeafRange range = word.range();
    if (range.count == 0) {
      probe.node(at, enter);
    } else {
      probe.leaf(at, range, enter);
      far = visit(range);
      if (far < ray.t_min) return;
    }
    for (;;) {
      if (waiting.empty()) return;
      const Waiting next = waiting.pop();
      at = next.node, enter = next.enter, leave = next.leave < far ? next.leave : far;
      if (!(enter > far)) break;
      probe.cull(at, enter);
    }
  }
}

template <class See>
void BspTree::for_each_cell(See&& see) const {
  if (nodes_.size() == 0) return;
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
    const BspNodes::Word word = nodes_[at.node];
    const bool is_leaf = word.kind() == BspNodes::leaf;
    see(Cell{at.cell.polyhedron(center_), at.depth, is_leaf, is_leaf ? word.range() : LeafRange{}, at.node});
    if (is_leaf) continue;
    const Plane plane = nodes_.split(at.node).plane(center_);
    Pending above{at.node + word.distance(), at.depth + 1, {}};
    Pending below{at.node + BspNodes::words_of(word.kind()), at.depth + 1, {}};
    at.cell.keep_below({-plane.normal, -(plane.offset - thickness_)}, tolerance, above.cell);
    at.cell.keep_below({plane.normal, plane.offset + thickness_}, tolerance, below.cell);
    pending.push_back(std::move(above));
    pending.push_back(std::move(below));
  }
}

// ---- Construction

inline BspTree BspTree::build(const Primitives& primitives, const Options& options) {
  validate(name, options);
  BspTree tree;
  const std::uint32_t count = primitives.size();
  if (count > size_limit) {
    throw std::length_error("bsp-tree: " + std::to_string(count) + " primitives; expected at most " +
                            std::to_string(size_limit));
  }
  if (count == 0) return tree;
  BspBoxes boxes;
  boxes.references.resize(count);
  tbb::parallel_for(0u, count, [&](std::uint32_t id) { boxes.references[id] = {primitives.bounds(id), id}; });
  for (const BspBoxes::Reference& reference : boxes.references) tree.bounds_.extend(reference.box);
  const Vec3d lo(tree.bounds_.lo), hi(tree.bounds_.hi);
  tree.center_ = 0.5 * lo + 0.5 * hi;
  const double radius = 0.5 * glm::length(hi - lo);
  tree.thickness_ = 0x1p-21 * radius + 4 * double(std::numeric_limits<float>::denorm_min());
  const int automatic_depth = std::min(stack_size, static_cast<int>(12 + 1.6 * std::log2(double(count))));
  const BspCosts costs{axis_cost_share * options.traversal_cost, options.traversal_cost, options.intersection_cost,
                       options.leaf_cost};
  const BspPlan plan{primitives,
                     tree.center_,
                     tree.thickness_,
                     static_cast<std::uint32_t>(options.max_leaf_size),
                     options.max_depth > 0 ? options.max_depth : automatic_depth,
                     options.general_planes && options.quality != Quality::fast,
                     costs,
                     BspEffort::of(options.quality)};
  BspBuilder builder(plan);
  builder.build(tree.bounds_, boxes, double(options.reference_limit) * count, 0);
  tree.nodes_ = builder.take_nodes();
  return tree;
}

static_assert(Accelerator<BspTree>);

}  // namespace sightline
