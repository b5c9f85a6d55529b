#include "viz/cell_export.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkGLTFExporter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkXMLPolyDataWriter.h>

#include <map>
#include <stdexcept>

#include "sightline/io/output_file.h"
#include "viz/cell_geometry.h"
#include "viz/coloring.h"
#include "viz/space_actor.h"

namespace sightline::viz {
namespace {

template <class T>
using New = vtkSmartPointer<T>;

}  // namespace

void write_vtp(const std::filesystem::path& path, const Partition& partition) {
  OutputFile file(path);
  auto writer = New<vtkXMLPolyDataWriter>::New();
  writer->SetInputData(cell_surfaces(partition.cells));
  writer->SetFileName(file.temporary().c_str());
  if (!writer->Write() || writer->GetErrorCode() != 0) {
    throw std::runtime_error(path.string() + ": cannot be written");
  }
  file.commit();
}

void write_gltf(const std::filesystem::path& path, const TriangleMesh& mesh, std::span<const ColoredLines> lines) {
  OutputFile file(path);
  auto renderer = New<vtkRenderer>::New();
  add_actor(*renderer, mesh_surface(mesh), {0.84, 0.83, 0.81});
  for (const ColoredLines& each : lines) {
    each.lines->GetCellData()->Initialize();  // the format has no place for it
    add_actor(*renderer, each.lines, each.color);
  }
  // The exporter reads the scene from a window, which is made but never opened.
  auto window = New<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->AddRenderer(renderer);
  renderer->SetActiveCamera(New<vtkCamera>::New());
  auto exporter = New<vtkGLTFExporter>::New();
  exporter->SetRenderWindow(window);
  exporter->InlineDataOn();
  exporter->SetFileName(file.temporary().c_str());
  exporter->Write();
  file.commit();
}

void write_gltf(const std::filesystem::path& path, const Partition& partition, const TriangleMesh& mesh) {
  const Coloring coloring(partition);
  std::map<int, std::vector<Cell>> levels;
  for (const Cell& cell : partition.cells) levels[coloring.level_of(cell)].push_back(cell);
  std::vector<ColoredLines> lines;
  for (const auto& [level, cells] : levels) lines.push_back({cell_outlines(cells), coloring.color(level)});
  write_gltf(path, mesh, lines);
}

}  // namespace sightline::viz
