#pragma once

#include "sightline/math/aabb.h"

namespace sightline {

/// A plane that crosses its axis at `position`; none when the axis is -1.
struct HalvingPlane {
  int axis = -1;
  float position = 0;
};

/// The middle of the longest side that has a float strictly between its ends.
inline HalvingPlane halving_plane(const Aabb& box) {
  const Vec3f center = box.center();
  const Vec3d extent = Vec3d(box.hi) - Vec3d(box.lo);
  int longest = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const bool has_middle = box.lo[axis] < center[axis] && center[axis] < box.hi[axis];
    if (has_middle && (longest < 0 || extent[axis] > extent[longest])) longest = axis;
  }
  return longest < 0 ? HalvingPlane{} : HalvingPlane{longest, center[longest]};
}

/// Halves the candidate box until a plane parts the centers, and drops halves without any on the way. Split planes come
/// from one hierarchy of boxes over the whole scene, never fitted to what they hold, as in Waechter and Keller 2006.
/// No plane when the centers cannot be parted.
/// Ends: a side is below 2^130 and a multiple of 2^-149, so it is halved fewer than 280 times.
inline HalvingPlane halve_until_parted(Aabb& candidate, const Aabb& centers) {
  if (centers.lo == centers.hi) return {};
  for (;;) {
    const HalvingPlane plane = halving_plane(candidate);
    if (plane.axis < 0) return {};
    if (centers.hi[plane.axis] < plane.position) {
      candidate.hi[plane.axis] = plane.position;
    } else if (centers.lo[plane.axis] >= plane.position) {
      candidate.lo[plane.axis] = plane.position;
    } else {
      return plane;
    }
  }
}

}  // namespace sightline
