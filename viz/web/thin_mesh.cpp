#include "viz/web/thin_mesh.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkQuadricClustering.h>

#include <algorithm>
#include <cmath>

#include "viz/cell_geometry.h"

namespace sightline::viz {
namespace {

ThinMesh read(vtkPolyData& surface) {
  ThinMesh mesh;
  for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i) {
    double p[3];
    surface.GetPoint(i, p);
    mesh.positions.emplace_back(p[0], p[1], p[2]);
  }
  const auto corners = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType i = 0; i < surface.GetPolys()->GetNumberOfCells(); ++i) {
    surface.GetPolys()->GetCellAtId(i, corners);
    const auto corner = [&](vtkIdType k) { return static_cast<std::uint32_t>(corners->GetId(k)); };
    mesh.triangles.push_back({corner(0), corner(1), corner(2)});
  }
  return mesh;
}

vtkSmartPointer<vtkQuadricClustering> clustering(vtkPolyData* surface, const Vec3d& extent, double divisions) {
  const double edge = std::max({extent.x, extent.y, extent.z}) / divisions;
  const auto along = [&](double length) { return std::max(1, static_cast<int>(std::ceil(length / edge))); };
  auto filter = vtkSmartPointer<vtkQuadricClustering>::New();
  filter->SetInputData(surface);
  filter->AutoAdjustNumberOfDivisionsOff();
  filter->SetNumberOfDivisions(along(extent.x), along(extent.y), along(extent.z));
  filter->CopyCellDataOff();
  filter->Update();
  return filter;
}

}  // namespace

ThinMesh thin_mesh(const TriangleMesh& mesh, std::size_t most) {
  const auto surface = mesh_surface(mesh);
  if (static_cast<std::size_t>(surface->GetNumberOfPolys()) <= most) return read(*surface);
  const Vec3d extent = Vec3d(mesh.bounds().hi) - Vec3d(mesh.bounds().lo);
  // A surface has about as many triangles as the square of the divisions: each try comes nearer.
  double divisions = std::sqrt(double(most));
  auto filter = clustering(surface, extent, divisions);
  for (int tries = 0; tries < 24; ++tries) {
    const auto count = static_cast<std::size_t>(filter->GetOutput()->GetNumberOfPolys());
    const bool is_close = count * 10 > most * 8 || tries >= 3;
    if (count <= most && is_close) break;
    divisions = std::max(2.0, divisions * std::clamp(std::sqrt(0.9 * double(most) / double(count + 1)), 0.4, 1.6));
    filter = clustering(surface, extent, divisions);
  }
  return read(*filter->GetOutput());
}

}  // namespace sightline::viz
