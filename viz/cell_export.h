#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <span>

#include "viz/color_ramp.h"
#include "viz/partition.h"

namespace sightline::viz {

/// The surfaces of the cells as VTK XML (.vtp), with their depth, leaf flag, candidates and node as cell data, for
/// ParaView and others. Needs no display.
void write_vtp(const std::filesystem::path& path, const Partition& partition);

/// Lines of one color.
struct ColoredLines {
  vtkSmartPointer<vtkPolyData> lines;
  Rgb color;
};
/// Mesh and lines, one node each, as a single glTF file. Needs no display.
void write_gltf(const std::filesystem::path& path, const TriangleMesh& mesh, std::span<const ColoredLines> lines);
/// Mesh and cell outlines, one node a depth, as a single glTF file. Needs no display.
void write_gltf(const std::filesystem::path& path, const Partition& partition, const TriangleMesh& mesh);

}  // namespace sightline::viz
