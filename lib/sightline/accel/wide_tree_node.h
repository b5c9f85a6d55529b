#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sightline/accel/probe.h"
#include "sightline/math/aabb.h"
#include "sightline/math/simd.h"

namespace sightline {

/// How a node of a wide tree names a child. Where there is none, its box is empty, so that no ray meets it, unless the
/// direction is too small to invert on all axes.
class WideLink {
 public:
  static constexpr std::uint32_t limit = std::uint32_t{1} << 28;  ///< Of nodes and of positions.

  static constexpr std::uint32_t none = 15;

  static std::uint32_t to_node(std::uint32_t index) { return index << 4; }
  static std::uint32_t to_leaf(LeafRange range) { return range.first << 4 | range.count; }
  static bool is_leaf(std::uint32_t link) { return link & 15; }
  static std::uint32_t node(std::uint32_t link) { return link >> 4; }
  static LeafRange leaf(std::uint32_t link) { return {link >> 4, link & 15}; }
  /// By which probes and cells name it: a node's place, a leaf's first position counted on from the last node.
  static std::uint32_t number(std::uint32_t link, std::size_t nodes) {
    return node(link) + (is_leaf(link) ? static_cast<std::uint32_t>(nodes) : 0);
  }
};

/// A node of a wide tree: the boxes of its children, plane by plane. Traversal needs of a node its links, order, rows
/// and boxes.
struct alignas(64) WideNode {
  static constexpr int width = 8;
  static constexpr bool may_meet_none = false;  ///< Whether the rows of a child that is none may seem to be met.

  std::array<float, 6 * width> planes;  ///< Of all children: low x, y, z, high x, y, z.
  std::array<std::uint32_t, width> links;
  /// For each octant of directions (a bit is set where a component is negative) the children, those farther along
  /// first: three bits each.
  std::array<std::uint32_t, 8> orders;

  /// Where the low or the high planes of an axis begin.
  static constexpr std::uint32_t row_at(int axis, bool is_high) {
    return static_cast<std::uint32_t>((axis + 3 * is_high) * width);
  }
  /// One plane of each child, those that begin at row_at(axis, ...).
  template <class D>
  [[gnu::always_inline]] hn::Vec<D> row(D d, [[maybe_unused]] int axis, std::uint32_t at) const {
    return hn::Load(d, planes.data() + at);
  }
  /// The children as their octant has them; what stands above the 24 bits is not specified.
  std::uint32_t order(std::uint32_t octant) const { return orders[octant]; }

  float plane(int index, int child) const { return planes[static_cast<std::size_t>(index * width + child)]; }
  Aabb box(int child) const {
    return {{plane(0, child), plane(1, child), plane(2, child)}, {plane(3, child), plane(4, child), plane(5, child)}};
  }
  Aabb bounds() const {
    Aabb all;
    for (int child = 0; child < width; ++child) all.extend(box(child));
    return all;
  }
  void set(int child, const Aabb& box, std::uint32_t link) {
    links[child] = link;
    set_box(child, box);
  }
  void set_boxes(const std::array<Aabb, width>& boxes) {
    for (int child = 0; child < width; ++child) set_box(child, boxes[static_cast<std::size_t>(child)]);
  }
  void set_box(int child, const Aabb& box) {
    for (int axis = 0; axis < 3; ++axis) {
      planes[static_cast<std::size_t>(axis * width + child)] = box.lo[axis];
      planes[static_cast<std::size_t>((axis + 3) * width + child)] = box.hi[axis];
    }
  }
};
static_assert(sizeof(WideNode) == 256);

}  // namespace sightline
