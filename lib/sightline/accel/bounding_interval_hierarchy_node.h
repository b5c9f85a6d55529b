#pragma once

#include <atomic>
#include <cstdint>

#include "sightline/accel/probe.h"

namespace sightline::detail {

/// A node of a bounding interval hierarchy: a slab that holds all below it, and two clip planes. A leaf's clip planes
/// are the ends of a second slab, so that rays meet them as they meet those of an inner node.
/// Once there, a node of a lazy tree changes from unmade through being_made to what it is in an eager tree. Whoever
/// finds it made, by an acquiring read of the link, sees its planes, its children and its part of the leaf order as
/// well, since the link is written last and with release.
struct BihNode {
  enum State : std::uint32_t { inner, leaf, unmade, being_made };
  static constexpr int state_bits = 2;
  static constexpr int axis_bits = 2;
  static constexpr std::uint32_t most_primitives = 1u << 28;  ///< A leaf's count has 28 bits, numbers have 30.

  std::uint32_t link;   ///< State and, above it, the pair of children, a leaf's first position, or the task put aside.
  std::uint32_t shape;  ///< Axis of the slab, axis of the clip planes and, above them, a leaf's count.
  float slab[2];        ///< Lowest and highest point of all.
  float clip[2];        ///< Highest point of the child below, lowest of the child above.

  static std::uint32_t link_of(State state, std::size_t number) {
    return static_cast<std::uint32_t>(number << state_bits) | state;
  }
  static State state_of(std::uint32_t link) { return static_cast<State>(link & ((1u << state_bits) - 1)); }
  static bool is_made(std::uint32_t link) { return state_of(link) <= leaf; }
  static std::uint32_t number_of(std::uint32_t link) { return link >> state_bits; }
  static std::uint32_t link_in(const BihNode& node) {
    return std::atomic_ref(const_cast<BihNode&>(node).link).load(std::memory_order_acquire);
  }

  static std::uint32_t shape_of(int slab_axis, int clip_axis, std::uint32_t count) {
    return count << 2 * axis_bits | static_cast<std::uint32_t>(clip_axis << axis_bits | slab_axis);
  }
  std::uint32_t slab_axis() const { return shape & 3; }
  std::uint32_t clip_axis() const { return shape >> axis_bits & 3; }

  LeafRange leaf_range(std::uint32_t its_link) const { return {number_of(its_link), shape >> 2 * axis_bits}; }
};

}  // namespace sightline::detail
