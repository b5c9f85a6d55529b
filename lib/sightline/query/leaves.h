#pragma once
/// Where queries find the shapes that leaf positions stand for.

#include <cstdint>
#include <span>
#include <vector>

#include "sightline/shape/shapes.h"

namespace sightline {

/// Copies of the shapes in leaf order, so that a leaf reads consecutive memory. Made once for structures whose leaf
/// order is final; made outside the structure, so that every structure shares it.
template <Shapes S>
class PackedLeaves {
 public:
  PackedLeaves(const S& shapes, std::span<const std::uint32_t> order) : shapes_(shapes) {
    slots_.reserve(order.size());
    for (const std::uint32_t id : order) slots_.push_back({shapes[id], id});
  }

  typename S::PreparedRay prepare(const Ray<double>& ray) const { return shapes_.prepare(ray); }
  std::uint32_t id(std::uint32_t position) const { return slots_[position].id; }
  const typename S::Shape& shape(std::uint32_t position) const { return slots_[position].shape; }
  std::size_t memory_bytes() const { return slots_.size() * sizeof(Slot); }

 private:
  struct Slot {
    typename S::Shape shape;
    std::uint32_t id;
  };
  const S& shapes_;
  std::vector<Slot> slots_;
};

/// The shapes where they are, found through the structure's leaf order: for structures that still rearrange it, and
/// where memory counts more than time.
template <Shapes S>
class IndexedLeaves {
 public:
  IndexedLeaves(const S& shapes, std::span<const std::uint32_t> order) : shapes_(shapes), order_(order) {}

  typename S::PreparedRay prepare(const Ray<double>& ray) const { return shapes_.prepare(ray); }
  std::uint32_t id(std::uint32_t position) const { return order_[position]; }
  typename S::Shape shape(std::uint32_t position) const { return shapes_[order_[position]]; }
  std::size_t memory_bytes() const { return 0; }

 private:
  const S& shapes_;
  std::span<const std::uint32_t> order_;
};

}  // namespace sightline
