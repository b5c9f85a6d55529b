#pragma once
/// Boxes as primitives, for structures over things that have nothing but bounds: operands of solids, instances.

#include <cstdint>
#include <span>

#include "sightline/accel/primitives.h"

namespace sightline {

/// Refers to the boxes.
class BoxPrimitives final : public Primitives {
 public:
  explicit BoxPrimitives(std::span<const Aabb> boxes) : boxes_(boxes) {}

  std::uint32_t size() const override { return static_cast<std::uint32_t>(boxes_.size()); }
  Aabb bounds(std::uint32_t id) const override { return boxes_[id]; }
  Aabb clip(std::uint32_t id, const Aabb& box) const override {
    const Aabb clipped = intersection(boxes_[id], box);
    return clipped.is_empty() ? Aabb{} : clipped;
  }
  Hull hull(std::uint32_t id) const override { return hull_of(boxes_[id]); }
  CandidatePlanes planes(std::uint32_t id) const override { return faces_of(boxes_[id]); }

 private:
  std::span<const Aabb> boxes_;
};

/// Options for things that take much longer to test than a node: small leaves and many cells.
template <class Structure>
typename Structure::Options costly_primitives() {
  typename Structure::Options options;
  if constexpr (requires { options.max_leaf_size; }) options.max_leaf_size = 1;
  if constexpr (requires { options.intersection_cost; }) options.intersection_cost = 2 * options.traversal_cost;
  if constexpr (requires { options.density; }) options.density = 8;
  return options;
}

}  // namespace sightline
