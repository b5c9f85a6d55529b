#pragma once
/// Many rays under way at once, for structures whose traversal goes on step by step (`Walk`).
///
/// A single ray waits for memory most of its time: what it reads next depends on what it has read. A stream takes its
/// rays in turn, one step each, and asks for what a ray's next step will read as soon as that is known; by its next
/// turn it is there. The hits are those of single rays, bit for bit, since each ray does what it would do alone.
/// Wald, Slusallek, Benthin and Wagner, "Interactive Rendering with Coherent Ray Tracing", 2001 (many rays at once);
/// Chen, Ailamaki, Gibbons and Mowry, "Improving Hash Join Performance through Prefetching", 2004 (taking turns).

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "sightline/query/queries.h"

namespace sightline {

template <class A, class T>
concept Steppable = requires(const A& accel, const Ray<T>& ray) {
  typename A::template Walk<T>;
};

/// Rays under way at a time: enough to cover a walk to memory with the steps of the others, few enough for their stacks
/// to stay in the first-level cache.
inline constexpr std::size_t stream_width = 12;

namespace detail {

/// Feeds the rays through slots. `Query` is made of a ray, is told of leaves, and says what was found.
template <class Query, class T, class Leaves, class Accel, class Finish>
void stream(const Accel& accel, const Leaves& leaves, std::span<const Ray<T>> rays, Finish&& finish) {
  struct Slot {
    Slot(const Accel& accel, const Leaves& leaves, const Ray<T>& ray, std::size_t at)
        : walk(accel, ray), query(leaves, ray), index(at) {}
    typename Accel::template Walk<T> walk;
    Query query;
    std::size_t index;
  };
  std::array<std::optional<Slot>, stream_width> slots;
  NoProbe probe;
  std::size_t next = 0, under_way = 0;
  const auto fill = [&](std::optional<Slot>& slot) {
    for (slot.reset(); next < rays.size() && !slot; ++next) {
      slot.emplace(accel, leaves, rays[next], next);
      if (slot->walk.serves()) {
        ++under_way;
      } else {
        accel.traverse(rays[next], QueryVisitor{slot->query, leaves}, probe);
        finish(next, slot->query);
        slot.reset();
      }
    }
  };
  for (auto& slot : slots) fill(slot);
  while (under_way > 0) {
    for (auto& slot : slots) {
      if (!slot) continue;
      const QueryVisitor visit{slot->query, leaves};
      if (slot->walk.step(visit, probe)) {
        slot->walk.fetch_next(visit);
      } else {
        finish(slot->index, slot->query);
        --under_way;
        fill(slot);
      }
    }
  }
}

}  // namespace detail

/// hits[i] becomes what closest_hit finds for rays[i].
template <class T, FetchingLeaves Leaves, Steppable<T> Accel>
void closest_hits(const Accel& accel, const Leaves& leaves, std::span<const Ray<T>> rays, std::span<Hit<T>> hits) {
  detail::stream<ClosestQuery<T, Leaves>, T>(accel, leaves, rays,
                                             [&](std::size_t i, const auto& query) { hits[i] = query.best; });
}

/// is_hit[i] becomes what any_hit finds for rays[i].
template <class T, FetchingLeaves Leaves, Steppable<T> Accel>
void any_hits(const Accel& accel, const Leaves& leaves, std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit) {
  detail::stream<AnyQuery<T, Leaves>, T>(accel, leaves, rays,
                                         [&](std::size_t i, const auto& query) { is_hit[i] = query.is_found; });
}

}  // namespace sightline
