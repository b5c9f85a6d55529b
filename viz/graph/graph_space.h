#pragma once
/// A scene graph's things in space, with the bounds of its nodes.

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <utility>
#include <vector>

#include "viz/canvas.h"
#include "viz/graph/graph_frames.h"
#include "viz/graph/node_surfaces.h"
#include "viz/graph/tree_rows.h"
#include "viz/noise/chart_panels.h"
#include "viz/space_camera.h"

namespace sightline::viz {

/// A scene, and what pictures of it need again and again. Refers to the scene.
struct DrawnScene {
  explicit DrawnScene(const Scene& its_scene)
      : scene(its_scene), graph(its_scene.graph), shape(graph), surfaces(its_scene) {}

  const Scene& scene;
  const SceneGraph& graph;
  TreeShape shape;
  NodeSurfaces surfaces;
};

/// What is shown of a scene, and from where.
struct GraphLook {
  BoundKind kind = BoundKind::box;
  std::uint32_t shallowest = 0;
  std::uint32_t deepest = 0;  ///< See readable_depth().
  NodeId selected = root_node;
  double azimuth = 24, elevation = 16, zoom = 1;
  bool has_things = true;  ///< Otherwise bounds only.
};

/// The deepest depth down to which no more nodes have bounds than can be told apart in a picture.
std::uint32_t readable_depth(const TreeShape& shape, const Snapshot& snapshot, BoundKind kind);

/// Nodes whose bounds a frame shows: of the depths asked for, and those that are told or moved.
std::vector<NodeId> nodes_with_bounds(const DrawnScene& drawn, const GraphFrame& frame, const GraphLook& look);

/// Of a depth; the same in the tree and in space.
Rgb color_of_depth(std::uint32_t depth, std::uint32_t deepest);

/// A camera for all frames.
SpaceCamera camera_for(const DrawnScene& drawn, const std::vector<GraphFrame>& frames, const GraphLook& look,
                       double aspect);

/// Width over height of what such a camera sees.
double aspect_of(const DrawnScene& drawn, const std::vector<GraphFrame>& frames, const GraphLook& look);

/// Numbers that tell the order in which an event passes nodes: of long ways only the first and the last ones.
std::vector<std::pair<NodeId, std::size_t>> numbered(const GraphFrame& frame);
/// A number in a disc; `is_latest` stands out.
void draw_number(Canvas& canvas, const Canvas::Point& at, std::size_t number, bool is_latest);

struct GraphSpace {
  vtkSmartPointer<vtkRenderer> renderer;
  std::vector<std::pair<vtkActor*, NodeId>> things;
};

/// What is written over the things goes to `over`.
GraphSpace space_of(const DrawnScene& drawn, const GraphFrame& frame, const GraphLook& look, const SpaceCamera& camera,
                    const PanelFrame& panel, const PartPlace& place, Canvas& over);

}  // namespace sightline::viz
