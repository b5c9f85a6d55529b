#pragma once
/// The gradients that lattice points choose from.

#include <array>
#include <cstddef>
#include <cstdint>

#include "sightline/math/simd.h"

namespace sightline {

/// Sixteen vectors, component by component, and these negated.
template <class T, std::size_t dims>
struct DirectionTable {
  static constexpr std::size_t size = 16;

  alignas(64) std::array<std::array<T, 2 * size>, dims> components;
};

/// 32 unit vectors, spread evenly. In the plane they are 11.25 degrees apart, in space they point at the vertices of a
/// dodecahedron and of the icosahedron dual to it.
template <class T, std::size_t dims>
DirectionTable<T, dims> unit_directions();

/// The twelve middles of a cube's edges, four of them twice, in the order of the reference. Perlin, "Improving Noise",
/// 2002.
template <class T>
DirectionTable<T, 3> edge_directions();

/// Which direction each lane takes: the five highest bits of its hash say so, of which the highest one says whether it
/// is negated. Components are looked up as they are in the table or negated already; `turned` does what is left to do.
template <class D>
class Choice {
 public:
  using V = hn::Vec<D>;
  using T = hn::TFromD<D>;

  HWY_INLINE explicit Choice(hn::Vec<hn::RebindToUnsigned<D>> hash)
      : index_(hn::ShiftRight<8 * sizeof(T) - 5>(hash)), sign_(hn::And(hn::BitCast(D(), hash), hn::SignBit(D()))) {}

  HWY_INLINE V component(const std::array<T, 32>& table) const {
    const D d;
    const hn::RebindToUnsigned<D> du;
    if constexpr (can_look_up_two<D> && lanes >= 8) {
      return look_up_two(d, table.data(), index_);
    } else if constexpr (lanes == 8) {
      const auto lower = hn::IndicesFromVec(d, hn::And(index_, hn::Set(du, 7)));
      const auto is_upper = hn::RebindMask(d, hn::TestBit(index_, hn::Set(du, 8)));
      return hn::IfThenElse(is_upper, hn::TableLookupLanes(hn::Load(d, table.data() + 8), lower),
                            hn::TableLookupLanes(hn::Load(d, table.data()), lower));
    } else {
      return hn::GatherIndex(d, table.data(), hn::BitCast(hn::RebindToSigned<D>(), index_));
    }
  }

  HWY_INLINE V turned(V v) const {
    if constexpr (lanes == 8) return hn::Xor(v, sign_);
    return v;
  }

 private:
  static constexpr std::size_t lanes = hn::MaxLanes(D());
  static_assert(lanes <= 16);

  hn::Vec<hn::RebindToUnsigned<D>> index_;
  V sign_;
};

}  // namespace sightline
