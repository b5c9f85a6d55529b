#include "viz/walk/walk_data.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkUnsignedIntArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>

#include "sightline/io/output_file.h"
#include "viz/cell_export.h"
#include "viz/cell_geometry.h"
#include "viz/walk/walk_colors.h"

namespace sightline::viz {
namespace {

using nlohmann::ordered_json;
using Kind = WalkStep::Kind;

template <class T>
ordered_json list_of(const Vec3<T>& v) {
  return {v.x, v.y, v.z};
}

ordered_json finite(double t) { return std::isfinite(t) ? ordered_json(t) : ordered_json(nullptr); }

ordered_json region_of(const Aabb& box) { return {{"box", {list_of(box.lo), list_of(box.hi)}}}; }
ordered_json region_of(const Sphere& sphere) {
  return {{"sphere", {{"center", list_of(sphere.center)}, {"radius", sphere.radius}}}};
}
ordered_json region_of(const Cylinder& cylinder) {
  return {{"cylinder",
           {{"center", list_of(cylinder.center)},
            {"axis", list_of(cylinder.axis)},
            {"radius", cylinder.radius},
            {"half_length", cylinder.half_length}}}};
}
ordered_json region_of(const Polyhedron& solid) {
  ordered_json vertices = ordered_json::array();
  for (const Vec3d& p : solid.vertices) vertices.push_back(list_of(p));
  return {{"polyhedron", {{"vertices", vertices}, {"faces", solid.faces}}}};
}

ordered_json step_json(const WalkModel& model, std::size_t index) {
  constexpr std::array names = {"visit", "leaf", "candidate", "cull"};
  const WalkStep& step = model.walk.steps[index];
  ordered_json json{{"kind", names[static_cast<std::size_t>(step.kind)]}, {"node", step.node}};
  const bool is_candidate = step.kind == Kind::candidate;
  if (is_candidate) json.update({{"triangle", step.triangle}, {"crossed", step.is_crossed}, {"hit", step.is_hit}});
  json["t"] = is_candidate && !step.is_crossed ? ordered_json(nullptr) : finite(step.t);
  json["far"] = finite(step.far);
  if (is_candidate) return json;
  ordered_json pending = ordered_json::array();
  for (const std::size_t cell : model.walk.pending(index)) pending.push_back(model.walk.cells[cell].cell.node);
  json["pending"] = pending;
  return json;
}

ordered_json cell_json(const WalkModel& model, std::size_t i) {
  const WalkCell& at = model.walk.cells[i];
  ordered_json json{{"node", at.cell.node}};
  json["parent"] = at.parent ? ordered_json(model.walk.cells[*at.parent].cell.node) : ordered_json(nullptr);
  json["depth"] = at.cell.depth;
  json["leaf"] = at.cell.is_leaf;
  json["candidates"] = model.candidates[i];
  json["opened"] = at.opened ? ordered_json(*at.opened) : ordered_json(nullptr);
  json["made"] = model.is_new[i] != 0;
  json["region"] = std::visit([](const auto& region) { return region_of(region); }, at.cell.region);
  return json;
}

Partition come_across(const WalkModel& model, std::size_t step) {
  Partition partition;
  const auto states = states_at(model.walk, step);
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] != CellState::unseen) partition.cells.push_back(model.walk.cells[i].cell);
  }
  if (partition.cells.empty()) throw std::runtime_error("the ray meets no cell: there is nothing to write");
  partition.passing = partition.total = partition.cells.size();
  std::ranges::stable_sort(partition.cells, {}, &Cell::depth);
  partition.shallowest = partition.cells.front().depth;
  partition.deepest = partition.total_deepest = partition.cells.back().depth;
  return partition;
}

}  // namespace

ordered_json walk_json(const WalkModel& model) {
  const Walk& walk = model.walk;
  const TraversalStats stats = walk.statistics();
  ordered_json json{
      {"structure", model.structure},
      {"scene", model.scene},
      {"triangles", model.tracer->mesh().size()},
      {"all_cells", walk.all_cells},
      {"ray", {{"origin", list_of(walk.ray.origin)}, {"direction", list_of(walk.ray.direction)}}},
      {"hit", nullptr},
      {"statistics",
       {{"nodes", stats.nodes}, {"leaves", stats.leaves}, {"candidates", stats.candidates}, {"culled", stats.culled}}}};
  if (walk.hit.is_hit()) json["hit"] = {{"triangle", walk.hit.prim_id}, {"t", walk.hit.t}};
  ordered_json steps = ordered_json::array(), cells = ordered_json::array();
  for (std::size_t i = 0; i < walk.steps.size(); ++i) steps.push_back(step_json(model, i));
  for (std::size_t i = 0; i < walk.cells.size(); ++i) cells.push_back(cell_json(model, i));
  json["steps"] = std::move(steps);
  json["cells"] = std::move(cells);
  return json;
}

void write_walk_vtp(const std::filesystem::path& path, const WalkModel& model, std::size_t step) {
  OutputFile file(path);
  const auto states = states_at(model.walk, step);
  const auto surfaces = cell_surfaces(come_across(model, step).cells);
  auto* nodes = vtkUnsignedIntArray::SafeDownCast(surfaces->GetCellData()->GetArray("node"));
  auto state = vtkSmartPointer<vtkUnsignedIntArray>::New();
  state->SetName("state");
  for (vtkIdType i = 0; i < nodes->GetNumberOfTuples(); ++i) {
    state->InsertNextValue(static_cast<unsigned>(states[model.walk.cell_of(nodes->GetValue(i))]));
  }
  surfaces->GetCellData()->AddArray(state);
  auto writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
  writer->SetInputData(surfaces);
  writer->SetFileName(file.temporary().c_str());
  if (!writer->Write() || writer->GetErrorCode() != 0) {
    throw std::runtime_error(path.string() + ": cannot be written");
  }
  file.commit();
}

void write_walk_gltf(const std::filesystem::path& path, const WalkModel& model, std::size_t step) {
  const auto states = states_at(model.walk, step);
  if (states.empty()) throw std::runtime_error("the ray meets no cell: there is nothing to write");
  std::vector<ColoredLines> lines;
  for (std::size_t state = 0; state < state_names.size(); ++state) {
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < states.size(); ++i) {
      const bool is_shown = states[i] != CellState::unseen && static_cast<std::size_t>(states[i]) == state;
      if (is_shown) cells.push_back(model.walk.cells[i].cell);
    }
    if (!cells.empty()) lines.push_back({cell_outlines(cells), color_of(static_cast<CellState>(state))});
  }
  const Ray<double> ray = to_double(model.walk.ray);
  const Stretch shown = shown_stretch(model.tracer->mesh().bounds(), model.walk.ray);
  const Vec3d from = ray.at(shown.from), to = ray.at(shown.to);
  auto ends = vtkSmartPointer<vtkPoints>::New();
  ends->InsertNextPoint(&from[0]);
  ends->InsertNextPoint(&to[0]);
  auto segment = vtkSmartPointer<vtkCellArray>::New();
  const vtkIdType both[] = {0, 1};
  segment->InsertNextCell(2, both);
  auto way = vtkSmartPointer<vtkPolyData>::New();
  way->SetPoints(ends);
  way->SetLines(segment);
  lines.push_back({way, ink});
  write_gltf(path, model.tracer->mesh(), lines);
}

}  // namespace sightline::viz
