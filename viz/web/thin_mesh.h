#pragma once
/// A mesh light enough for a page.

#include <string>
#include <vector>

#include "sightline/shape/mesh.h"

namespace sightline::viz {

struct ThinMesh {
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> triangles;
  std::string note;  ///< What was left out; empty where everything is there.
};

/// No more than `most` triangles: of larger meshes vertices are merged by the cells of a grid (vtkQuadricClustering,
/// after Lindstrom, "Out-of-core simplification of large polygonal models", 2000), the finest that gives so few.
ThinMesh thin_mesh(const TriangleMesh& mesh, std::size_t most);

}  // namespace sightline::viz
