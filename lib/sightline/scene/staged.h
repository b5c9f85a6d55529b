#pragma once
/// The teapot in surroundings.

#include "sightline/shape/mesh.h"

namespace sightline {

/// The "teapot in a stadium": much detail in a tiny part of a huge place of few large triangles. `segments` as in
/// make_teapot.
TriangleMesh make_stadium(int segments);

/// A closed room, seen from within, with the teapot on a table and boxes: every ray from inside hits something, and
/// most planes are those of an axis.
TriangleMesh make_room(int segments);

}  // namespace sightline
