#pragma once
/// 256 bytes looked up within registers, many at once.

#include <cstdint>

#include "sightline/math/simd.h"

namespace sightline {

#ifdef __AVX512VBMI__
inline constexpr bool can_look_up_bytes = HWY_TARGET <= HWY_AVX3;
#else
inline constexpr bool can_look_up_bytes = false;
#endif

/// Of the 256 bytes at `table`, aligned to 64, the one that the lowest byte of each lane says, in the lowest byte of
/// the lane; those above it are anything.
template <class V>
  requires(can_look_up_bytes)
HWY_INLINE V look_up_byte([[maybe_unused]] const std::uint8_t* table, V index) {
#ifdef __AVX512VBMI__
  const auto quarter = [table](int i) HWY_ATTR { return _mm512_load_si512(table + 64 * i); };
  const auto looked_up = [&](__m512i at) HWY_ATTR {
    const __m512i low = _mm512_permutex2var_epi8(quarter(0), at, quarter(1));
    const __m512i high = _mm512_permutex2var_epi8(quarter(2), at, quarter(3));
    return _mm512_mask_blend_epi8(_mm512_movepi8_mask(at), low, high);
  };
  if constexpr (sizeof(V) == 64) {
    return V{looked_up(index.raw)};
  } else if constexpr (sizeof(V) == 32) {
    return V{_mm512_castsi512_si256(looked_up(_mm512_castsi256_si512(index.raw)))};
  } else {
    return V{_mm512_castsi512_si128(looked_up(_mm512_castsi128_si512(index.raw)))};
  }
#else
  return index;
#endif
}

}  // namespace sightline
