#include "viz/walk/walk_space.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viz/cell_geometry.h"
#include "viz/space_actor.h"
#include "viz/walk/split_plane.h"
#include "viz/walk/walk_colors.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

/// Lines and triangles that are made here.
class Shapes3d {
 public:
  void line(const Vec3d& a, const Vec3d& b) { add(*lines_, {a, b}); }
  void dashes(const Vec3d& a, const Vec3d& b, double length) {
    const double all = glm::length(b - a);
    const int count = std::clamp(static_cast<int>(std::ceil(all / length)), 1, 2000);
    for (int i = 0; i < count; ++i) {
      line(a + (double(i) / count) * (b - a), a + ((i + 0.5) / count) * (b - a));
    }
  }
  void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) { add(*polygons_, {a, b, c}); }
  vtkSmartPointer<vtkPolyData> data() const {
    auto data = New<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetLines(lines_);
    data->SetPolys(polygons_);
    return data;
  }

 private:
  void add(vtkCellArray& cells, std::initializer_list<Vec3d> corners) {
    cells.InsertNextCell(static_cast<int>(corners.size()));
    for (const Vec3d& p : corners) cells.InsertCellPoint(points_->InsertNextPoint(p.x, p.y, p.z));
  }

  New<vtkPoints> points_ = New<vtkPoints>::New();
  New<vtkCellArray> lines_ = New<vtkCellArray>::New(), polygons_ = New<vtkCellArray>::New();
};

/// Every line of the data broken into dashes.
vtkSmartPointer<vtkPolyData> dashed(vtkPolyData& data, double length) {
  Shapes3d shapes;
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  vtkCellArray* lines = data.GetLines();
  for (lines->InitTraversal(); lines->GetNextCell(count, ids);) {
    for (vtkIdType i = 0; i + 1 < count; ++i) {
      Vec3d a, b;
      data.GetPoint(ids[i], &a[0]);
      data.GetPoint(ids[i + 1], &b[0]);
      shapes.dashes(a, b, length);
    }
  }
  return shapes.data();
}

/// A cone that ends at the tip.
void add_head(Shapes3d& shapes, const Vec3d& tip, const Vec3d& direction, double length) {
  const Vec3d axis = glm::normalize(direction), base = tip - length * axis;
  const Vec3d away = std::fabs(axis.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d x = glm::normalize(glm::cross(away, axis)), y = glm::cross(axis, x);
  constexpr int sides = 16;
  const auto rim = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    return base + 0.32 * length * (std::cos(angle) * x + std::sin(angle) * y);
  };
  for (int i = 0; i < sides; ++i) {
    shapes.triangle(tip, rim(i), rim(i + 1));
    shapes.triangle(base, rim(i + 1), rim(i));
  }
}

double size_of(const WalkModel& model) { return glm::length(Vec3d(model.tracer->mesh().bounds().extent())); }

}  // namespace

WalkSpace::WalkSpace(vtkRenderWindow& window, const TriangleMesh& coarse, double scale)
    : scale_(scale), mesh_(New<vtkRenderer>::New()), over_(New<vtkRenderer>::New()) {
  window.SetNumberOfLayers(3);
  mesh_->SetBackground(1, 1, 1);
  light_space(*mesh_);
  auto normals = New<vtkPolyDataNormals>::New();
  normals->SetInputData(mesh_surface(coarse));
  normals->SetFeatureAngle(60);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  auto surface = add_actor(*mesh_, normals->GetOutput(), {0.97, 0.965, 0.95}, 1);
  surface->GetProperty()->SetAmbient(0.6);
  surface->GetProperty()->SetDiffuse(0.42);
  over_->SetLayer(1);
  over_->SetActiveCamera(mesh_->GetActiveCamera());
  window.AddRenderer(mesh_);
  window.AddRenderer(over_);
}

void WalkSpace::place(const Panel& panel, const WalkLayout& layout) {
  for (const auto& renderer : {mesh_, over_}) {
    renderer->SetViewport(panel.x / layout.width(), 1 - (panel.y + panel.height) / layout.height(),
                          (panel.x + panel.width) / layout.width(), 1 - panel.y / layout.height());
  }
}

void WalkSpace::add_lines(vtkPolyData* data, const Rgb& color, double width, double opacity) {
  if (data->GetNumberOfCells() == 0) return;
  auto actor = add_actor(*over_, data, over_white(color, opacity), 1);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(static_cast<float>(width * scale_));
}

void WalkSpace::show(const WalkModel& model, std::size_t step, const Axes& axes) {
  over_->RemoveAllViewProps();
  const std::vector<CellState> states = states_at(model.walk, step);
  std::array<std::vector<Cell>, state_names.size()> cells;
  std::vector<Cell> made;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Cell& cell = model.walk.cells[i].cell;
    cells[static_cast<std::size_t>(states[i])].push_back(cell);
    if (model.is_new[i] && states[i] != CellState::unseen) made.push_back(cell);
  }
  const auto outlines = [&](CellState state) { return cell_outlines(cells[static_cast<std::size_t>(state)], axes.z); };
  add_lines(outlines(CellState::beside), {0.8, 0.81, 0.84}, 0.8, 1);
  add_lines(outlines(CellState::opened), color_of(CellState::opened), 1.2, 0.8);
  add_lines(dashed(*outlines(CellState::culled), 0.025 * size_of(model)), color_of(CellState::culled), 2, 1);
  add_lines(dashed(*cell_outlines(made, axes.z), 0.012 * size_of(model)), ink, 1.2, 1);
  add_lines(outlines(CellState::pending), color_of(CellState::pending), 2, 0.9);
  add_lines(outlines(CellState::current), color_of(CellState::current), 3.6, 1);
  Shapes3d planes;
  for (const auto& face : split_faces(model.tracer->name(), model.walk, step)) {
    for (std::size_t i = 0; i < face.size(); ++i) planes.line(face[i], face[(i + 1) % face.size()]);
    if (face.size() == 4) planes.line(face[0], face[2]), planes.line(face[1], face[3]);
  }
  add_lines(planes.data(), split_color, 2.2, 1);
  add_candidates(model, step);
  add_ray(model, step);
  const auto& current = cells[static_cast<std::size_t>(CellState::current)];
  if (current.empty()) return;
  // Last, over all that is within. As VTK takes it for opaque there is no pass for what is translucent, which costs
  // more than all else.
  auto fill = add_actor(*over_, cell_surfaces(current), color_of(CellState::current), 0.16);
  fill->GetProperty()->LightingOff();
  fill->ForceOpaqueOn();
}

void WalkSpace::add_candidates(const WalkModel& model, std::size_t step) {
  const Walk& walk = model.walk;
  if (walk.steps.empty()) return;
  const TriangleMesh& mesh = model.tracer->mesh();
  Shapes3d tested, crossed, nearest, waiting;
  const auto add_edges = [&](Shapes3d& shapes, const Triangle& t) {
    shapes.line(t.a, t.b), shapes.line(t.b, t.c), shapes.line(t.c, t.a);
  };
  constexpr std::size_t most = 20'000;
  for (std::size_t i = step >= most ? step - most : 0; i <= step; ++i) {
    const WalkStep& at = walk.steps[i];
    if (at.kind != WalkStep::Kind::candidate) continue;
    const Triangle triangle = mesh[at.triangle];
    add_edges(tested, triangle);
    if (at.is_crossed) crossed.triangle(triangle.a, triangle.b, triangle.c);
  }
  const std::uint32_t leaf = walk.steps[step].node;
  for (std::size_t i = step + 1; i < std::min(walk.steps.size(), step + most); ++i) {
    if (walk.steps[i].kind != WalkStep::Kind::candidate || walk.steps[i].node != leaf) break;
    add_edges(waiting, mesh[walk.steps[i].triangle]);
  }
  if (const Hit<float> hit = walk.hit_at(step); hit.is_hit()) {
    const Triangle triangle = mesh[hit.prim_id];
    nearest.triangle(triangle.a, triangle.b, triangle.c);
    add_edges(nearest, triangle);
  }
  add_lines(waiting.data(), color_of(CellState::current), 1.4, 1);
  add_lines(tested.data(), ink, 1.4, 1);
  add_lines(crossed.data(), sky, 1, 0.9);
  add_lines(nearest.data(), vermillion, 3, 1);
}

void WalkSpace::add_ray(const WalkModel& model, std::size_t step) {
  const Ray<double> ray = to_double(model.walk.ray);
  const Stretch shown = shown_stretch(model.tracer->mesh().bounds(), model.walk.ray);
  const double size = size_of(model);
  const double at = model.walk.steps.empty() ? shown.from : std::clamp(t_at(model.walk, step), shown.from, shown.to);
  Shapes3d solid, beyond, head;
  if (at > shown.from) solid.line(ray.at(shown.from), ray.at(at));
  if (at < shown.to) beyond.dashes(ray.at(at), ray.at(shown.to), 0.022 * size);
  add_head(head, ray.at(shown.to) + 0.03 * size * glm::normalize(ray.direction), ray.direction, 0.04 * size);
  add_lines(solid.data(), ink, 4, 1);
  add_lines(beyond.data(), ink, 2, 1);
  add_lines(head.data(), ink, 1, 1);
}

void WalkSpace::aim(const SpaceCamera& camera) {
  camera.aim(*mesh_->GetActiveCamera());
  // One range for both, which share the camera: all that is shown lies near the mesh.
  const double distance = glm::length(camera.eye - camera.focus);
  mesh_->GetActiveCamera()->SetClippingRange(0.02 * distance, 8 * distance);
}

SpaceCamera walk_camera(const WalkModel& model, double azimuth, double elevation, double zoom, double aspect) {
  const Aabb& bounds = model.tracer->mesh().bounds();
  const Stretch shown = shown_stretch(bounds, model.walk.ray);
  const Ray<double> ray = to_double(model.walk.ray);
  std::vector<Vec3d> seen = {ray.at(shown.from), ray.at(shown.to)};
  for (const Vec3f& p : hull_of(bounds).points) seen.emplace_back(p);
  return fit_camera(axes_toward(azimuth, elevation), seen, aspect, zoom);
}

}  // namespace sightline::viz
