#pragma once

#include <malloc.h>

#include <cstddef>

namespace sightline::bench {

/// Bytes that malloc has handed out to this program and not got back: for libraries that do not say what they hold.
inline std::size_t heap_bytes() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

}  // namespace sightline::bench
