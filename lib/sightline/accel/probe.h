#pragma once
/// Observers of a traversal. One traversal serves them all; the silent one compiles to nothing.

#include <cstdint>
#include <vector>

namespace sightline {

/// Positions [first, first + count) in the structure's leaf order.
struct LeafRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// Node numbers are those of the cells that `for_each_cell` shows. `t` is where the ray enters the node's region.
struct NoProbe {
  void node(std::uint32_t /*node*/, double /*t*/) {}             ///< An inner node, or an empty cell, is examined.
  void leaf(std::uint32_t /*node*/, LeafRange, double /*t*/) {}  ///< Candidates are about to be handed out.
  void cull(std::uint32_t /*node*/, double /*t*/) {}             ///< Reached, but farther than the far limit.
};

/// Counts the work of one or more traversals.
struct TraversalStats {
  std::uint64_t nodes = 0;       ///< Inner nodes and empty cells examined.
  std::uint64_t leaves = 0;      ///< Leaves whose candidates were handed out.
  std::uint64_t candidates = 0;  ///< Primitives handed out; one that several leaves hold counts each time.
  std::uint64_t culled = 0;      ///< Nodes put aside and later dropped unopened, because a hit came before them.

  void node(std::uint32_t, double) { ++nodes; }
  void leaf(std::uint32_t, LeafRange range, double) {
    ++leaves;
    candidates += range.count;
  }
  void cull(std::uint32_t, double) { ++culled; }

  friend bool operator==(const TraversalStats&, const TraversalStats&) = default;
};

/// Writes the walk down, step by step, for drawing.
struct WalkRecorder {
  enum class Event : std::uint8_t { node, leaf, cull };
  struct Step {
    Event event;
    std::uint32_t node;
    LeafRange range;  ///< Only for leaves.
    double t;
  };
  std::vector<Step> steps;

  void node(std::uint32_t node, double t) { steps.push_back({Event::node, node, {}, t}); }
  void leaf(std::uint32_t node, LeafRange range, double t) { steps.push_back({Event::leaf, node, range, t}); }
  void cull(std::uint32_t node, double t) { steps.push_back({Event::cull, node, {}, t}); }
};

}  // namespace sightline
