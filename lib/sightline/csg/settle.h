#pragma once
/// What doubles and their bounds could not tell: some hundred bits, then exact algebra. Rarely reached, and so compiled
/// apart.

#include "sightline/csg/primitive.h"
#include "sightline/math/level.h"
#include "sightline/math/root_list.h"

namespace sightline {

/// Roots of a surface's polynomial along a ray: number, order and multiplicities are certain. At level exact each t is
/// correctly rounded.
RootList settled_roots(const Surface& surface, const FramedRay& ray, Level level);

/// The same of a torus, from doubles on, at any level but fast.
RootList certain_roots(const Torus& torus, const FramedRay& ray, Level level);

/// A root of a surface's polynomial along a ray, by its place among the distinct real ones.
struct SurfaceRoot {
  Surface surface;
  FramedRay ray;
  int root;
};

/// -1, 0 or 1 as the first one's t is below, at or above the second one's, exactly.
int settled_order(const SurfaceRoot& a, const SurfaceRoot& b);

/// The same with a number.
int settled_order(const SurfaceRoot& a, double t);

/// The double nearest to the root.
double nearest_root(const SurfaceRoot& root);

}  // namespace sightline
