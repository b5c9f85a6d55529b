#pragma once
/// Vectors of Google's Highway library, compiled for the processor that the build names: the widest it has, four lanes
/// of SSE2 where it names none.

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

namespace sightline {

namespace hn = hwy::HWY_NAMESPACE;

/// The larger of each lane; that of b where a is NaN. b is none.
template <class V>
V larger(V a, V b) {
  if constexpr (HWY_ARCH_X86) {
    return hn::Max(a, b);  // maxps gives its second operand where either is NaN
  } else {
    return hn::IfThenElse(hn::Gt(a, b), a, b);
  }
}

/// The smaller of each lane; that of b where a is NaN. b is none.
template <class V>
V smaller(V a, V b) {
  if constexpr (HWY_ARCH_X86) {
    return hn::Min(a, b);
  } else {
    return hn::IfThenElse(hn::Lt(a, b), a, b);
  }
}

/// Whether the processor looks up two vectors at once.
template <class D>
inline constexpr bool can_look_up_two = HWY_TARGET <= HWY_AVX3 && sizeof(hn::Vec<D>) >= 32;

/// Of the 2 n numbers at `table`, aligned as vectors of n lanes are, the one that each lane's index says; its bits
/// above those are not looked at. What later versions of Highway call TwoTablesLookupLanes.
template <class D, class VI>
HWY_INLINE hn::Vec<D> look_up_two(D d, const hn::TFromD<D>* table, VI index) {
  static_assert(can_look_up_two<D>);
#if HWY_TARGET <= HWY_AVX3
  const auto low = hn::Load(d, table).raw, high = hn::Load(d, table + hn::MaxLanes(d)).raw;
  if constexpr (sizeof(low) == 32) {
    if constexpr (sizeof(hn::TFromD<D>) == 4)
      return hn::Vec<D>{_mm256_permutex2var_ps(low, index.raw, high)};
    else
      return hn::Vec<D>{_mm256_permutex2var_pd(low, index.raw, high)};
  } else {
    if constexpr (sizeof(hn::TFromD<D>) == 4)
      return hn::Vec<D>{_mm512_permutex2var_ps(low, index.raw, high)};
    else
      return hn::Vec<D>{_mm512_permutex2var_pd(low, index.raw, high)};
  }
#endif
}

/// Has the cache lines of [begin, begin + bytes) brought near, without waiting for them.
inline void prefetch(const void* begin, std::size_t bytes) {
  constexpr std::size_t line = 64;
  const char* const at = static_cast<const char*>(begin);
  for (std::size_t offset = 0; offset < bytes; offset += line) hwy::Prefetch(at + offset);
  hwy::Prefetch(at + bytes - 1);
}

/// The mask of no lane.
template <class D>
hn::Mask<D> no_lanes(D d) {
  return hn::Ne(hn::Zero(d), hn::Zero(d));
}

/// One bit a lane, of at most sixteen lanes.
template <class D, class M>
std::uint32_t bits_of(D d, M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return hn::MaxLanes(d) <= 8 ? bytes[0] : bytes[0] | std::uint32_t{bytes[1]} << 8;
}

}  // namespace sightline
