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

/// Has the cache lines of [begin, begin + bytes) brought near, without waiting for them.
inline void prefetch(const void* begin, std::size_t bytes) {
  constexpr std::size_t line = 64;
  const char* const at = static_cast<const char*>(begin);
  for (std::size_t offset = 0; offset < bytes; offset += line) hwy::Prefetch(at + offset);
  hwy::Prefetch(at + bytes - 1);
}

/// One bit a lane, of at most sixteen lanes.
template <class D, class M>
std::uint32_t bits_of(D d, M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return hn::MaxLanes(d) <= 8 ? bytes[0] : bytes[0] | std::uint32_t{bytes[1]} << 8;
}

}  // namespace sightline
