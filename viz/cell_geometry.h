#pragma once
/// Cells as VTK geometry. Each polygon and line carries its cell's `depth`, `leaf` (0 or 1), `candidates` and `node`.

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <span>
#include <vector>

#include "viz/partition.h"

namespace sightline::viz {

/// The regions' surfaces as convex polygons, outward; round regions within their tessellation (inscribed polyhedra).
vtkSmartPointer<vtkPolyData> cell_surfaces(std::span<const Cell> cells);

/// Lines that let a region be recognized: the edges of boxes and polyhedra, rims and sides of a cylinder, and of a
/// sphere three great circles, or only the one that faces `eye_direction` where that is given.
vtkSmartPointer<vtkPolyData> cell_outlines(std::span<const Cell> cells,
                                           const std::optional<Vec3d>& eye_direction = std::nullopt);

/// Where the plane cuts the regions: one convex polygon a cell, and as `outlines` its closed border.
struct Sections {
  vtkSmartPointer<vtkPolyData> polygons;
  vtkSmartPointer<vtkPolyData> outlines;
};
Sections cell_sections(std::span<const Cell> cells, int axis, double position);

std::vector<Vec3d> points_of(vtkPolyData& data);

/// Each triangle once, however often the mesh repeats it: what is drawn over itself shows nothing new.
vtkSmartPointer<vtkPolyData> mesh_surface(const TriangleMesh& mesh);

}  // namespace sightline::viz
