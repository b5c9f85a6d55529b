#pragma once
/// A ray's walk through one structure, drawn in space.

#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "viz/noise/chart_panels.h"
#include "viz/space_camera.h"
#include "viz/walk/walk.h"

namespace sightline::viz {

inline constexpr Rgb tested_color{0.90, 0.62, 0.0}, hit_color = accent, culled_color{0.45, 0.48, 0.55};

/// The color of the `order`-th cell that is opened, from 0, where a walk opens up to `most`.
Rgb opening_color(std::size_t order, std::size_t most);

/// The mesh as it is drawn in every panel: made once.
vtkSmartPointer<vtkPolyData> smooth_surface(const TriangleMesh& mesh);

struct ComparedSpace {
  const TriangleMesh& mesh;
  vtkSmartPointer<vtkPolyData> surface;
  SpaceCamera camera;
  std::size_t most_opened;  ///< Of all walks that share the scale of colors.

  /// Two renderers, for this layer of the window and the next: the mesh, and over it what the walk touches, so that
  /// nothing is hidden.
  std::vector<vtkSmartPointer<vtkRenderer>> renderers(const Walk& walk, const PanelFrame& frame, const PartPlace& place,
                                                      int layer) const;
};

/// In the same direction, but close to a place in the scene: for a picture of this width over height.
SpaceCamera close_camera(const SpaceCamera& camera, const Aabb& bounds, const Vec3d& place, double aspect);

}  // namespace sightline::viz
