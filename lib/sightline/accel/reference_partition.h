#pragma once
/// Moving references so that those of one kind come first.

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "sightline/accel/bounds_reference.h"

namespace sightline {

inline constexpr std::size_t parallel_size = std::size_t{1} << 16;  ///< So many references are divided by many threads.

namespace detail {

/// One exchange for each reference, wanted or not: no branch to mispredict.
template <class IsBelow>
std::size_t partition_chunk(std::span<BoundsReference> items, const IsBelow& is_below, CenterBounds& below,
                            CenterBounds& above) {
  CenterBounds in_below, in_above;
  std::size_t middle = 0;
  for (BoundsReference& at : items) {
    const BoundsReference item = at;
    const bool goes_below = is_below(item);
    const ReferenceCenter center(item);
    in_below.extend_if(goes_below, center);
    in_above.extend_if(!goes_below, center);
    at = items[middle];
    items[middle] = item;
    middle += goes_below;
  }
  below.extend(in_below);
  above.extend(in_above);
  return middle;
}

}  // namespace detail

/// Reorders `items` so that those for which is_below(item) come first, and tells how many they are. Adds to the bounds
/// of the centers of both kinds. The order depends on nothing else.
template <class IsBelow>
std::size_t partition_references(std::span<BoundsReference> items, const IsBelow& is_below, CenterBounds& below,
                                 CenterBounds& above) {
  if (items.size() < parallel_size) {
    return detail::partition_chunk(items, is_below, below, above);
  }
  // Each chunk is divided on its own; then the stretches on the wrong side of the middle are exchanged.
  constexpr std::size_t chunk_size = 16384;
  struct Chunk {
    std::size_t begin, middle, end;
    CenterBounds below, above;
  };
  std::vector<Chunk> chunks((items.size() - 1) / chunk_size + 1);
  tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t i) {
    Chunk& chunk = chunks[i];
    chunk.begin = i * chunk_size;
    chunk.end = std::min(items.size(), chunk.begin + chunk_size);
    chunk.middle = chunk.begin + detail::partition_chunk(items.subspan(chunk.begin, chunk.end - chunk.begin), is_below,
                                                         chunk.below, chunk.above);
  });
  std::size_t middle = 0;
  for (const Chunk& chunk : chunks) {
    below.extend(chunk.below);
    above.extend(chunk.above);
    middle += chunk.middle - chunk.begin;
  }

  struct Stretch {
    std::size_t begin, size;
  };
  std::vector<Stretch> too_low, too_high;
  for (const Chunk& chunk : chunks) {
    const std::size_t low_end = std::min(chunk.end, middle), high_begin = std::max(chunk.begin, middle);
    if (chunk.middle < low_end) too_low.push_back({chunk.middle, low_end - chunk.middle});
    if (high_begin < chunk.middle) too_high.push_back({high_begin, chunk.middle - high_begin});
  }
  struct Exchange {
    std::size_t low, high, size;
  };
  std::vector<Exchange> exchanges;
  for (auto low = too_low.begin(), high = too_high.begin(); low != too_low.end() && high != too_high.end();) {
    const std::size_t size = std::min(low->size, high->size);
    exchanges.push_back({low->begin, high->begin, size});
    low->begin += size, low->size -= size;
    high->begin += size, high->size -= size;
    if (low->size == 0) ++low;
    if (high->size == 0) ++high;
  }
  tbb::parallel_for(std::size_t{0}, exchanges.size(), [&](std::size_t i) {
    const auto low = items.begin() + static_cast<std::ptrdiff_t>(exchanges[i].low);
    std::swap_ranges(low, low + static_cast<std::ptrdiff_t>(exchanges[i].size),
                     items.begin() + static_cast<std::ptrdiff_t>(exchanges[i].high));
  });
  return middle;
}

}  // namespace sightline
