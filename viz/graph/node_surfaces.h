#pragma once
/// Geometries of a scene as VTK shows them: each once, however many nodes share it.

#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "sightline/scene/scene.h"
#include "viz/color_ramp.h"

namespace sightline::viz {

/// A solid of one sphere, box, cylinder, cone or torus as these are; any other by samples of what lies within its
/// bounds, so that edges are rounded by a 64th of its size. Nothing for solids without bounds.
vtkSmartPointer<vtkPolyData> solid_surface(const SolidTree& tree);

class NodeSurfaces {
 public:
  explicit NodeSurfaces(const Scene& scene);

  /// nullptr where the node has no geometry or is hidden, or nothing of it can be drawn.
  vtkPolyDataMapper* mapper(NodeId node) const;
  /// Of its material, or that of the nearest node above with one.
  const Rgb& color(NodeId node) const { return colors_[node]; }
  /// Geometries without bounds, which are not drawn.
  std::size_t endless() const { return endless_; }

 private:
  const SceneGraph& graph_;
  std::vector<vtkSmartPointer<vtkPolyDataMapper>> mappers_;  ///< By geometry.
  std::vector<Rgb> colors_;                                  ///< By node.
  std::vector<bool> is_shown_;                               ///< By node: neither it nor one above it is hidden.
  std::size_t endless_ = 0;
};

}  // namespace sightline::viz
