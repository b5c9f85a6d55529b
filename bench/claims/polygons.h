#pragma once
/// A solid as triangles: what CSG has to become where only polygons are drawn.

#include <memory>

#include "sightline/csg/solid_set.h"
#include "sightline/shape/mesh.h"

namespace sightline::bench {

using OneSolid = SolidSet<Level::watertight>;

/// The surface between the points of a lattice that are inside and those that are not, `cells` along the longest side:
/// marching tetrahedra, six to a cell, all round one diagonal (Freudenthal), so that neighbours agree about their
/// faces. Corners lie where a ray along a tetrahedron's edge first meets the surface, exactly on it; what does not part
/// two points of the lattice is lost.
/// Doi and Koide, "An Efficient Method of Triangulating Equi-Valued Surfaces by Using Tetrahedral Cells", 1991.
std::shared_ptr<const TriangleMesh> polygons_of(const OneSolid& solid, int cells);

}  // namespace sightline::bench
