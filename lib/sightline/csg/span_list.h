#pragma once
/// Where a ray enters and leaves a solid.

#include <cstdint>
#include <limits>
#include <span>

#include "sightline/csg/small_stack.h"

namespace sightline {

/// A ray's passage through a face of a primitive. What was just stored in parts cannot be loaded as a whole until it
/// has reached the cache; so this is copied by the parts that it is made of.
struct Boundary {
  double t = 0;
  double radius = 0;            ///< |exact - t| is at most this; 0 at level fast, which takes t as it is.
  std::uint32_t primitive = 0;  ///< Of the solid.
  std::uint32_t face = 0;       ///< Of the primitive.
  std::uint32_t root = 0;       ///< Which of the distinct real roots of the face's polynomial along the ray, from 0.
  bool is_flipped = false;      ///< The solid's outward normal is opposite to the primitive's.

  Boundary() = default;
  Boundary(double its_t, double its_radius, std::uint32_t its_primitive, std::uint32_t its_face, std::uint32_t its_root)
      : t(its_t), radius(its_radius), primitive(its_primitive), face(its_face), root(its_root) {}
  Boundary(const Boundary& b)
      : t(b.t), radius(b.radius), primitive(b.primitive), face(b.face), root(b.root), is_flipped(b.is_flipped) {}
  Boundary& operator=(const Boundary& b) {
    t = b.t, radius = b.radius, primitive = b.primitive, face = b.face, root = b.root, is_flipped = b.is_flipped;
    return *this;
  }
};

/// The boundaries of a solid along a whole line, from -infinity to infinity, as part of a SpanStack.
///   L1  Each is truly after the one before: no span is empty, no two abut. So they enter and leave in turn.
/// One word, so that it is passed in a register.
struct SpanList {
  std::uint64_t first : 32 = 0;
  std::uint64_t count : 31 = 0;
  bool begins_inside : 1 = false;  ///< At -infinity.

  bool is_empty() const { return count == 0 && !begins_inside; }
};
static_assert(sizeof(SpanList) == 8);

/// Holds the lists of a solid's operands while they are combined: each follows the one before.
class SpanStack : public SmallStack<Boundary, 48> {
 public:
  using SmallStack::operator[];
  std::span<const Boundary> operator[](const SpanList& list) const { return {begin() + list.first, list.count}; }
  std::span<Boundary> part(const SpanList& list) { return {begin() + list.first, list.count}; }
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
  if (is_inside) see(enter ? enter->t : -infinity, infinity, enter, static_cast<const Boundary*>(nullptr));
}

}  // namespace sightline
