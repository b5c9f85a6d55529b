#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "sightline/accel/wide_tree_node.h"
#include "sightline/math/interval.h"

namespace sightline {

/// A node of a wide tree in two cache lines instead of four: its planes are whole numbers of steps from its lowest.
///   N1  A decoded box holds the one it was made of: numbers are chosen by what decoding makes of them.
///   N2  Decoding gives the same everywhere: a step has sixteen significant bits and no denormals, so its product with
///       eight more is exact and the sum alone is rounded. (Products overflow where a node is longer than the largest
///       float, but vectors are for ordinary rays: S3.)
/// Mahovsky, "Ray Tracing with Reduced-Precision Bounding Volume Hierarchies", 2005; Ylitie, Karras and Laine,
/// "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", 2017.
struct alignas(64) CompressedWideNode {
  static constexpr int width = WideNode::width;
  static constexpr bool may_meet_none = true;

  std::array<std::uint8_t, 6 * width> planes;  ///< As WideNode's.
  std::array<std::uint8_t, 3 * 8> orders;      ///< WideNode's, three bytes each, lowest first.
  std::array<float, 3> base;
  std::array<float, 3> step;
  std::array<std::uint32_t, width> links;

  static CompressedWideNode of(const WideNode& node) {
    CompressedWideNode made;
    made.links = node.links;
    for (std::size_t octant = 0; octant < 8; ++octant) {
      for (std::size_t byte = 0; byte < 3; ++byte) {
        made.orders[3 * octant + byte] = static_cast<std::uint8_t>(node.orders[octant] >> (8 * byte));
      }
    }
    for (int axis = 0; axis < 3; ++axis) made.compress(node, axis);
    return made;
  }

  void set_boxes(const std::array<Aabb, width>& boxes) {
    WideNode node;
    node.set_boxes(boxes);
    for (int axis = 0; axis < 3; ++axis) compress(node, axis);
  }
  Aabb bounds() const {
    Aabb all;
    for (int child = 0; child < width; ++child) all.extend(box(child));
    return all;
  }

  static constexpr std::uint32_t row_at(int axis, bool is_high) { return WideNode::row_at(axis, is_high); }
  template <class D>
  [[gnu::always_inline]] hn::Vec<D> row(D d, int axis, std::uint32_t at) const {
    const hn::Rebind<std::uint8_t, D> bytes;
    const hn::Rebind<std::int32_t, D> whole;
    const auto steps = hn::ConvertTo(d, hn::PromoteTo(whole, hn::Load(bytes, planes.data() + at)));
    return hn::MulAdd(steps, hn::Set(d, step[axis]), hn::Set(d, base[axis]));
  }
  std::uint32_t order(std::uint32_t octant) const {
    std::uint32_t order;  // with a byte of what follows
    std::memcpy(&order, reinterpret_cast<const char*>(this) + offsetof(CompressedWideNode, orders) + 3 * octant, 4);
    return order;
  }

  float plane(int index, int child) const { return decoded(index % 3, planes[index * width + child]); }
  Aabb box(int child) const {
    if (links[child] == WideLink::none) return {};
    return {{plane(0, child), plane(1, child), plane(2, child)}, {plane(3, child), plane(4, child), plane(5, child)}};
  }

 private:
  static constexpr int most = std::numeric_limits<std::uint8_t>::max();

  /// So many steps from the base, rounded once: N2.
  float decoded(int axis, int steps) const { return base[axis] + step[axis] * static_cast<float>(steps); }

  void compress(const WideNode& node, int axis) {
    const auto is_child = [&](int child) { return links[child] != WideLink::none; };
    Interval<float> range;
    for (int child = 0; child < width; ++child) {
      if (!is_child(child)) continue;
      range.lo = std::min(range.lo, node.plane(axis, child));
      range.hi = std::max(range.hi, node.plane(axis + 3, child));
    }
    base[axis] = range.lo;
    step[axis] = shortest_step((double(range.hi) - double(range.lo)) / most);
    while (decoded(axis, most) < range.hi) step[axis] = longer_step(step[axis]);
    for (int child = 0; child < width; ++child) {
      std::uint8_t& low = planes[row_at(axis, false) + child];
      std::uint8_t& high = planes[row_at(axis, true) + child];
      low = is_child(child) ? steps_to_low(axis, node.plane(axis, child)) : most;
      high = is_child(child) ? steps_to_high(axis, node.plane(axis + 3, child)) : 0;
    }
  }

  /// Steps have the lowest eight bits of their mantissa clear.
  static float shortest_step(double length) {
    const float step = std::max(static_cast<float>(length), std::numeric_limits<float>::min());
    return std::bit_cast<float>((std::bit_cast<std::uint32_t>(step) + 0xff) & ~std::uint32_t{0xff});
  }
  static float longer_step(float step) { return std::bit_cast<float>(std::bit_cast<std::uint32_t>(step) + 0x100); }

  /// As many as reach no farther than a plane; N1 and the number of the base itself end the search.
  std::uint8_t steps_to_low(int axis, float plane) const {
    int steps = std::min(static_cast<int>((double(plane) - double(base[axis])) / double(step[axis])), most);
    while (decoded(axis, steps) > plane) --steps;
    return static_cast<std::uint8_t>(steps);
  }
  std::uint8_t steps_to_high(int axis, float plane) const {
    int steps = std::min(static_cast<int>((double(plane) - double(base[axis])) / double(step[axis])), most);
    while (decoded(axis, steps) < plane) ++steps;
    return static_cast<std::uint8_t>(steps);
  }
};
static_assert(sizeof(CompressedWideNode) == 128);

}  // namespace sightline
