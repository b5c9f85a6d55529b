#pragma once
/// Noise at one point: first with its axes in lanes, then with the corners of its cell.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

#include "sightline/noise/corner.h"
#include "sightline/noise/ease.h"

namespace sightline {

/// `Corners` is one of corner.h.
template <class T, class Corners, Ease ease>
class PointKernel {
 public:
  static constexpr std::size_t dims = Corners::dims;
  static constexpr std::size_t axes = dims;

  explicit PointKernel(const Corners& corners) : corners_(corners) {
    for (std::size_t a = 0; a < axes; ++a) {
      for (std::uint32_t side = 0; side < 2; ++side) {
        axis_leads_[side][a] = near_bias<T> + side + corners.lattice.lead(a);
      }
    }
  }

  /// Value, and gradient where asked for, at one point. Of coordinates that are infinite or NaN: NaN.
  template <bool has_gradient>
  HWY_INLINE void at(const T* point, T* result) const {
    const Axes d;
    AxisVectors x;
    bool is_near = true;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = loaded(point, i * hn::MaxLanes(d));
      is_near &= hn::AllTrue(d, hn::Lt(hn::Abs(x[i]), hn::Set(d, near_limit<T>)));
    }
    if (HWY_UNLIKELY(!is_near)) return far_at<has_gradient>(point, result);
    of_cell<has_gradient>(near_cell(x), result);
  }

 private:
  template <class V, bool has_gradient>
  using Node = NoiseNode<V, dims, has_gradient>;

  /// The highest bit of a corner's number says where it is along x.
  static constexpr std::size_t corner_count = std::size_t{1} << dims;
  static constexpr bool is_above(std::size_t corner, std::size_t axis) { return corner >> (axes - 1 - axis) & 1; }

  /// A number for each axis, the last of which may be of none.
  static constexpr std::size_t axis_lanes = corner_count / 2;
  template <class N>
  using AxisArray = std::array<N, axis_lanes>;

  using Axes = hn::CappedTag<T, axis_lanes>;
  using AxisVectors = std::array<hn::Vec<Axes>, axis_lanes / hn::MaxLanes(Axes())>;
  using Corner = hn::CappedTag<T, corner_count>;
  static constexpr std::size_t lanes = hn::MaxLanes(Corner());
  static constexpr std::size_t parts = corner_count / lanes;

  /// Along each axis: the ways from the lattice point below and from that above, what their keys give to the hash, and
  /// the eased way with its slope.
  struct Cell {
    static constexpr std::size_t step = hn::MaxLanes(Axes());
    static constexpr std::size_t count = axis_lanes / step;

    std::array<AxisVectors, 2> way;  ///< Below, above.
    std::array<std::array<Keys<Axes>, count>, 2> key;
    AxisVectors s, slope;
  };

  /// One by one: who asks for a point has often just written its coordinates like that, and a processor waits long for
  /// what it then is to read as a whole. The last lane may be any coordinate.
  static HWY_INLINE hn::Vec<Axes> loaded(const T* point, std::size_t first) {
    const Axes d;
    const auto x = hn::Set(d, point[first]);
    if (first + 1 == axes) return x;
    const auto xy = hn::InterleaveLower(d, x, hn::Set(d, point[first + 1]));
    if constexpr (axis_lanes == 2 || hn::MaxLanes(d) == 2) {
      return xy;
    } else {
      return hn::ConcatLowerLower(d, hn::Set(d, point[2]), xy);
    }
  }

  HWY_INLINE void finish(Cell& cell) const {
    const Axes d;
    const KeyTag<Axes> dk;
    for (std::size_t i = 0; i < Cell::count; ++i) {
      cell.s[i] = eased<ease>(d, cell.way[0][i]);
      cell.slope[i] = slope_of_eased<ease>(d, cell.way[0][i], cell.way[1][i]);
      for (auto& key : cell.key) key[i] = corners_.lattice.spread(dk, AxisLanes{i * Cell::step}, key[i]);
    }
  }

  HWY_INLINE Cell near_cell(const AxisVectors& x) const {
    const Axes d;
    const KeyTag<Axes> dk;
    Cell cell;
    for (std::size_t i = 0; i < Cell::count; ++i) {
      const std::size_t first = i * Cell::step;
      const auto below = hn::Floor(x[i]);
      const auto bits = near_bits(d, below);
      cell.way[0][i] = hn::Sub(x[i], below);
      cell.way[1][i] = hn::Sub(x[i], hn::Add(below, hn::Set(d, T(1))));
      for (std::size_t side = 0; side < 2; ++side) {
        cell.key[side][i] = hn::Add(bits, hn::LoadU(dk, axis_leads_[side].data() + first));
      }
    }
    finish(cell);
    return cell;
  }

  /// Coordinates may be of any finite size. Far away lattice points are farther apart than 1 in floating point, and
  /// then only the lower one counts.
  Cell far_cell(const T* point) const {
    const Axes d;
    const KeyTag<Axes> dk;
    alignas(64) std::array<AxisArray<T>, 2> ways{};
    std::array<AxisArray<std::uint32_t>, 2> keys{};
    for (std::size_t a = 0; a < axes; ++a) {
      const T below = std::floor(point[a]);
      for (std::size_t side = 0; side < 2; ++side) {
        ways[side][a] = point[a] - below - static_cast<T>(side);
        keys[side][a] =
            far_key(static_cast<double>(below) + static_cast<double>(side), corners_.lattice.is_periodic()) +
            corners_.lattice.lead(a);
      }
    }
    Cell cell;
    for (std::size_t i = 0; i < Cell::count; ++i) {
      for (std::size_t side = 0; side < 2; ++side) {
        cell.way[side][i] = hn::LoadU(d, ways[side].data() + i * Cell::step);
        cell.key[side][i] = hn::LoadU(dk, keys[side].data() + i * Cell::step);
      }
    }
    finish(cell);
    return cell;
  }

  template <bool has_gradient>
  HWY_NOINLINE void far_at(const T* point, T* result) const {
    for (std::size_t a = 0; a < axes; ++a) {
      if (std::isfinite(point[a])) continue;
      for (std::size_t k = 0; k < (has_gradient ? 1 + axes : 1); ++k) result[k] = std::numeric_limits<T>::quiet_NaN();
      return;
    }
    of_cell<has_gradient>(far_cell(point), result);
  }

  /// For each corner which number of both sides along an axis, first those below, it has.
  template <class N>
  struct Sides {
    alignas(64) std::array<std::array<N, corner_count>, axes> of{};

    constexpr Sides() {
      for (std::size_t a = 0; a < axes; ++a) {
        for (std::size_t c = 0; c < corner_count; ++c) of[a][c] = static_cast<N>(a + (is_above(c, a) ? axis_lanes : 0));
      }
    }
  };
  template <class N>
  static constexpr Sides<N> sides{};

  /// Numbers of one axis, as its corners have them.
  template <class D, class V>
  static HWY_INLINE std::array<hn::Vec<D>, parts> distributed(D d, const std::array<V, 2>& numbers, std::size_t axis) {
    using N = hn::TFromD<D>;
    if constexpr (parts == 1 && Cell::count == 1) {
      using I = hn::TFromD<hn::RebindToUnsigned<D>>;
      const auto index = hn::SetTableIndices(d, sides<I>.of[axis].data());
      return {hn::TableLookupLanes(hn::Combine(d, numbers[1][0], numbers[0][0]), index)};
    } else {
      const hn::Rebind<N, Axes> da;
      alignas(64) std::array<AxisArray<N>, 2> stored;
      for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t i = 0; i < Cell::count; ++i) {
          hn::StoreU(numbers[side][i], da, stored[side].data() + i * Cell::step);
        }
      }
      const hn::RebindToUnsigned<D> di;
      std::array<hn::Vec<D>, parts> distributed;
      for (std::size_t i = 0; i < parts; ++i) {
        const auto from = hn::Load(di, sides<hn::TFromD<decltype(di)>>.of[axis].data() + i * lanes);
        const auto is_upper = hn::RebindMask(d, hn::TestBit(from, hn::Set(di, axis_lanes)));
        distributed[i] = hn::IfThenElse(is_upper, hn::Set(d, stored[1][axis]), hn::Set(d, stored[0][axis]));
      }
      return distributed;
    }
  }

  template <bool has_gradient>
  HWY_INLINE void of_cell(const Cell& cell, T* result) const {
    using V = hn::Vec<Corner>;
    const Corner d;
    const KeyTag<Corner> dk;
    std::array<std::array<V, axes>, parts> ways;
    std::array<std::array<Keys<Corner>, axes>, parts> keys;
    for (std::size_t a = 0; a < axes; ++a) {
      const auto way = distributed(d, cell.way, a);
      const auto key = distributed(dk, cell.key, a);
      for (std::size_t i = 0; i < parts; ++i) ways[i][a] = way[i], keys[i][a] = key[i];
    }
    std::array<Node<V, has_gradient>, parts> nodes;
    for (std::size_t i = 0; i < parts; ++i) {
      const auto hash = std::apply([&](auto... key) { return corners_.lattice.joined(dk, key...); }, keys[i]);
      nodes[i] = corners_.template at<has_gradient>(d, hash, ways[i]);
    }
    Eases eases;
    for (std::size_t i = 0; i < Cell::count; ++i) {
      hn::Store(cell.s[i], Axes(), eases.s.data() + i * Cell::step);
      if constexpr (has_gradient) hn::Store(cell.slope[i], Axes(), eases.slope.data() + i * Cell::step);
    }
    const auto node = joined<0, has_gradient>(d, nodes, eases);
    result[0] = hn::GetLane(node.value);
    if constexpr (has_gradient) {
      for (std::size_t a = 0; a < axes; ++a) result[1 + a] = hn::GetLane(node.gradient[a]);
    }
  }

  struct Eases {
    alignas(64) AxisArray<T> s, slope;
  };

  /// Corners that differ along one axis become one, axis by axis.
  template <int axis, bool has_gradient, class D, std::size_t count, class V = hn::Vec<D>>
  static HWY_INLINE auto joined(D d, const std::array<Node<V, has_gradient>, count>& nodes, const Eases& eases) {
    if constexpr (axis == dims) {
      return nodes[0];
    } else if constexpr (count > 1) {
      std::array<Node<V, has_gradient>, count / 2> half;
      for (std::size_t i = 0; i < count / 2; ++i) {
        half[i] = interpolated<axis>(d, nodes[i], nodes[i + count / 2], hn::Set(d, eases.s[axis]),
                                     hn::Set(d, eases.slope[axis]));
      }
      return joined<axis + 1, has_gradient>(d, half, eases);
    } else if constexpr (hn::MaxLanes(d) == 2) {
      Node<V, has_gradient> other;
      other.value = hn::Reverse2(d, nodes[0].value);
      if constexpr (has_gradient) {
        for (std::size_t k = 0; k < axes; ++k) other.gradient[k] = hn::Reverse2(d, nodes[0].gradient[k]);
      }
      return interpolated<axis>(d, nodes[0], other, hn::Set(d, eases.s[axis]), hn::Set(d, eases.slope[axis]));
    } else {
      const hn::Half<D> dh;
      Node<hn::Vec<hn::Half<D>>, has_gradient> low, high;
      low.value = hn::LowerHalf(dh, nodes[0].value);
      high.value = hn::UpperHalf(dh, nodes[0].value);
      if constexpr (has_gradient) {
        for (std::size_t k = 0; k < axes; ++k) {
          low.gradient[k] = hn::LowerHalf(dh, nodes[0].gradient[k]);
          high.gradient[k] = hn::UpperHalf(dh, nodes[0].gradient[k]);
        }
      }
      const std::array one{
          interpolated<axis>(dh, low, high, hn::Set(dh, eases.s[axis]), hn::Set(dh, eases.slope[axis]))};
      return joined<axis + 1, has_gradient>(dh, one, eases);
    }
  }

  Corners corners_;
  std::array<AxisArray<std::uint32_t>, 2> axis_leads_{};  ///< What is added to near_bits for keys below and above.
};

}  // namespace sightline
