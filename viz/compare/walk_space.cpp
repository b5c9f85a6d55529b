#include "viz/compare/walk_space.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "viz/cell_geometry.h"
#include "viz/compare/comparison.h"
#include "viz/graph/bound_lines.h"
#include "viz/space_actor.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

/// Without light; lines of this width.
vtkSmartPointer<vtkActor> add_lines(vtkRenderer& renderer, vtkPolyData* data, const Rgb& color, double width,
                                    double opacity = 1) {
  auto actor = add_actor(renderer, data, color, opacity);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  actor->GetProperty()->LightingOff();
  return actor;
}

/// Gives each line and polygon the color of its cell's turn.
void color_by_order(vtkActor& actor, vtkPolyData& data, const std::unordered_map<std::uint32_t, std::size_t>& order,
                    std::size_t most) {
  auto colors = New<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(3);
  vtkDataArray* nodes = data.GetCellData()->GetArray("node");
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
    const Rgb color = opening_color(order.at(static_cast<std::uint32_t>(nodes->GetComponent(i, 0))), most);
    for (const double component : color) {
      colors->InsertNextValue(static_cast<unsigned char>(std::lround(255 * std::clamp(component, 0.0, 1.0))));
    }
  }
  data.GetCellData()->SetScalars(colors);
  actor.GetMapper()->ScalarVisibilityOn();
  actor.GetMapper()->SetScalarModeToUseCellData();
}

/// What the walk touches, by how it is drawn; cells in the order in which they are opened.
struct Touched {
  std::vector<Cell> inner, leaves, culled;
  std::unordered_map<std::uint32_t, std::size_t> order;
  std::vector<std::uint32_t> tested;
};

Touched touched_by(const Walk& walk) {
  Touched touched;
  for (const WalkStep& step : walk.steps) {
    if (step.kind == WalkStep::Kind::candidate) {
      // The one that is hit is drawn by itself: in the same place, the two would fight.
      if (step.triangle != walk.hit.prim_id) touched.tested.push_back(step.triangle);
      continue;
    }
    const Cell& cell = walk.cells[walk.cell_of(step.node)].cell;
    if (step.kind == WalkStep::Kind::cull) {
      touched.culled.push_back(cell);
    } else if (touched.order.emplace(step.node, touched.order.size()).second) {
      (step.kind == WalkStep::Kind::leaf ? touched.leaves : touched.inner).push_back(cell);
    }
  }
  return touched;
}

vtkSmartPointer<vtkPolyData> triangles_of(const TriangleMesh& mesh, std::span<const std::uint32_t> ids) {
  auto points = New<vtkPoints>::New();
  auto polygons = New<vtkCellArray>::New();
  for (const std::uint32_t id : ids) {
    polygons->InsertNextCell(3);
    const auto [a, b, c] = mesh[id];
    for (const Vec3f& corner : {a, b, c}) {
      polygons->InsertCellPoint(points->InsertNextPoint(corner.x, corner.y, corner.z));
    }
  }
  auto data = New<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

vtkSmartPointer<vtkPolyData> segment(const Vec3d& from, const Vec3d& to) {
  auto points = New<vtkPoints>::New();
  points->InsertNextPoint(&from[0]);
  points->InsertNextPoint(&to[0]);
  auto lines = New<vtkCellArray>::New();
  const vtkIdType ends[] = {0, 1};
  lines->InsertNextCell(2, ends);
  auto data = New<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

/// The ray's part that is worth drawing: from its origin to beyond the scene, and not behind the camera.
struct Stretch {
  double from, to;
};

Stretch stretch_of(const Ray<float>& ray, const Aabb& bounds, const SpaceCamera& camera) {
  const Vec3d origin(ray.origin), direction(ray.direction), center(bounds.center());
  const double radius = 0.5 * glm::length(Vec3d(bounds.extent())), length = glm::length(direction);
  const double nearest = glm::dot(center - origin, direction) / (length * length);
  Stretch stretch{std::max(double(ray.t_min), nearest - 2.2 * radius / length), nearest + 1.3 * radius / length};
  stretch.to = std::max(stretch.to, stretch.from);
  // Depth before the camera is start + t * slope.
  const double start = -glm::dot(origin - camera.eye, camera.axes.z), slope = -glm::dot(direction, camera.axes.z);
  const double least = 0.02 * glm::length(camera.eye - camera.focus);
  if (slope > 0) stretch.from = std::max(stretch.from, (least - start) / slope);
  if (slope < 0) stretch.to = std::min(stretch.to, (least - start) / slope);
  return stretch;
}

void add_ray(vtkRenderer& renderer, const Walk& walk, const Aabb& bounds, const SpaceCamera& camera, double scale) {
  const Vec3d origin(walk.ray.origin), direction(walk.ray.direction);
  const auto at = [&](double t) { return origin + t * direction; };
  const Stretch stretch = stretch_of(walk.ray, bounds, camera);
  if (!(stretch.to > stretch.from)) return;
  const double end = walk.hit.is_hit() ? std::clamp(double(walk.hit.t), stretch.from, stretch.to) : stretch.to;
  add_lines(renderer, segment(at(stretch.from), at(end)), ink, 3.4 * scale);
  if (end < stretch.to) {
    const double dash = 0.012 * glm::length(camera.eye - camera.focus);
    add_lines(renderer, dashed(*segment(at(end), at(stretch.to)), dash), soft_ink, 1.6 * scale);
  }
}

}  // namespace

Rgb opening_color(std::size_t order, std::size_t most) {
  return ramp(most < 2 ? 0 : double(order) / double(most - 1), 0.28, 0.78);
}

vtkSmartPointer<vtkPolyData> smooth_surface(const TriangleMesh& mesh) {
  auto normals = New<vtkPolyDataNormals>::New();
  normals->SetInputData(mesh_surface(mesh));
  normals->SetFeatureAngle(50);
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

SpaceCamera close_camera(const SpaceCamera& camera, const Aabb& bounds, const Vec3d& place, double aspect) {
  const double half = 0.022 * glm::length(Vec3d(bounds.extent()));
  std::vector<Vec3d> corners;
  for (const double x : {-half, half}) {
    for (const double y : {-half, half}) corners.push_back(x * camera.axes.x + y * camera.axes.y);
  }
  SpaceCamera close = fit_camera(camera.axes, corners, aspect, 1);  // around the origin, where it is exact
  close.eye += place;
  close.focus += place;
  return close;
}

std::vector<vtkSmartPointer<vtkRenderer>> ComparedSpace::renderers(const Walk& walk, const PanelFrame& frame,
                                                                   const PartPlace& place, int layer) const {
  auto below = place.renderer(frame), above = place.renderer(frame);
  below->SetLayer(layer);
  below->PreserveColorBufferOff();  // what lies beneath does not shine through
  above->SetLayer(layer + 1);
  for (const auto& renderer : {below, above}) {
    renderer->InteractiveOff();
    camera.aim(*renderer->GetActiveCamera());
  }
  light_space(*below);
  vtkProperty* look = add_lines(*below, surface, {0.93, 0.925, 0.915}, 1)->GetProperty();
  look->LightingOn();
  look->SetAmbient(0.55);
  look->SetDiffuse(0.5);
  look->SetInterpolationToPhong();
  below->ResetCameraClippingRange();

  const Touched touched = touched_by(walk);
  const double scale = place.scale;
  const double crowd = std::clamp(60.0 / double(1 + touched.order.size()), 0.5, 1.0);
  const auto add_cells = [&](const std::vector<Cell>& cells, double width) {
    if (cells.empty()) return;
    auto lines = cell_outlines(cells, camera.axes.z);
    color_by_order(*add_lines(*above, lines, ink, width * scale), *lines, touched.order, most_opened);
  };
  if (!touched.leaves.empty()) {
    auto faces = cell_surfaces(touched.leaves);
    color_by_order(*add_lines(*above, faces, ink, 1, 0.1), *faces, touched.order, most_opened);
  }
  if (!touched.culled.empty()) {
    const double dot = 0.006 * glm::length(camera.eye - camera.focus);
    add_lines(*above, dashed(*cell_outlines(touched.culled, camera.axes.z), dot), culled_color, 1.8 * scale);
  }
  add_cells(touched.inner, 1.3 * crowd + 0.3);
  add_cells(touched.leaves, 2.8 * crowd);
  if (!touched.tested.empty()) {
    auto triangles = triangles_of(mesh, touched.tested);
    add_lines(*above, triangles, tested_color, 1, 0.75);
    add_lines(*above, triangles, tested_color, 1.6 * scale)->GetProperty()->SetRepresentationToWireframe();
  }
  if (walk.hit.is_hit()) {
    const std::uint32_t hit[] = {walk.hit.prim_id};
    auto triangle = triangles_of(mesh, hit);
    add_lines(*above, triangle, hit_color, 1);
    add_lines(*above, triangle, hit_color, 3 * scale)->GetProperty()->SetRepresentationToWireframe();
  }
  add_ray(*above, walk, mesh.bounds(), camera, scale);
  above->ResetCameraClippingRange();
  return {below, above};
}

}  // namespace sightline::viz
