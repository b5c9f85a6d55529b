#pragma once
/// Interpolation between the corners of a lattice cell, along x, then y, then z, together with its derivatives.

#include <array>
#include <cstddef>

#include "sightline/math/simd.h"

namespace sightline {

/// From a to b, each exact at its end. The same operations in lanes and alone.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V lerp(D, V a, V b, V s) {
  return hn::MulAdd(s, b, hn::NegMulAdd(s, a, a));
}

/// What noise is at a point, or in a lane each at several points.
template <class V, std::size_t dims, bool has_gradient>
struct NoiseNode;

template <class V, std::size_t dims>
struct NoiseNode<V, dims, false> {
  V value;
};

template <class V, std::size_t dims>
struct NoiseNode<V, dims, true> {
  V value;
  std::array<V, dims> gradient;
};

/// Between two nodes, as the eased coordinate along `axis` goes from 0 to 1 with that slope:
///   d/dx_k lerp(a, b, s) = lerp(da/dx_k, db/dx_k, s) + ds/dx_k (b - a).
template <int axis, class D, class V, std::size_t dims, bool has_gradient>
HWY_INLINE NoiseNode<V, dims, has_gradient> interpolated(D d, const NoiseNode<V, dims, has_gradient>& a,
                                                         const NoiseNode<V, dims, has_gradient>& b, V s,
                                                         [[maybe_unused]] V slope) {
  NoiseNode<V, dims, has_gradient> node;
  node.value = lerp(d, a.value, b.value, s);
  if constexpr (has_gradient) {
    for (std::size_t k = 0; k < node.gradient.size(); ++k) {
      node.gradient[k] = lerp(d, a.gradient[k], b.gradient[k], s);
    }
    V& along = node.gradient[static_cast<std::size_t>(axis)];
    along = hn::MulAdd(slope, hn::Sub(b.value, a.value), along);
  }
  return node;
}

}  // namespace sightline
