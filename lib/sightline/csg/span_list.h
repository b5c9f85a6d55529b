#pragma once
/// Where a ray enters and leaves a solid.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sightline/math/interval.h"

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

/// Holds the lists of a solid's operands while they are combined: each follows the one before. Short stacks take no
/// memory from the heap.
class SpanStack {
 public:
  SpanStack() = default;
  SpanStack(const SpanStack&) = delete;
  SpanStack& operator=(const SpanStack&) = delete;

  std::uint32_t size() const { return size_; }
  Boundary& operator[](std::uint32_t i) { return data_[i]; }
  const Boundary& operator[](std::uint32_t i) const { return data_[i]; }
  std::span<const Boundary> operator[](const SpanList& list) const { return {data_ + list.first, list.count}; }

  void push(const Boundary& boundary) {
    if (size_ == capacity_) grow();
    data_[size_++] = boundary;
  }
  void truncate(std::uint32_t size) { size_ = size; }

  /// Removes the boundaries in [first, last); those behind move up.
  void erase(std::uint32_t first, std::uint32_t last) {
    std::copy(data_ + last, data_ + size_, data_ + first);
    size_ -= last - first;
  }

 private:
  void grow() {
    std::vector<Boundary> larger(2 * static_cast<std::size_t>(capacity_));
    std::copy(data_, data_ + size_, larger.data());
    heap_ = std::move(larger);
    data_ = heap_.data();
    capacity_ *= 2;
  }

  static constexpr std::uint32_t small = 48;
  union Small {
    Small() {}  // left as it is: most queries write a few
    std::array<Boundary, small> boundaries;
  } small_;
  std::vector<Boundary> heap_;
  Boundary* data_ = small_.boundaries.data();
  std::uint32_t size_ = 0, capacity_ = small;
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
