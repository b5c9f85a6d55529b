#pragma once
/// Where a ray enters and leaves a solid.

#include <cstdint>
#include <limits>
#include <span>

#include "sightline/csg/small_stack.h"

namespace sightline {

/// A ray's passage through a face of a primitive.
struct Boundary {
  double t = 0;
  double radius = 0;            ///< |exact - t| is at most this; 0 at level fast, which takes t as it is.
  std::uint32_t primitive = 0;  ///< Of the solid.
  std::uint32_t face = 0;       ///< Of the primitive.
  std::uint8_t root = 0;        ///< Which of the distinct real roots of the face's polynomial along the ray, from 0.
  bool is_flipped = false;      ///< The solid's outward normal is opposite to the primitive's.
};

/// The boundaries of a solid along a whole line, from -infinity to infinity, as part of a SpanStack.
///   L1  Each is truly after the one before: no span is empty, no two abut. So they enter and leave in turn.
struct SpanList {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool begins_inside = false;  ///< At -infinity.

  bool is_empty() const { return count == 0 && !begins_inside; }
  /// Everywhere.
  bool is_all() const { return count == 0 && begins_inside; }
};

/// Holds the lists of a solid's operands while they are combined: each follows the one before.
class SpanStack : public SmallStack<Boundary, 48> {
 public:
  using SmallStack::operator[];
  std::span<const Boundary> operator[](const SpanList& list) const { return part(list.first, list.count); }
};

/// Calls see(lo, hi, entering boundary or nullptr, leaving one or nullptr) for each interval of a list, which may reach
/// to an infinity.
template <class See>
void for_each_span(std::span<const Boundary> boundaries, bool begins_inside, See&& see) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Boundary* enter = nullptr;
  bool is_inside = begins_inside;
  for (const Boundary& boundary : boundaries) {
    if (is_inside) see(enter ? enter->t : -infinity, boundary.t, enter, &boundary);
    enter = &boundary;
    is_inside = !is_inside;
  }
  if (is_inside) see(enter ? enter->t : -infinity, infinity, enter, nullptr);
}

}  // namespace sightline
