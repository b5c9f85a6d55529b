#pragma once
/// What doubles and their bounds could not tell: some hundred bits, then exact algebra. Rarely reached, and so compiled
/// apart.

#include <cmath>

#include "sightline/csg/primitive.h"
#include "sightline/math/level.h"
#include "sightline/math/root_list.h"

namespace sightline {

/// Whether as much is known of t as a level below exact asks for: to a part of itself. Exactly rounded it may not be.
inline bool is_accurate(double t, double radius, Level level) {
  const double share = level == Level::watertight ? 0x1p-46 : 0x1p-52;
  return level == Level::fast || (level != Level::exact && radius <= share * std::fabs(t));
}
inline bool is_accurate(const RootList& list, Level level) {
  if (!list.is_certain) return false;
  for (int i = 0; i < list.count; ++i) {
    const Root& root = list.roots[static_cast<std::size_t>(i)];
    if (!is_accurate(root.t, root.radius, level)) return false;
  }
  return true;
}

/// Roots of a surface's polynomial along a ray: number, order and multiplicities are certain. Each t is as accurate as
/// the level asks for, at level exact correctly rounded.
RootList settled_roots(const Surface& surface, const FramedRay& ray, Level level);

/// One of them, by its place: the others may be known less well.
Root settled_root(const Surface& surface, const FramedRay& ray, Level level, std::uint32_t index);

/// All of a torus, from doubles on: certain of number, order and multiplicities, as for t only of its radius.
RootList certain_roots(const Torus& torus, const FramedRay& ray);
/// The same, as accurate as any level but fast asks for.
RootList accurate_roots(const Torus& torus, const FramedRay& ray, Level level);

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
