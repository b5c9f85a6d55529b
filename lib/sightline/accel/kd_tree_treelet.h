#pragma once
/// How a kd-tree's nodes lie in memory: three levels of splits in one cache line, tested at once.
///
/// Grouping the levels of a binary tree by cache lines is Havran's "Cache sensitive representation for the BSP tree",
/// 1997; testing all children of a wide node at once with vector instructions is from Wald, Benthin and Boulos,
/// "Getting rid of packets", 2008.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "sightline/accel/probe.h"

namespace sightline::detail {

inline constexpr int kd_depth_limit = 64;  ///< Of splits along a path.

/// What a treelet's child is: nothing (an empty cell), another treelet, or a leaf.
class KdChild {
 public:
  static constexpr std::uint32_t treelet_limit = 1u << 27;   ///< 16 cells of each are numbered below a leaf's number.
  static constexpr std::uint32_t position_limit = 1u << 26;  ///< Of leaf positions.
  static constexpr std::uint32_t count_limit = 31;           ///< Of one child's candidates.

  KdChild() = default;  // left uninitialized on purpose: stacks are not worth clearing
  static KdChild none() { return KdChild(0); }
  static KdChild treelet(std::uint32_t index) { return KdChild(index); }
  static KdChild leaf(LeafRange range) {
    return range.count == 0 ? none() : KdChild(leaf_tag | range.count << 26 | range.first);
  }

  bool is_empty() const { return bits_ == 0; }
  bool is_leaf() const { return (bits_ & leaf_tag) != 0; }
  std::uint32_t treelet() const { return bits_; }  ///< Never 0, which is the root.
  LeafRange range() const { return {bits_ & (position_limit - 1), bits_ >> 26 & count_limit}; }

 private:
  static constexpr std::uint32_t leaf_tag = 1u << 31;
  explicit KdChild(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits_;
};

/// Up to seven splits, as a heap: the halves of plane p below and above are planes 2 p + 1 and 2 p + 2, or children
/// 2 p - 6 and 2 p - 5 from p = 3 on.
struct alignas(64) KdTreelet {
  static constexpr int levels = 3, width = 8, plane_count = width - 1;
  /// Everything is below an infinite plane, so that a child reached by fewer splits is the lowest of its subtree; a
  /// plane of NaN lets every ray into both halves.
  std::array<float, plane_count> planes;
  std::uint32_t axes;  ///< Two bits a plane from bit 0, and a bit a plane along y from bit 16, along z from bit 24.
  std::array<KdChild, width> children;

  void set_axis(int plane, int axis) {
    axes |= static_cast<std::uint32_t>(axis) << (2 * plane);
    if (axis > 0) axes |= 1u << (8 + 8 * axis + plane);
  }
  bool is_split(int plane) const { return planes[plane] != std::numeric_limits<float>::infinity(); }
  static int below(int plane) { return 2 * plane + 1; }
  static int above(int plane) { return 2 * plane + 2; }
  int axis(int plane) const { return static_cast<int>(axes >> (2 * plane) & 3); }
};
static_assert(sizeof(KdTreelet) == 64);

/// Children that wait, the next one last. A whole vector is written at a time, which may run over the last by seven.
/// On a path each split of the binary tree leaves at most four children of its treelet behind, and each treelet of a
/// large leaf, of which a path has at most nine, leaves seven.
template <class T>
struct KdStack {
  static constexpr std::size_t capacity = 4 * kd_depth_limit + 7 * 9 + 1;

  std::size_t size = 0;
  std::array<KdChild, capacity + KdTreelet::width> children;
  std::array<T, capacity + KdTreelet::width> enters, leaves;  ///< Where the ray is in the child's cell.
};

struct alignas(8) KdOrder : std::array<std::uint8_t, 8> {};

/// Children of a treelet in the order in which a ray meets their cells, farthest first, for each set of planes along
/// whose axes the direction is negative.
inline constexpr auto kd_orders = [] {
  std::array<KdOrder, 128> orders{};
  for (unsigned negative = 0; negative < 128; ++negative) {
    for (unsigned lane = 0; lane < 8; ++lane) {
      unsigned plane = 0;
      for (int level = 2; level >= 0; --level) {
        const unsigned is_far = ~lane >> level & 1;
        plane = 2 * plane + 1 + (is_far ^ (negative >> plane & 1));
      }
      orders[negative][lane] = static_cast<std::uint8_t>(plane - 7);
    }
  }
  return orders;
}();

}  // namespace sightline::detail
