#pragma once
/// Where a ray crosses triangles, and which at the same place.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sightline/shape/facet_line.h"

namespace sightline {

/// A distance, in units of the direction, and the triangles there in the order of their ids.
struct TriangleCrossing {
  double t;
  std::vector<std::uint32_t> triangles;
};

/// All at t >= 0 in ascending order, exactly: FacetLine::crosses says which triangles, those with equal t come together
/// however they are inclined, and t is rounded correctly; two that differ by less than doubles do have equal t here.
/// Indices are below the number of vertices, and those are finite. The surface need not be closed.
std::vector<TriangleCrossing> triangle_crossings(const FramedRay&, std::span<const Vec3d> vertices,
                                                 std::span<const std::array<std::uint32_t, 3>> triangles);

/// The same in float, every number and every decision rounded.
std::vector<TriangleCrossing> rounded_triangle_crossings(const FramedRay&, std::span<const Vec3d> vertices,
                                                         std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace sightline
