#pragma once
/// What a lattice point gives to the cells around it, from its hash and the way from it to the point asked for.

#include <cstdint>

#include "sightline/noise/directions.h"
#include "sightline/noise/interpolation.h"
#include "sightline/noise/lattice.h"

namespace sightline {

namespace detail {

/// The way times the vector that the five highest bits of the hash choose.
template <bool has_gradient, std::size_t dims, class D, class VI, class V = hn::Vec<D>>
HWY_INLINE NoiseNode<V, dims, has_gradient> directed(D, const DirectionTable<hn::TFromD<D>, dims>& table, VI hash,
                                                     const std::array<V, dims>& way) {
  const Choice<D> choice(hash);
  std::array<V, dims> direction;
  for (std::size_t k = 0; k < dims; ++k) direction[k] = choice.component(table.components[k]);
  V product = hn::Mul(direction[dims - 1], way[dims - 1]);
  for (std::size_t k = dims - 1; k-- > 0;) product = hn::MulAdd(direction[k], way[k], product);
  NoiseNode<V, dims, has_gradient> node;
  node.value = choice.turned(product);
  if constexpr (has_gradient) {
    for (std::size_t k = 0; k < dims; ++k) node.gradient[k] = choice.turned(direction[k]);
  }
  return node;
}

}  // namespace detail

/// One of 32 unit vectors, times the way: Perlin's noise as courses teach it.
template <class T, std::size_t dimensions>
class UnitGradientCorners {
 public:
  static constexpr std::size_t dims = dimensions;

  UnitGradientCorners(std::uint64_t seed, std::uint32_t period) : lattice(seed, period) {}

  template <bool has_gradient, class D, class V = hn::Vec<D>>
  HWY_INLINE NoiseNode<V, dims, has_gradient> at(D d, Keys<D> hash, const std::array<V, dims>& way) const {
    return detail::directed<has_gradient>(d, table_, lifted(d, hash), way);
  }

  const HashedLattice lattice;

 private:
  const DirectionTable<T, dims> table_ = unit_directions<T, dims>();
};

/// One of the vectors to the middles of a cube's edges, times the way. Perlin, "Improving Noise", 2002.
template <class T>
class EdgeGradientCorners {
 public:
  static constexpr std::size_t dims = 3;

  EdgeGradientCorners(std::uint64_t seed, std::uint32_t) : lattice(seed) {}

  template <bool has_gradient, class D, class V = hn::Vec<D>>
  HWY_INLINE NoiseNode<V, dims, has_gradient> at(D d, Keys<D> hash, const std::array<V, dims>& way) const {
    const auto low_bits = hn::ShiftRight<1>(hn::ShiftLeft<28>(hash));
    return detail::directed<has_gradient>(d, table_, lifted(d, low_bits), way);
  }

  const PermutedLattice lattice;

 private:
  const DirectionTable<T, 3> table_ = edge_directions<T>();
};

/// A number between -1 and 1, wherever the point is.
template <class T, std::size_t dimensions>
class ValueCorners {
 public:
  static constexpr std::size_t dims = dimensions;

  ValueCorners(std::uint64_t seed, std::uint32_t period) : lattice(seed, period) {}

  template <bool has_gradient, class D, class V = hn::Vec<D>>
  HWY_INLINE NoiseNode<V, dims, has_gradient> at(D d, Keys<D> hash, const std::array<V, dims>&) const {
    const auto bits = hn::BitCast(hn::Rebind<std::int32_t, D>(), hash);
    NoiseNode<V, dims, has_gradient> node;
    if constexpr (sizeof(T) == 4) {
      node.value = hn::Mul(hn::ConvertTo(d, bits), hn::Set(d, T(0x1p-31)));
    } else {
      node.value = hn::Mul(hn::PromoteTo(d, bits), hn::Set(d, T(0x1p-31)));
    }
    if constexpr (has_gradient) {
      for (V& slope : node.gradient) slope = hn::Zero(d);
    }
    return node;
  }

  const HashedLattice lattice;
};

}  // namespace sightline
