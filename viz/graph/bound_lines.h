#pragma once
/// Bounds as lines.

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "viz/graph/graph_frames.h"
#include "viz/graph/tree_rows.h"
#include "viz/partition.h"

namespace sightline::viz {

/// A bound, larger by `padding` to all sides.
Cell cell_of(const Bound& bound, double padding, std::uint32_t depth);

/// Bit for bit.
bool is_same(const Bound& a, const Bound& b);

/// How far apart bounds are drawn that nearly coincide with one below them, each a step beyond the other: 0, 1, 2 and
/// so on for each of `nodes`, which are in the order of the tree.
std::vector<double> paddings(const SceneGraph& graph, const TreeShape& shape, const Snapshot& snapshot,
                             const std::vector<NodeId>& nodes);

/// Lines in pieces of a length, with gaps as long.
vtkSmartPointer<vtkPolyData> dashed(vtkPolyData& lines, double length);

}  // namespace sightline::viz
