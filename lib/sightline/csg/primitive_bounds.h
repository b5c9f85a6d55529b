#pragma once

#include <optional>

#include "sightline/csg/primitive.h"

namespace sightline {

/// A box, rounded outward, that holds a shape in its frame; none for one that has no bounds, and for one that leaves
/// the range of float.
std::optional<Aabb> bounds_of(const SolidShape& shape, const Frame& frame);

/// Throws std::invalid_argument where a shape makes no sense, or a frame cannot be inverted: one line, what was
/// expected and what was found.
void check(const SolidShape& shape);
void check(const Frame& frame);

}  // namespace sightline
