#pragma once
/// Many rays under way at once, for structures whose traversal goes on step by step (`Walk`).
///
/// A single ray waits for memory most of its time: what it reads next depends on what it has read. A stream takes its
/// rays in turn, one step each, and asks for what a ray's next step will read as soon as that is known; by its next
/// turn it is there. The hits are those of single rays, bit for bit, since each ray does what it would do alone.
/// Wald, Slusallek, Benthin and Wagner, "Interactive Rendering with Coherent Ray Tracing", 2001 (many rays at once);
/// Chen, Ailamaki, Gibbons and Mowry, "Improving Hash Join Performance through Prefetching", 2004 (taking turns).

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "sightline/query/queries.h"

namespace sightline {

namespace detail {
template <class T>
struct AnyViewUser {
  template <class View>
  requires requires { typename View::template Walk<T>; }
  void operator()(const View&) const;
};
}  // namespace detail

/// with_view(use) calls use with what has the `Walk` and `traverse`: one of several types, so that a structure that
/// chooses between kinds of nodes does so once for all rays.
template <class A, class T>
concept Steppable = requires(const A& accel) {
  accel.with_view(detail::AnyViewUser<T>{});
};

/// Rays under way at a time: enough to cover a walk to memory with the steps of the others, few enough for their stacks
/// to stay in the first-level cache.
inline constexpr std::size_t stream_width = 12;

/// Views in which rays can begin together.
template <class View, class T>
concept Packing = requires {
  typename View::template Packet<T>;
};

namespace detail {

struct NoPacket {};
template <class View, class T>
struct PacketOf {
  using type = NoPacket;
};
template <class View, class T>
requires Packing<View, T>
struct PacketOf<View, T> {
  using type = typename View::template Packet<T>;
};

/// Feeds rays through slots. `Query` is made of a ray, is told of leaves, and says what was found.
template <class Query, class T, class Leaves, class View>
class Stream {
 public:
  Stream(const View& view, const Leaves& leaves, std::span<const Ray<T>> rays)
      : view_(view), leaves_(leaves), rays_(rays) {}

  /// Calls finish(index of the ray, its query) for every ray, in any order.
  template <class Finish>
  void run(Finish&& finish) {
    for (auto& slot : slots_) fill(slot, finish);
    while (under_way_ > 0) {
      for (auto& slot : slots_) {
        if (!slot) continue;
        const QueryVisitor visit{slot->query, leaves_};
        if (slot->walk.step(visit, probe_)) {
          slot->walk.fetch_next(visit);
        } else {
          finish(slot->index, slot->query);
          --under_way_;
          fill(slot, finish);
        }
      }
    }
  }

 private:
  using Walk = typename View::template Walk<T>;
  using Packet = typename PacketOf<View, T>::type;

  struct Slot {
    template <class... From>
    Slot(const Leaves& leaves, const Ray<T>& ray, std::size_t at, const View& view, const From&... from)
        : walk(view, from...), query(leaves, ray), index(at) {}
    Walk walk;
    Query query;
    std::size_t index;
  };

  template <class Finish>
  void fill(std::optional<Slot>& slot, Finish&& finish) {
    for (slot.reset(); next_ < rays_.size() && !slot; ++next_) {
      const Ray<T>& ray = rays_[next_];
      if (begin_together(slot, finish)) continue;
      slot.emplace(leaves_, ray, next_, view_, ray);
      if (slot->walk.serves()) continue;
      view_.traverse(ray, QueryVisitor{slot->query, leaves_}, probe_);
      finish(next_, slot->query);
      slot.reset();
    }
    under_way_ += slot.has_value();
  }

  /// Makes a packet of every so many rays; false where they are not coherent.
  template <class Finish>
  bool begin_together(std::optional<Slot>& slot, Finish&& finish) {
    if constexpr (Packing<View, T>) {
      const std::size_t lane = next_ % Packet::size;
      if (lane == 0) packet_.emplace(view_, rays_.subspan(next_, std::min(Packet::size, rays_.size() - next_)));
      if (!packet_->is_coherent()) return false;
      if (packet_->is_met(lane)) {
        slot.emplace(leaves_, rays_[next_], next_, view_, *packet_, lane);
      } else {
        finish(next_, Query(leaves_, rays_[next_]));
      }
      return true;
    } else {
      return false;
    }
  }

  const View& view_;
  const Leaves& leaves_;
  std::span<const Ray<T>> rays_;
  std::size_t next_ = 0, under_way_ = 0;
  std::array<std::optional<Slot>, stream_width> slots_;
  std::optional<Packet> packet_;
  NoProbe probe_;
};

}  // namespace detail

/// hits[i] becomes what closest_hit finds for rays[i].
template <class T, FetchingLeaves Leaves, Steppable<T> Accel>
void closest_hits(const Accel& accel, const Leaves& leaves, std::span<const Ray<T>> rays, std::span<Hit<T>> hits) {
  accel.with_view([&]<class View>(const View& view) {
    detail::Stream<ClosestQuery<T, Leaves>, T, Leaves, View>(view, leaves, rays)
        .run([&](std::size_t i, const auto& query) { hits[i] = query.best; });
  });
}

/// is_hit[i] becomes what any_hit finds for rays[i].
template <class T, FetchingLeaves Leaves, Steppable<T> Accel>
void any_hits(const Accel& accel, const Leaves& leaves, std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit) {
  accel.with_view([&]<class View>(const View& view) {
    detail::Stream<AnyQuery<T, Leaves>, T, Leaves, View>(view, leaves, rays).run([&](std::size_t i, const auto& query) {
      is_hit[i] = query.is_found;
    });
  });
}

}  // namespace sightline
