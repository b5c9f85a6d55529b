#pragma once
/// A scene's tree as indented rows, few enough to be read.

#include <cstdint>
#include <vector>

#include "sightline/scene/scene_graph.h"

namespace sightline::viz {

/// What every node is asked for again and again.
struct TreeShape {
  explicit TreeShape(const SceneGraph& graph);

  std::vector<NodeId> order;          ///< Parents first, children in their order (depth-first).
  std::vector<std::uint32_t> depths;  ///< By node; the root's is 0.
  std::vector<std::uint32_t> sizes;   ///< By node: itself and all below it.
  std::uint32_t deepest = 0;
};

struct TreeRow {
  NodeId node;           ///< no_node: the row stands for nodes that are left out.
  int parent;            ///< The row that it hangs on, or -1.
  int indent;            ///< Rows between it and the first one, on the way up.
  std::uint32_t hidden;  ///< Nodes left out: below a node of which no child is shown, or those that the row stands for.
};

/// At most `most` rows, at least 8.
///   T1  `focus` has a row, and so have the nodes above it, as many as fit: on a long way the middle is left out.
///   T2  Each node has a row or is counted once, as `hidden` of the nearest row above it or of the row below that one
///       which stands for it.
///   T3  What is shown first: what is below `focus`, then beside it, beside its parent, and so on; then what is least
///       deep. Of many siblings the first ones.
std::vector<TreeRow> tree_rows(const SceneGraph& graph, const TreeShape& shape, NodeId focus, std::size_t most);

}  // namespace sightline::viz
