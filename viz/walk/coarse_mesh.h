#pragma once

#include "sightline/shape/mesh.h"

namespace sightline::viz {

/// At most `most` triangles that look like the mesh from afar: vertices that share a cell of a grid become one, their
/// mean (Rossignac and Borrel, "Multi-resolution 3D approximations for rendering complex scenes", 1993). Where that
/// leaves next to nothing, as of small triangles that share no vertices, every so-manieth triangle. The mesh itself
/// where it is no larger.
TriangleMesh coarse_mesh(const TriangleMesh& mesh, std::size_t most);

}  // namespace sightline::viz
