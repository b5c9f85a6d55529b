#pragma once
/// A walk in space: the mesh, over it the cells, the candidates and the ray.

#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "viz/space_camera.h"
#include "viz/walk/walk_model.h"

namespace sightline::viz {

/// Cells, candidates and ray are drawn over the mesh, not hidden by it: most of what a walk does is inside.
class WalkSpace {
 public:
  /// `scale` pixels of the window make a pixel of the picture.
  WalkSpace(vtkRenderWindow& window, const TriangleMesh& coarse, double scale);

  void place(const Panel& panel, const WalkLayout& layout);
  void show(const WalkModel& model, std::size_t step, const Axes& axes);
  void aim(const SpaceCamera& camera);

 private:
  /// `opacity` is that over white: what is translucent is slow.
  void add_lines(vtkPolyData* data, const std::array<double, 3>& color, double width, double opacity);
  void add_ray(const WalkModel& model, std::size_t step);
  void add_candidates(const WalkModel& model, std::size_t step);

  double scale_;
  vtkSmartPointer<vtkRenderer> mesh_, over_;
};

/// The camera that shows the mesh and the part of the ray that is shown.
SpaceCamera walk_camera(const WalkModel& model, double azimuth, double elevation, double zoom, double aspect);

}  // namespace sightline::viz
