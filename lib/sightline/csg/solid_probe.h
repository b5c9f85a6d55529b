#pragma once
/// What the evaluation of solids tells of its work.

#include <cstdint>
#include <span>

#include "sightline/csg/boolean.h"
#include "sightline/csg/span_list.h"

namespace sightline {

/// Does not listen.
struct NoSolidProbe {
  static constexpr bool sees_transitions = false;  ///< Whether those that change nothing matter, too.
  void node(std::uint32_t) {}                      ///< A node is evaluated.
  void pruned(std::uint32_t) {}                    ///< A node is left out, for want of a meeting.
  void primitive(std::uint32_t) {}                 ///< A primitive's faces are solved.
  void transition(std::uint32_t, const Transition&, bool, double) {}  ///< Of a node: kept or not, and where.
  void spans(std::uint32_t, std::span<const Boundary>, bool) {}       ///< A node's list.
};

/// Work per ray.
struct SolidStats : NoSolidProbe {
  std::uint64_t nodes = 0, pruned_nodes = 0, primitives = 0, transitions = 0;

  void node(std::uint32_t) { ++nodes; }
  void pruned(std::uint32_t) { ++pruned_nodes; }
  void primitive(std::uint32_t) { ++primitives; }
  void transition(std::uint32_t, const Transition&, bool, double) { ++transitions; }
};

}  // namespace sightline
