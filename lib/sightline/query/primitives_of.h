#pragma once

#include "sightline/accel/primitives.h"
#include "sightline/shape/shapes.h"

namespace sightline {

/// A collection of shapes as builders see it. Refers to the collection, which must live as long.
template <Shapes S>
class PrimitivesOf final : public Primitives {
 public:
  explicit PrimitivesOf(const S& shapes) : shapes_(shapes) {}

  std::uint32_t size() const override { return shapes_.size(); }
  Aabb bounds(std::uint32_t id) const override { return shapes_.bounds(id); }
  Aabb clip(std::uint32_t id, const Aabb& box) const override { return shapes_.clip(id, box); }
  Hull hull(std::uint32_t id) const override { return shapes_.hull(id); }
  CandidatePlanes planes(std::uint32_t id) const override { return shapes_.planes(id); }

 private:
  const S& shapes_;
};

}  // namespace sightline
