#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "sightline/scene/live_scene.h"

namespace sightline {

/// Pairs of nodes whose geometries may overlap, the lower number first, in order, and how many pairs of bounds were
/// held against each other.
struct Overlaps {
  std::vector<std::pair<NodeId, NodeId>> pairs;
  std::size_t tests = 0;
};

/// All pairs of nodes whose geometries overlap, and those whose own bounds of the kind do although their geometries do
/// not, but for what the bounds of nodes above them part.
Overlaps find_overlaps(LiveScene& scene, BoundKind kind);

}  // namespace sightline
