#pragma once

#include "sightline/shape/mesh.h"

namespace sightline {

/// The Utah teapot, modelled by Martin Newell in 1975: 32 bicubic Bezier patches (the four of the bottom added later),
/// each cut into segments * segments quads of two triangles. y is up; it stands on y = 0, 3.15 high, its spout toward
/// +x. Vertices on borders that patches share are shared, triangles that shrink to a line at the poles are left out,
/// and all face outward: 64 * segments^2 - 8 * segments triangles. `segments` is at least 1.
TriangleMesh make_teapot(int segments);

}  // namespace sightline
