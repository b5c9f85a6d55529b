#pragma once
/// What pictures of a scene graph show, as text. Volumes are in cubic units of the world.

#include <string>
#include <vector>

#include "viz/graph/graph_frames.h"
#include "viz/graph/tree_rows.h"

namespace sightline::viz {

/// One line a node: its path, depth and the volume of its bound.
std::string still_table(const SceneGraph& graph, const TreeShape& shape, const Snapshot& snapshot);

/// One line a node, in the order of the tree: as which the event has passed it, or that it moves along without being
/// told, and the volume of its bound before and after. With `is_short` only nodes that the event has passed.
std::string change_table(const SceneGraph& graph, const TreeShape& shape, const Change& change, bool is_short);

/// One line a frame: how many nodes events have passed, and the volumes of the bounds of the root and a node.
std::string motion_table(const SceneGraph& graph, const std::vector<GraphFrame>& frames, NodeId node);

}  // namespace sightline::viz
