#pragma once
/// Which of two boundaries comes first.

#include "sightline/csg/settle.h"
#include "sightline/csg/solid.h"
#include "sightline/csg/span_list.h"

namespace sightline {

/// Coincident faces are found by identity or by exact arithmetic, never by how close they are.
///   O1  Boundaries that are farther apart than what is known of them are in the order of t.
///   O2  Closer ones on the same face, or on faces with the very same numbers, are the same where they are the same
///   root. O3  All others are settled exactly. At level fast, t as computed decides alone.
template <Level level>
class BoundaryOrder {
 public:
  BoundaryOrder(const Solid& solid, const Ray<double>& ray) : solid_(solid), ray_(ray) {}

  /// -1, 0 or 1.
  int operator()(const Boundary& a, const Boundary& b) const {
    const int order = (a.t > b.t) - (a.t < b.t);
    if constexpr (level == Level::fast) return order;
    const double known = (a.radius + b.radius) * (1 + 0x1p-50);
    if (std::fabs(a.t - b.t) * (1 - 0x1p-50) > known) [[likely]]
      return order;  // O1
    return settle(a, b);
  }

 private:
  [[gnu::noinline]] int settle(const Boundary& a, const Boundary& b) const {
    const SurfaceRoot root_a = root_of(a), root_b = root_of(b);
    const auto frame = [&](const Boundary& boundary) { return solid_.primitives()[boundary.primitive].frame; };
    if (frame(a) == frame(b) && is_same(root_a.surface, root_b.surface))
      return (a.root > b.root) - (a.root < b.root);  // O2
    return settled_order(root_a, root_b);            // O3
  }

  SurfaceRoot root_of(const Boundary& boundary) const {
    const Primitive& primitive = solid_.primitives()[boundary.primitive];
    return {surface_of(primitive.shape, boundary.face), FramedRay(ray_, solid_.frame_of(primitive)),
            static_cast<int>(boundary.root)};
  }

  const Solid& solid_;
  const Ray<double>& ray_;
};

}  // namespace sightline
