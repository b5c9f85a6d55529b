#pragma once
/// The Standard Procedural Databases: scenes by which ray tracers have been compared since 1987, each made to any size
/// by a rule. Eric Haines, "A Proposal for Standard Graphics Environments", IEEE Computer Graphics and Applications,
/// 1987, and his programs, version 3.12 of 1998. Numbers, places, cameras, lights and colors are those of his programs;
/// y is up here. Spheres, cylinders and cones are instances of the meshes of round_meshes.h, which are cut as his own
/// programs cut them into polygons. Backgrounds are left out.

#include "sightline/scene/scene.h"

namespace sightline::spd {

/// The sphere flake: around each sphere nine of a third of its size, six around its equator and three above, `levels`
/// times; (9^(levels + 1) - 1) / 8 spheres and a floor. His size is 4.
Scene make_balls(int levels);

/// size^3 meshed gears of 36 teeth, some of glass, on a floor. His size is 4.
Scene make_gears(int size);

/// size layers of dodecahedra made of six pentagonal rings, n^2 in the n-th: 30 cylinders and 30 spheres each, and a
/// wall behind. His size is 7.
Scene make_rings(int size);

/// (size + 1)^3 mirroring spheres in a cube, and rods between neighbors, 3 size (size + 1)^2. By Antonio Costa. His
/// size is 12.
Scene make_lattice(int size);

/// A jack of three rods and six spheres, and half as large in each of its octants another, `levels` deep:
/// (8^levels - 1) / 7 jacks. By Alexander Enzmann. His size is 1.
Scene make_jacks(int levels);

/// A sea shell as a spiral of overlapping spheres, 180 * 2^size + 1 of them. By Clifford Pickover's rule. Haines' size
/// is 5; he counts a sphere less than his program makes.
Scene make_shells(int size);

/// Four tetrahedra in one's corners, `levels` deep: 4^levels triangles. After Benoit Mandelbrot and Alan Norton. His
/// size is 6.
Scene make_tetra(int levels);

/// A bare tree of 2^(levels + 1) - 1 branches, each a cone with a sphere at its end, in a field. By Masaki Aono's and
/// Tosiyasu Kunii's rule. His size is 11.
Scene make_tree(int levels);

/// A fractal mountain of 2 * 4^levels triangles behind four glass spheres. By Loren Carpenter's rule, with the weak
/// hashing of the first edition, which Haines kept for comparisons. Each level refines the one before; he has up to 7,
/// and his size is 6.
Scene make_mountain(int levels);

/// The damped wave 3 cos(2 pi r) exp(-r) over 32 * 2^(size - 1) points a side, two triangles in each cell between them.
/// By Alexander Enzmann. His size is 1.
Scene make_sombrero(int size);

/// The Utah teapot on a checkerboard of as many squares a side as there are segments along its patches:
/// 64 size^2 - 8 size triangles and size^2 squares. His size is 12.
Scene make_teapot_board(int size);

}  // namespace sightline::spd
