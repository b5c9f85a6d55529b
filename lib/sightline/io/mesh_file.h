#pragma once

#include <filesystem>

#include "sightline/shape/mesh.h"

namespace sightline {

/// Reads a mesh in OBJ, PLY, STL, OFF, glTF 2 or GLB through Assimp. All meshes of the file are joined, moved to where
/// the file's nodes place them; polygons are cut into triangles; triangles keep the file's order, those without area
/// included; points and lines are left out. Vertices that the format repeats for each triangle (OBJ, STL) are joined
/// where they are equal bit for bit.
///
/// Assimp neither refuses nor survives every broken file, so mesh_check.h goes first. Throws FileError: no file, a
/// folder, empty, cut off, an unknown extension, a vertex that is NaN or infinite as a float, an index out of range, no
/// triangle, or counts larger than the file could hold.
TriangleMesh read_mesh(const std::filesystem::path& path);

}  // namespace sightline
