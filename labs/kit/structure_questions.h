#pragma once
/// What is asked of a structure, and what it answers.

#include <vector>

#include "labs/kit/wire.h"
#include "sightline/accel/accelerator.h"

namespace sightline {

// Named here, where argument-dependent lookup finds them.
inline auto wired(Polyhedron& p) { return std::tie(p.vertices, p.faces); }
inline auto wired(Cell& c) { return std::tie(c.region, c.depth, c.is_leaf, c.range, c.node); }

}  // namespace sightline

namespace sightline::labs {

/// An option to build with, where the structure has one of that name.
struct WantedOption {
  std::string name, value;
};
inline auto wired(WantedOption& o) { return std::tie(o.name, o.value); }

/// A structure once it is built.
struct StructureFacts {
  std::string name;
  std::uint64_t memory_bytes = 0;
  std::vector<std::uint32_t> leaf_order;
};
inline auto wired(StructureFacts& f) { return std::tie(f.name, f.memory_bytes, f.leaf_order); }

/// Nearest hits of many rays, and the work of all.
template <class T>
struct TracedRays {
  std::vector<Hit<T>> hits;
  std::vector<std::uint8_t> is_hit;  ///< What any_hit says of each.
  TraversalStats stats;              ///< Of the nearest hits.
};
template <class T>
auto wired(TracedRays<T>& t) {
  return std::tie(t.hits, t.is_hit, t.stats);
}

/// One ray's way.
struct RecordedWalk {
  Hit<float> hit;
  std::vector<WalkRecorder::Step> steps;
};
inline auto wired(RecordedWalk& w) { return std::tie(w.hit, w.steps); }

}  // namespace sightline::labs
