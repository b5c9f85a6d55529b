#include "viz/partition_picture.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkCutter.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "viz/cell_geometry.h"
#include "viz/overlay.h"
#include "viz/space_actor.h"
#include "viz/space_camera.h"
#include "viz/window_image.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

bool is_round(const Cell& cell) {
  return std::holds_alternative<Sphere>(cell.region) || std::holds_alternative<Cylinder>(cell.region);
}

/// The mesh in soft gray; with a slice, only what lies beyond the plane, and the plane's cut through it in black.
void add_mesh(vtkRenderer& renderer, const TriangleMesh& mesh, vtkPlane* plane, double scale) {
  auto normals = New<vtkPolyDataNormals>::New();
  normals->SetInputData(mesh_surface(mesh));
  normals->SetFeatureAngle(50);
  normals->ConsistencyOff();
  normals->Update();
  auto surface = add_actor(renderer, normals->GetOutput());
  vtkProperty* look = surface->GetProperty();
  look->SetColor(0.84, 0.83, 0.81);
  look->SetAmbient(0.22);
  look->SetDiffuse(0.8);
  look->SetInterpolationToPhong();
  if (!plane) return;
  surface->GetMapper()->AddClippingPlane(plane);
  auto cutter = New<vtkCutter>::New();
  cutter->SetInputData(mesh_surface(mesh));
  cutter->SetCutFunction(plane);
  cutter->Update();
  auto cut = add_actor(renderer, cutter->GetOutput());
  cut->GetProperty()->SetColor(0.05, 0.05, 0.05);
  cut->GetProperty()->SetLineWidth(static_cast<float>(2.2 * scale));
  cut->GetProperty()->LightingOff();
}

/// Lines of one level: wide and dark for the shallowest, fine for the deepest.
void style_lines(vtkActor& actor, const Coloring& coloring, int level, std::size_t count, double scale) {
  const Rgb color = coloring.color(level);
  const double share = coloring.share(level);
  vtkProperty* look = actor.GetProperty();
  look->SetColor(color[0], color[1], color[2]);
  const bool is_crowded = count > 600;
  const double extra = coloring.is_by_depth() ? 2.2 * std::pow(1 - share, 2) : 0;
  look->SetLineWidth(static_cast<float>(scale * ((is_crowded ? 0.8 : 1.2) + extra)));
  look->SetOpacity(is_crowded && coloring.is_by_depth() ? 1 - 0.35 * share : 1);
  look->LightingOff();
  // Cells share edges with their ancestors: there, the shallower line is drawn in front.
  vtkMapper* mapper = actor.GetMapper();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -4 - 8.0 * (coloring.highest() - level));
}

void tint(vtkActor& actor, const Rgb& color, double opacity) {
  actor.GetProperty()->SetColor(color[0], color[1], color[2]);
  actor.GetProperty()->SetOpacity(opacity);
  actor.GetProperty()->LightingOff();
}

}  // namespace

Angles angles_of(const View& view, const std::optional<Slice>& slice) {
  Angles angles{24, 20};
  if (slice) angles = {slice->axis == 0 ? 90.0 : 0.0, slice->axis == 1 ? 90.0 : 0.0};
  return {view.azimuth.value_or(angles.azimuth), view.elevation.value_or(angles.elevation)};
}

void PartitionPicture::show_in(vtkRenderWindow& window, double scale) const {
  window.GetRenderers()->RemoveAllItems();
  const Coloring coloring(partition);
  std::map<int, std::vector<Cell>> levels;
  for (const Cell& cell : partition.cells) levels[coloring.level_of(cell)].push_back(cell);

  auto frame = New<vtkRenderer>::New();
  frame->SetBackground(1, 1, 1);
  frame->InteractiveOff();
  Overlay overlay{{{caption.title, 24, true, 0.05},
                   {summary(partition) + "; " + with_commas(mesh.size()) + " triangles", 16, false, 0.2},
                   {caption.subtitle, 14, false, 0.45}},
                  coloring,
                  {},
                  view.width,
                  view.height,
                  scale};
  for (int level = coloring.lowest(); level <= coloring.highest(); ++level) {
    overlay.counts.push_back(levels.contains(level) ? levels[level].size() : 0);
  }
  overlay.add_to(*frame);
  window.AddRenderer(frame);

  auto space = New<vtkRenderer>::New();
  space->SetBackground(1, 1, 1);
  const double right = 1 - double(Overlay::legend) / view.width, top = 1 - double(Overlay::top) / view.height;
  space->SetViewport(0, 0.01, right, top);
  light_space(*space);
  const Angles angles = angles_of(view, slice);
  const Axes axes = axes_toward(angles.azimuth, angles.elevation);

  New<vtkPlane> plane;
  const double position = slice ? slice->position(mesh.bounds()) : 0;
  Vec3d lift(0);  // holds lines and tints apart from the surfaces they lie in
  if (slice) {
    Vec3d beyond(0), on_plane(0);
    beyond[slice->axis] = axes.z[slice->axis] >= 0 ? -1 : 1;
    on_plane[slice->axis] = position;
    plane = New<vtkPlane>::New();
    plane->SetNormal(&beyond[0]);
    plane->SetOrigin(&on_plane[0]);
    lift = -2e-4 * double(max_norm(mesh.bounds().extent())) * beyond;
  }
  add_mesh(*space, mesh, plane, scale);

  std::vector<Vec3d> seen;
  for (const Vec3f& p : mesh.positions()) seen.push_back(Vec3d(p));
  int order = 0;
  for (const auto& [level, cells] : levels) {
    const auto [fills, lines] = slice ? cell_sections(cells, slice->axis, position)
                                      : Sections{cell_surfaces(cells), cell_outlines(cells, axes.z)};
    auto outline = add_actor(*space, lines);
    style_lines(*outline, coloring, level, partition.cells.size(), scale);
    const Vec3d raised = lift * double(++order + 1);
    outline->SetPosition(raised.x, raised.y, raised.z);
    for (const Vec3d& p : points_of(*lines)) seen.push_back(p);

    // Only leaves are tinted in a section: they tile it, or overlap as little as the structure allows.
    const bool is_tinted = slice ? std::any_of(cells.begin(), cells.end(), [](const Cell& c) { return c.is_leaf; })
                                 : level == coloring.highest() && is_round(cells.front());
    if (!is_tinted) continue;
    if (slice) {
      std::vector<Cell> leaves;
      std::copy_if(cells.begin(), cells.end(), std::back_inserter(leaves), [](const Cell& c) { return c.is_leaf; });
      auto fill = add_actor(*space, cell_sections(leaves, slice->axis, position).polygons);
      tint(*fill, coloring.color(level), 0.55);
      fill->SetPosition(lift.x, lift.y, lift.z);
    } else {
      auto fill = add_actor(*space, fills);
      tint(*fill, coloring.color(level), 0.08);
      fill->GetProperty()->LightingOn();
      fill->GetProperty()->SetAmbient(0.7);
      fill->GetProperty()->SetDiffuse(0.4);
    }
  }

  const double aspect = view.width * right / (view.height * (top - 0.01));
  window.AddRenderer(space);
  fit_camera(axes, seen, aspect, view.zoom).aim(*space->GetActiveCamera());
  space->ResetCameraClippingRange();
}

void PartitionPicture::write_png(const std::filesystem::path& path) const {
  write_picture(path, view.width, view.height, [this](vtkRenderWindow& window, int scale) { show_in(window, scale); });
}

std::string with_commas(std::size_t count) {
  std::string text = std::to_string(count);
  for (auto at = static_cast<int>(text.size()) - 3; at > 0; at -= 3) text.insert(static_cast<std::size_t>(at), ",");
  return text;
}

std::string summary(const Partition& partition) {
  if (partition.cells.empty()) return "none of " + with_commas(partition.total) + " cells";
  std::string text = with_commas(partition.cells.size()) + " of " + with_commas(partition.total) + " cells, depth " +
                     std::to_string(partition.shallowest);
  if (partition.deepest != partition.shallowest) text += " to " + std::to_string(partition.deepest);
  text += " of " + std::to_string(partition.total_deepest);
  if (partition.passing > partition.cells.size()) {
    text += " (the largest of " + with_commas(partition.passing) + " that match)";
  }
  return text;
}

}  // namespace sightline::viz
