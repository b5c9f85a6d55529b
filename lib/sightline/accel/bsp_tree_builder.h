#pragma once
/// How BSP trees are built.

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "sightline/accel/bsp_tree_boxes.h"
#include "sightline/accel/bsp_tree_nodes.h"
#include "sightline/accel/bsp_tree_search.h"
#include "sightline/accel/fragments.h"
#include "sightline/math/convex_cell.h"

namespace sightline {

/// What all parts of a tree are built with.
struct BspPlan {
  const Primitives& primitives;
  Vec3d center;
  double thickness;  ///< B4; half of it serves building.
  std::uint32_t max_leaf_size;
  int max_depth;
  bool general_planes;
  BspCosts costs;
  BspEffort effort;
};

/// Builds one subtree, depth first. High up, where a cell holds many primitives, only axis planes are tried, in bins
/// over the primitives' clipped bounds, unless a sample says that general planes pay there already. Below, the
/// primitives become polygons in a convex cell, and planes of any orientation are tried. Trees are the same however
/// many threads build: what is built apart is decided by size alone.
class BspBuilder {
 public:
  explicit BspBuilder(const BspPlan& plan)
      : plan_(plan), search_(plan.primitives, plan.center, plan.thickness / 2, plan.costs, plan.effort) {}

  /// `budget` is how many references the subtree's leaves may hold (B5), at least as many as there are references.
  void build(const Aabb& cell, const BspBoxes& boxes, double budget, int depth) {
    const std::uint32_t count = boxes.size();
    const auto id_of = [&](std::uint32_t i) { return boxes.references[i].id; };
    if (is_never_split(count, depth)) return nodes_.add_leaf(count, id_of);
    if (plan_.general_planes && (count <= plan_.effort.general_size || general_planes_pay(cell, boxes))) {
      return build_from_fragments(cell, boxes, budget, depth);
    }
    const double limit = plan_.costs.tests(count);
    auto choice = boxes.best(cell, plan_.effort.bins, plan_.thickness, limit, plan_.costs);
    if (!choice && plan_.general_planes) return build_from_fragments(cell, boxes, budget, depth);
    const bool is_halved = !choice && count > crowd_size;
    if (is_halved) choice = halving(cell);
    if (!choice) return nodes_.add_leaf(count, id_of);
    std::array<Aabb, 2> cells{cell, cell};  // B1
    cells[0].hi[choice->split.axis] = cells[1].lo[choice->split.axis] = choice->split.offset;
    std::array<BspBoxes, 2> own;
    const bool is_parallel = count >= parallel_size;
    std::array<BspBoxes, 2>& sides = is_parallel ? own : level_at(depth).boxes;
    boxes.split(choice->split, plan_.thickness / 2, plan_.primitives, sides);
    const double parts = double(sides[0].size()) + double(sides[1].size()), share = budget / parts;
    if (share < 1 || std::min(sides[0].size(), sides[1].size()) == count || (is_halved && parts > most_parts * count)) {
      return nodes_.add_leaf(count, id_of);
    }
    const std::size_t inner = nodes_.add_plane(choice->split);
    build_both(inner, is_parallel, [&](BspBuilder& builder, int side) {
      builder.build(cells[side], sides[side], share * sides[side].size(), depth + 1);
    });
  }

  BspNodes take_nodes() {
    nodes_.shrink_to_fit();
    return std::move(nodes_);
  }

 private:
  static constexpr std::uint32_t parallel_size = 4096;  ///< Subtrees this large are built side by side.
  static constexpr std::uint32_t least_sampled = 1024;  ///< Cells that hold fewer are not asked whether to change over.
  static constexpr std::uint32_t sample_size = 192;
  static constexpr double least_gain = 0.1;        ///< Share of the cost that general planes must save on the sample.
  static constexpr std::uint32_t crowd_size = 64;  ///< Cells that hold more are halved where axis planes alone fail.
  static constexpr double most_parts = 1.8;        ///< Of a primitive in such halves, on average.

  /// Scratch of a node on the path, reused by its siblings.
  struct Level {
    std::array<BspBoxes, 2> boxes;
    std::array<Fragments, 2> fragments;
    std::array<ConvexCell, 2> cells;
  };
  Level& level_at(int depth) {
    if (static_cast<int>(levels_.size()) <= depth) levels_.resize(depth + 1);
    if (!levels_[depth]) levels_[depth] = std::make_unique<Level>();
    return *levels_[depth];
  }

  bool is_never_split(std::uint32_t count, int depth) const {
    return count <= plan_.max_leaf_size || depth >= plan_.max_depth;
  }

  template <class BuildSide>
  void build_both(std::size_t inner, bool is_parallel, BuildSide&& build_side) {
    if (!is_parallel) {
      build_side(*this, 0);
      nodes_.link_above(inner);
      return build_side(*this, 1);
    }
    BspBuilder lower(plan_), upper(plan_);
    tbb::parallel_invoke([&] { build_side(lower, 0); }, [&] { build_side(upper, 1); });
    nodes_.append(lower.nodes_);
    nodes_.link_above(inner);
    nodes_.append(upper.nodes_);
  }

  /// Across the widest axis. Long primitives that lie askew are worth dividing by axis planes only when this has been
  /// done across all three.
  static std::optional<BspBoxes::Choice> halving(const Aabb& cell) {
    const int axis = cell.longest_axis();
    const float lo = cell.lo[axis], hi = cell.hi[axis], middle = lo + 0.5f * (hi - lo);
    if (!(lo < middle && middle < hi)) return std::nullopt;
    return BspBoxes::Choice{SplitPlane::across(axis, middle), 0};
  }

  /// Every step-th primitive as fragment, and the cell around them as thick as planes are at least, so that flat cells
  /// have areas to weigh.
  ConvexCell fragments_of(const Aabb& cell, const BspBoxes& boxes, std::uint32_t step, Fragments& fragments) const {
    fragments.clear();
    for (std::uint32_t i = 0; i < boxes.size(); i += step) {
      const auto& [box, id] = boxes.references[i];
      fragments.add_within(id, box, cell, plan_.thickness / 2, plan_.primitives, plan_.center);
    }
    const double border = plan_.thickness / 2;
    return ConvexCell::box(Vec3d(cell.lo) - plan_.center - border, Vec3d(cell.hi) - plan_.center + border);
  }

  bool general_planes_pay(const Aabb& cell, const BspBoxes& boxes) {
    if (boxes.size() < least_sampled) return false;
    Fragments sample;
    const ConvexCell convex = fragments_of(cell, boxes, boxes.size() / sample_size, sample);
    if (sample.size() == 0) return false;
    const double limit = plan_.costs.tests(boxes.size()), weight = double(boxes.size()) / sample.size();
    const auto axis = search_.best(convex, sample, limit, false, weight);
    return search_.best(convex, sample, (1 - least_gain) * (axis ? axis->cost : limit), true, weight).has_value();
  }

  void build_from_fragments(const Aabb& cell, const BspBoxes& boxes, double budget, int depth) {
    Fragments fragments;
    const ConvexCell convex = fragments_of(cell, boxes, 1, fragments);
    build(convex, fragments, budget, depth);
  }

  void build(const ConvexCell& cell, const Fragments& fragments, double budget, int depth) {
    const std::uint32_t count = fragments.size();
    const auto id_of = [&](std::uint32_t i) { return fragments[i].id; };
    if (is_never_split(count, depth)) return nodes_.add_leaf(count, id_of);
    const auto choice = search_.best(cell, fragments, plan_.costs.tests(count), plan_.general_planes);
    if (!choice) return nodes_.add_leaf(count, id_of);
    Level& level = level_at(depth);
    const Plane plane = choice->split.plane(plan_.center);
    auto& [below, above] = level.fragments;
    fragments.split(plane, plan_.thickness / 2, choice->keeps_on_below, plan_.primitives, plan_.center, below, above);
    const double share = budget / (double(below.size()) + double(above.size()));
    if (share < 1 || std::min(below.size(), above.size()) == count) return nodes_.add_leaf(count, id_of);
    const double tolerance = plan_.thickness * 0x1p-20;
    if (!is_never_split(below.size(), depth + 1)) cell.keep_below(plane, tolerance, level.cells[0]);
    if (!is_never_split(above.size(), depth + 1)) {
      cell.keep_below({-plane.normal, -plane.offset}, tolerance, level.cells[1]);
    }
    const std::size_t inner = nodes_.add_plane(choice->split);
    build_both(inner, count >= parallel_size, [&](BspBuilder& builder, int side) {
      builder.build(level.cells[side], level.fragments[side], share * level.fragments[side].size(), depth + 1);
    });
  }

  const BspPlan& plan_;
  SplitSearch search_;
  BspNodes nodes_;
  std::vector<std::unique_ptr<Level>> levels_;  ///< By depth.
};

}  // namespace sightline
