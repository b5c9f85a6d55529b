#pragma once
/// Volumes against directions and one another.

#include "sightline/math/aabb.h"
#include "sightline/math/interval.h"
#include "sightline/math/volumes.h"

namespace sightline {

/// Holds normal . (p - from) over the points p of a volume, in real arithmetic, of a normal of unit length but for
/// rounding: 2^-42 of the distance to the volume's far side wider at each end. Empty of nothing.
Interval<double> extent_along(const Aabb& box, const Vec3d& normal, const Vec3d& from);
Interval<double> extent_along(const Sphere& sphere, const Vec3d& normal, const Vec3d& from);
Interval<double> extent_along(const Cylinder& cylinder, const Vec3d& normal, const Vec3d& from);

/// The volume along x, y or z.
Interval<double> extent_along(const Aabb& box, int axis);
Interval<double> extent_along(const Sphere& sphere, int axis);
Interval<double> extent_along(const Cylinder& cylinder, int axis);

/// False only where no point lies in both. Exact for boxes; balls and cylinders that pass by at 2^-40 of their distance
/// may be taken to meet, and so may cylinders that no plane across one of six directions parts: the two axes, the line
/// between the centers, its parts across each axis, and what is at right angles to both axes.
bool may_overlap(const Aabb& a, const Aabb& b);
bool may_overlap(const Sphere& a, const Sphere& b);
bool may_overlap(const Cylinder& a, const Cylinder& b);

}  // namespace sightline
