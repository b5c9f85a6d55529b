#pragma once

#include <filesystem>

#include "viz/partition.h"

namespace sightline::viz {

/// The surfaces of the cells as VTK XML (.vtp), with their depth, leaf flag, candidates and node as cell data, for
/// ParaView and others. Needs no display.
void write_vtp(const std::filesystem::path& path, const Partition& partition);

/// Mesh and cell outlines, one node a depth, as a single glTF file. Needs no display.
void write_gltf(const std::filesystem::path& path, const Partition& partition, const TriangleMesh& mesh);

}  // namespace sightline::viz
