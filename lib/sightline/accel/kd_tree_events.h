#pragma once
/// The sorted lists over which a kd-tree's builder sweeps its planes.
///
/// Wald and Havran, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)", 2006.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "sightline/math/aabb.h"

namespace sightline::detail {

enum class EventKind : std::uint32_t { end, flat, start };

/// Along one axis: a primitive's clipped box ends, lies flat, or starts. Ordered by place, then in that order of kinds.
/// Left uninitialized on purpose: lists are sized first, then filled.
struct KdEvent {
  static constexpr std::uint32_t id_limit = 1u << 30;
  std::uint64_t key;

  KdEvent() {}
  KdEvent(float place, EventKind kind, std::uint32_t id)
      : key(std::uint64_t(ordered(place)) << 32 | static_cast<std::uint32_t>(kind) << 30 | id) {}

  float place() const {
    const auto bits = static_cast<std::uint32_t>(key >> 32);
    return std::bit_cast<float>(bits ^ (bits >> 31 ? 0x8000'0000 : 0xffff'ffff));
  }
  EventKind kind() const { return EventKind(static_cast<std::uint32_t>(key) >> 30); }
  std::uint32_t id() const { return static_cast<std::uint32_t>(key) & (id_limit - 1); }
  friend bool operator<(const KdEvent& a, const KdEvent& b) { return a.key < b.key; }

 private:
  /// Floats as integers of the same order; both zeros are one place.
  static std::uint32_t ordered(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x + 0.0f);
    return bits ^ (bits >> 31 ? 0xffff'ffff : 0x8000'0000);
  }
};

using KdEventList = std::vector<KdEvent>;

/// Radix sort by place, eleven bits at a time; stable, so that lists made kind by kind end up in order.
inline void sort_by_place(KdEventList& events) {
  KdEventList other(events.size());
  for (const int shift : {32, 43, 54}) {
    const auto digit = [&](const KdEvent& event) { return event.key >> shift & 2047; };
    std::array<std::size_t, 2048> starts{};
    for (const KdEvent& event : events) ++starts[digit(event)];
    std::size_t sum = 0;
    for (std::size_t& start : starts) sum += std::exchange(start, sum);
    for (const KdEvent& event : events) other[starts[digit(event)]++] = event;
    events.swap(other);
  }
}

/// Merges `fresh`, which need not be sorted, into the sorted `events`: from the back, in place.
inline void merge_into(KdEventList& events, KdEventList& fresh) {
  std::sort(fresh.begin(), fresh.end());
  std::size_t kept = events.size(), left = fresh.size(), to = kept + left;
  events.resize(to);
  while (left > 0) {
    events[--to] = kept > 0 && fresh[left - 1] < events[kept - 1] ? events[--kept] : fresh[--left];
  }
}

struct KdSplit {
  double cost = 0;  ///< Of the cell, so divided.
  int axis = -1;    ///< -1 when not dividing is cheapest.
  float place = 0;
  bool flat_below = false;  ///< Primitives that lie flat in the plane go below.
  std::uint32_t count_below = 0, count_above = 0;
};

struct KdCosts {
  double traversal, intersection;
  double empty_share;  ///< Of the cost, where one side is empty.
};

/// The cheapest of all planes strictly inside the cell in which an event of its `count` primitives lies; of those along
/// the cell's widest axis, if asked for and if one is worth it.
///
/// Each event is a candidate with the counts so far, which need no grouping by place: among events at one place, the
/// last end sees the count above, and the first start the count below, that are true of the plane; the others see more.
/// The first flat one sees all flat ones above, the last sees them all below, and the cost of any other deal lies
/// between those two.
inline KdSplit cheapest_split(const std::array<KdEventList, 3>& lists, std::uint32_t count, const Aabb& cell,
                              const KdCosts& costs, bool is_widest_only) {
  KdSplit best{costs.intersection * count};
  const Vec3d extent = Vec3d(cell.hi) - Vec3d(cell.lo);
  const int widest = cell.longest_axis();
  for (int turn = 0; turn < 3; ++turn) {
    const int axis = (widest + turn) % 3;
    if (is_widest_only && best.axis >= 0) break;
    const float lo = cell.lo[axis], hi = cell.hi[axis];
    if (!(lo < hi)) continue;
    // Half the area of a part that is w wide is cap + w * rim. Cells without area are measured by their width.
    double cap = extent[(axis + 1) % 3] * extent[(axis + 2) % 3];
    double rim = extent[(axis + 1) % 3] + extent[(axis + 2) % 3];
    if (!(cap + extent[axis] * rim > 0)) cap = 0, rim = 1;
    const double scale = costs.intersection / (cap + extent[axis] * rim);
    const double cap_below = cap - lo * rim, cap_above = cap + hi * rim;
    const auto weight = [=](float place, std::int32_t low, std::int32_t high) {
      const double moved = place * rim;
      return low * (cap_below + moved) + high * (cap_above - moved);
    };
    double least = (best.cost - costs.traversal) / scale;
    const auto take = [&](float place, bool flat_below, std::int32_t low, std::int32_t high, double share) {
      const double cost = (costs.traversal + scale * weight(place, low, high)) * share;
      if (!(cost < best.cost)) return;
      best = {cost, axis, place, flat_below, static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high)};
      least = (cost - costs.traversal) / scale;
    };

    auto event = lists[axis].begin();
    const auto end = lists[axis].end();
    auto low = std::int32_t{0}, high = static_cast<std::int32_t>(count);
    for (; event != end && !(event->place() > lo); ++event) {
      low += event->kind() != EventKind::end;
      high -= event->kind() != EventKind::start;
    }
    if (low == 0 && event != end && event->place() < hi) take(event->place(), false, 0, high, costs.empty_share);
    for (; event != end && event->place() < hi; ++event) {
      const float place = event->place();
      const EventKind kind = event->kind();
      high -= kind == EventKind::end;
      if (weight(place, low, high) < least) take(place, false, low, high, 1);
      low += kind != EventKind::end;
      if (kind != EventKind::flat) continue;
      --high;
      if (weight(place, low, high) < least) take(place, true, low, high, 1);
    }
    if (high == 0 && lists[axis].back().place() > lo) take(lists[axis].back().place(), true, low, 0, costs.empty_share);
  }
  return best;
}

/// The cell halved across its widest axis, whatever it costs; of a cell too thin for it, no split.
inline KdSplit halving_split(const std::array<KdEventList, 3>& lists, std::uint32_t count, const Aabb& cell) {
  KdSplit split;
  const int axis = cell.longest_axis();
  const float lo = cell.lo[axis], hi = cell.hi[axis];
  split.place = lo + 0.5f * (hi - lo);
  if (!(lo < split.place && split.place < hi)) return split;
  split.axis = axis;
  split.count_above = count;
  for (const KdEvent& event : lists[axis]) {  // what lies flat in the plane goes above
    if (event.place() > split.place) break;
    const bool is_before = event.place() < split.place;
    split.count_below += is_before && event.kind() != EventKind::end;
    split.count_above -= is_before ? event.kind() != EventKind::start : event.kind() == EventKind::end;
  }
  return split;
}

/// Of a splitting plane. The values serve as counts in `deal`.
enum class KdSide : std::uint8_t { both = 0, below = 1, above = 2 };

/// Sets the side of each of the `count` primitives whose events are `along` the split's axis, and lists those on both.
/// Returns how many are above only.
inline std::uint32_t take_sides(const KdEventList& along, const KdSplit& split, std::uint32_t count, KdSide* sides,
                                std::vector<std::uint32_t>& straddlers) {
  const auto at = std::partition_point(along.begin(), along.end(), [&](KdEvent e) { return e.place() < split.place; });
  const auto beyond = std::partition_point(at, along.end(), [&](KdEvent e) { return e.place() == split.place; });
  for (auto event = along.begin(); event != at; ++event) {  // whoever starts is on both sides until it ends
    sides[event->id()] = event->kind() == EventKind::start ? KdSide::both : KdSide::below;
  }
  std::uint32_t above = 0, shared = 0;
  for (auto event = at; event != beyond; ++event) {
    const bool is_above = event->kind() == EventKind::start || (event->kind() == EventKind::flat && !split.flat_below);
    sides[event->id()] = is_above ? KdSide::above : KdSide::below;
    above += is_above;
  }
  straddlers.resize(std::size_t(count) + 1);  // one more than can be kept, as each is written
  for (auto event = beyond; event != along.end(); ++event) {
    const bool is_end = event->kind() == EventKind::end;
    KdSide& side = sides[event->id()];
    straddlers[shared] = event->id();
    shared += is_end && side == KdSide::both;
    side = is_end ? side : KdSide::above;
    above += !is_end;
  }
  straddlers.resize(shared);
  return above;
}

/// Deals sorted events out to two lists that have room for one more than they get, as both are written: which side
/// comes next is past prediction.
inline void deal(const KdEventList& events, const KdSide* sides, KdEventList& below, KdEventList& above) {
  KdEvent *next_below = below.data(), *next_above = above.data();
  for (const KdEvent& event : events) {
    const auto side = static_cast<std::uint32_t>(sides[event.id()]);
    *next_below = *next_above = event;
    next_below += side & 1;
    next_above += side >> 1;
  }
  below.resize(static_cast<std::size_t>(next_below - below.data()));
  above.resize(static_cast<std::size_t>(next_above - above.data()));
}

}  // namespace sightline::detail
