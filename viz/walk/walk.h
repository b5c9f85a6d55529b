#pragma once
/// A ray's way through a structure, step by step: what a person has to see to understand it.

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "sightline/query/tracer.h"

namespace sightline::viz {

struct WalkStep {
  enum class Kind : std::uint8_t {
    visit,      ///< An inner node is opened, or a cell that has nothing for the ray.
    leaf,       ///< A leaf is opened; its candidates follow.
    candidate,  ///< A triangle of that leaf is tested.
    cull        ///< Put aside before, now dropped unopened: it begins beyond the far limit.
  };
  Kind kind = Kind::visit;
  std::uint32_t node = 0;      ///< Of the cell; of the leaf, for candidates.
  std::uint32_t triangle = 0;  ///< Of a candidate.
  bool is_crossed = false;  ///< The candidate is crossed within the ray's range, though perhaps beyond the hit so far.
  bool is_hit = false;      ///< The candidate becomes the nearest hit so far.
  double t = 0;             ///< Where the ray enters the cell, or crosses the candidate.
  double far = 0;           ///< The far limit after this step: beyond it nothing matters any more.
};

/// A cell that the walk touches, or one beside those, and its place in the hierarchy.
struct WalkCell {
  Cell cell;
  std::optional<std::size_t> parent;  ///< Index into Walk::cells; the root has none.
  std::optional<std::size_t> opened;  ///< The step at which it was opened or culled; never, where the ray passed it by.
};

class Walk {
 public:
  Ray<float> ray;
  Hit<float> hit;
  std::vector<WalkStep> steps;
  /// In the order of for_each_cell, parents first: all that steps name, what contains them, and the other children of
  /// nodes that were visited. Of a grid only what steps name, and what contains it.
  std::vector<WalkCell> cells;
  std::size_t all_cells = 0;  ///< Of the structure.

  /// The same as the traversal's own statistics.
  TraversalStats statistics() const;
  /// Index into cells; the root's for an empty cell of a grid, which has a number and no region. \throws
  /// std::out_of_range for a node that is not there
  std::size_t cell_of(std::uint32_t node) const { return by_node_.at(node); }
  /// Cells put aside at the end of this step and taken up, or dropped, later; the next to be taken up comes first.
  /// Nothing for a grid, which puts nothing aside.
  std::vector<std::size_t> pending(std::size_t step) const;
  /// The nearest hit so far, at the end of this step; a miss before the first.
  Hit<float> hit_at(std::size_t step) const;

 private:
  friend Walk record_walk(const Tracer&, const Ray<float>&);
  std::unordered_map<std::uint32_t, std::size_t> by_node_;
  bool puts_aside_ = true;
};

/// Asks for the nearest hit. A lazy structure grows on the way: its cells are those after the query.
Walk record_walk(const Tracer& tracer, const Ray<float>& ray);

}  // namespace sightline::viz
