#pragma once
/// Finds the operands that a ray may meet, through any structure of the registry.

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "sightline/csg/small_stack.h"
#include "sightline/math/aabb.h"
#include "sightline/math/ray.h"

namespace sightline {

using OperandList = SmallStack<std::uint32_t, 64>;

class OperandIndex {
 public:
  virtual ~OperandIndex() = default;

  /// Appends the number of each box that the ray may meet within its range, in any order, some more than once.
  virtual void find(const Ray<double>& ray, OperandList& found) const = 0;
};

/// \throws std::invalid_argument for an unknown structure.
std::shared_ptr<const OperandIndex> make_operand_index(std::string_view accelerator, std::span<const Aabb> boxes);

}  // namespace sightline
