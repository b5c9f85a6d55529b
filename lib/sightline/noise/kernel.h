#pragma once
/// Noise at many points, one in each lane. Every number goes through the same operations as at a single point, so that
/// both find the same to the last bit.

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "sightline/noise/point_kernel.h"

namespace sightline {

/// `Corners` is one of corner.h.
template <class T, class Corners, Ease ease>
class NoiseKernel {
 public:
  static constexpr std::size_t dims = Corners::dims;
  static constexpr std::size_t axes = dims;

  explicit NoiseKernel(const Corners& corners) : point_(corners), corners_(corners) {
    for (std::size_t a = 0; a < axes; ++a) {
      for (std::uint32_t side = 0; side < 2; ++side) leads_[a][side] = near_bias<T> + side + corners.lattice.lead(a);
    }
  }

  /// Value, and gradient where asked for, at one point. Of coordinates that are infinite or NaN: NaN.
  template <bool has_gradient>
  HWY_INLINE void at(const T* point, T* result) const {
    point_.template at<has_gradient>(point, result);
  }

  /// The same at `count` points, given axis by axis. `results` has a list of values and, where asked for, one for each
  /// component of the gradient.
  template <bool has_gradient>
  void at(const T* const* points, std::size_t count, T* const* results) const {
    const hn::ScalableTag<T> d;
    constexpr std::size_t step = hn::MaxLanes(d);
    std::size_t i = 0;
    for (; i + step <= count; i += step) {
      std::array<hn::Vec<Points>, axes> x;
      for (std::size_t a = 0; a < axes; ++a) x[a] = hn::LoadU(d, points[a] + i);
      if (HWY_LIKELY(are_near(x))) {
        const auto node = of_points<has_gradient>(x);
        hn::StoreU(node.value, d, results[0] + i);
        if constexpr (has_gradient) {
          for (std::size_t a = 0; a < axes; ++a) hn::StoreU(node.gradient[a], d, results[1 + a] + i);
        }
      } else {
        one_by_one<has_gradient>(points, i, i + step, results);
      }
    }
    one_by_one<has_gradient>(points, i, count, results);
  }

 private:
  using Lattice = std::remove_cvref_t<decltype(std::declval<Corners>().lattice)>;
  template <class V, bool has_gradient>
  using Node = NoiseNode<V, dims, has_gradient>;

  using Points = hn::ScalableTag<T>;

  static bool are_near(const std::array<hn::Vec<Points>, axes>& x) {
    const Points d;
    auto size = hn::Add(hn::Abs(x[0]), hn::Abs(x[1]));
    if constexpr (dims == 3) size = hn::Add(size, hn::Abs(x[2]));
    return hn::AllTrue(d, hn::Lt(size, hn::Set(d, near_limit<T>)));
  }

  template <bool has_gradient>
  HWY_INLINE Node<hn::Vec<Points>, has_gradient> of_points(const std::array<hn::Vec<Points>, axes>& x) const {
    using V = hn::Vec<Points>;
    const Points d;
    const KeyTag<Points> dk;
    std::array<std::array<V, 2>, axes> ways;
    std::array<std::array<Keys<Points>, 2>, axes> keys;
    std::array<V, axes> s, slope;
    for (std::size_t a = 0; a < axes; ++a) {
      const V below = hn::Floor(x[a]);
      const Keys<Points> bits = near_bits(d, below);
      ways[a] = {hn::Sub(x[a], below), hn::Sub(x[a], hn::Add(below, hn::Set(d, T(1))))};
      for (std::size_t side = 0; side < 2; ++side) {
        keys[a][side] = corners_.lattice.spread(dk, a, hn::Add(bits, hn::Set(dk, leads_[a][side])));
      }
      s[a] = eased<ease>(d, ways[a][0]);
      slope[a] = slope_of_eased<ease>(d, ways[a][0], ways[a][1]);
    }
    const typename Lattice::template Columns<KeyTag<Points>> columns(corners_.lattice, keys[0], keys[1]);
    if constexpr (dims == 2) {
      const auto corner = [&](std::size_t i, std::size_t j) HWY_ATTR {
        return corners_.template at<has_gradient>(d, columns.at(i, j), std::array{ways[0][i], ways[1][j]});
      };
      const auto along_x = [&](std::size_t j)
                               HWY_ATTR { return interpolated<0>(d, corner(0, j), corner(1, j), s[0], slope[0]); };
      return interpolated<1>(d, along_x(0), along_x(1), s[1], slope[1]);
    } else {
      const std::array levels{columns.level(keys[2][0]), columns.level(keys[2][1])};
      const auto corner = [&](std::size_t i, std::size_t j, std::size_t k) HWY_ATTR {
        return corners_.template at<has_gradient>(d, columns.at(i, j, levels[k]),
                                                  std::array{ways[0][i], ways[1][j], ways[2][k]});
      };
      const auto along_x = [&](std::size_t j, std::size_t k) HWY_ATTR {
        return interpolated<0>(d, corner(0, j, k), corner(1, j, k), s[0], slope[0]);
      };
      const auto along_y = [&](std::size_t k)
                               HWY_ATTR { return interpolated<1>(d, along_x(0, k), along_x(1, k), s[1], slope[1]); };
      return interpolated<2>(d, along_y(0), along_y(1), s[2], slope[2]);
    }
  }

  template <bool has_gradient>
  void one_by_one(const T* const* points, std::size_t begin, std::size_t end, T* const* results) const {
    for (std::size_t i = begin; i < end; ++i) {
      std::array<T, axes> point;
      std::array<T, 1 + axes> result;
      for (std::size_t a = 0; a < axes; ++a) point[a] = points[a][i];
      at<has_gradient>(point.data(), result.data());
      for (std::size_t k = 0; k < (has_gradient ? 1 + axes : 1); ++k) results[k][i] = result[k];
    }
  }

  PointKernel<T, Corners, ease> point_;
  Corners corners_;
  std::array<std::array<std::uint32_t, 2>, axes> leads_;  ///< What is added to near_bits for keys below and above.
};

}  // namespace sightline
