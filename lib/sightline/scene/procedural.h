#pragma once
/// Scenes made by a rule, each with something in it that a structure may stumble over. The same numbers come out on
/// every machine: only +, -, *, / and square roots are used, and math/random.h.

#include "sightline/shape/mesh.h"

namespace sightline {

/// Small triangles anywhere in the unit cube, each about as large as the room that it has.
TriangleMesh make_soup(int triangles);

/// Long thin triangles side by side, like straws in a bale cut to the unit cube: they go from face to face, at 45
/// degrees to z and, seen along z, at 45 degrees to x and y. On average they are 0.87 long and 0.007 wide, and a
/// stick's box takes up a sixth of the cube: of 50,000 boxes 20,000 contain the middle, and no hierarchy of boxes parts
/// them. Small cells do, at the price of many references; planes along the sticks do at the price of none. The camera
/// and the lamp of the benchmarks see the sticks from the side, and gaps are few, so that rays end soon: what is
/// measured is how well a structure finds the few triangles around a point.
TriangleMesh make_sticks(int triangles);

/// A landscape of cells * cells quads over the unit square, rough at all scales. y is up.
TriangleMesh make_terrain(int cells);

/// Random triangles with corners at whole numbers from 0 to 16: many share planes, edges and corners, some have no
/// area.
TriangleMesh make_integers(int triangles);

/// Overlapping triangles in the plane z = 0, so that all boxes are flat and every ray across them has ties.
TriangleMesh make_flat(int triangles);

/// One triangle `triangles` times: nothing can tell them apart but their ids.
TriangleMesh make_copies(int triangles);

/// Karl Menger's sponge of 1926: only the 2 * 20^level + 4 * 8^level squares of its surface, two triangles each.
TriangleMesh make_menger(int level);

/// Eric Haines's sphere flake ("A Proposal for Standard Graphics Environments", 1987): nine spheres of a third of the
/// size around each sphere, `levels` times; each sphere an octahedron of 8 * 4^2 triangles.
TriangleMesh make_sphere_flake(int levels);

}  // namespace sightline
