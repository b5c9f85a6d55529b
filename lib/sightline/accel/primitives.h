#pragma once
/// What building sees of the primitives, whatever they are: triangles, analytic shapes, solids, instances.

#include <array>
#include <cstddef>
#include <cstdint>

#include "sightline/math/aabb.h"
#include "sightline/math/hull.h"
#include "sightline/math/volumes.h"

namespace sightline {

/// Virtual, because it is called while building only; traversal never sees a primitive.
/// All boxes contain what they bound: they are rounded outward.
class Primitives {
 public:
  virtual ~Primitives() = default;

  virtual std::uint32_t size() const = 0;

  /// Finite bounds of primitive `id`.
  virtual Aabb bounds(std::uint32_t id) const = 0;

  /// Bounds of the part of primitive `id` within `box`; empty where they are apart.
  virtual Aabb clip(std::uint32_t id, const Aabb& box) const = 0;

  /// Points in whose convex hull the primitive lies.
  virtual Hull hull(std::uint32_t id) const = 0;

  /// Planes worth considering as splits (a polygon's own plane first, then the planes through its edges).
  virtual CandidatePlanes planes(std::uint32_t id) const = 0;
};

}  // namespace sightline
