#pragma once
/// Coherent rays, sixteen at a time: what they have in common is done once for all of them.
///
/// Neighbours meet the same nodes. A structure is asked once for the leaves that any ray of a packet meets
/// (ray_packet.h); each ray is then tested with those that it meets itself, or all that meet a leaf together where the
/// leaves can do that. The hits are those of single rays, bit for bit: what a ray is tested with besides it does not
/// meet, or is beyond its hit. That takes intersectors that keep M1 (padded_ray.h) for the precision of the rays;
/// solids of level fast keep it for rays of float.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include "sightline/accel/ray_packet.h"
#include "sightline/query/queries.h"

namespace sightline {

/// Structures that take a packet as they take a ray.
template <class A, class T>
concept PacketAccelerator = Accelerator<A> && requires(const A& a, const RayPacket<T>& rays, NoProbe& probe) {
  { a.bounds() } -> std::same_as<const Aabb&>;  // what packets are made with
  a.traverse(rays, detail::AnyLeafVisitor<T>{}, probe);
};

/// Leaves that know what holds all their shapes.
template <class L>
concept BoundedLeaves = requires(const L& leaves, LeafRange leaf) {
  { leaves.bounds(leaf) } -> std::same_as<Aabb>;
};

/// Leaves that test the rays of a packet together.
template <class L, class T>
concept PacketLeaves = requires(const L& leaves, const RayPacket<T>& packet, std::span<const Ray<T>> rays) {
  leaves.prepare(packet, rays);
};

namespace detail {

/// What the rays of a packet look for and have found so far, told of one leaf after the other.
template <class Query, class T, class Leaves>
class PacketQuery {
 public:
  static constexpr bool takes_any_order = Query::takes_any_order;

  PacketQuery(const Leaves& leaves, const RayPacket<T>& packet, std::span<const Ray<T>> rays)
      : PacketQuery(leaves, packet, rays, std::make_index_sequence<RayPacket<T>::size>()) {}

  /// Returns the far limit: the last one of all rays.
  T operator()(LeafRange leaf) {
    for (std::uint32_t met = open_ & meeting(leaf); met != 0; met &= met - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(met));
      limits_[i] = queries_[i].visit(leaves_, leaf);
      if (!(limits_[i] > rays_[i].t_min)) open_ &= ~(1u << i);  // hits lie beyond t_min
    }
    return RayPacket<T>::greatest(limits_);
  }

  typename Query::Result result(std::size_t ray) const { return queries_[ray].result(); }

 private:
  /// Places beyond the last ray are never open.
  template <std::size_t... I>
  PacketQuery(const Leaves& leaves, const RayPacket<T>& packet, std::span<const Ray<T>> rays, std::index_sequence<I...>)
      : leaves_(leaves),
        packet_(packet),
        rays_(rays),
        open_((1u << rays.size()) - 1),
        limits_{{(I < rays.size() ? rays[I].t_max : -std::numeric_limits<T>::infinity())...}},
        queries_{Query(leaves, rays[std::min(I, rays.size() - 1)])...} {}

  std::uint32_t meeting(LeafRange leaf) const {
    if constexpr (BoundedLeaves<Leaves>) {
      return packet_.meeting(leaves_.bounds(leaf), limits_);
    } else {
      return ~0u;
    }
  }

  const Leaves& leaves_;
  const RayPacket<T>& packet_;
  std::span<const Ray<T>> rays_;
  std::uint32_t open_;  ///< A bit for each ray that may find something nearer.
  typename RayPacket<T>::Lanes limits_;
  std::array<Query, RayPacket<T>::size> queries_;
};

/// The same where leaves take all rays at once. What is found goes to `results` at once, or when the query ends.
template <class Query, class T, class Leaves>
class TogetherQuery {
 public:
  static constexpr bool takes_any_order = Query::takes_any_order;
  using Result = std::conditional_t<takes_any_order, std::uint8_t, Hit<T>>;

  TogetherQuery(const Leaves& leaves, const RayPacket<T>& packet, std::span<const Ray<T>> rays,
                std::span<Result> results)
      : leaves_(leaves),
        packet_(packet),
        rays_(rays),
        results_(results),
        open_((1u << rays.size()) - 1),
        prepared_(leaves.prepare(packet, rays)),
        limits_(packet.farthest()) {
    for (std::size_t i = rays.size(); i < RayPacket<T>::size; ++i) limits_[i] = -std::numeric_limits<T>::infinity();
    if constexpr (!takes_any_order) std::fill(results.begin(), results.end(), Result{});
  }
  ~TogetherQuery() {
    if constexpr (takes_any_order) {
      for (std::size_t i = 0; i < results_.size(); ++i) results_[i] = found_ >> i & 1;
    }
  }
  TogetherQuery(const TogetherQuery&) = delete;
  TogetherQuery& operator=(const TogetherQuery&) = delete;

  /// Returns the far limit: the last one of all rays.
  T operator()(LeafRange leaf) {
    const std::uint32_t met = open_ & packet_.meeting(leaves_.bounds(leaf), limits_);
    if (met != 0) test(leaf, met);
    return RayPacket<T>::greatest(limits_);
  }

 private:
  void test(LeafRange leaf, std::uint32_t met) {
    if constexpr (takes_any_order) {
      const std::uint32_t found = leaves_.having_crossing(prepared_, leaf, met);
      found_ |= found;
      for (std::uint32_t rest = found; rest != 0; rest &= rest - 1) {
        limits_[static_cast<std::size_t>(std::countr_zero(rest))] = -std::numeric_limits<T>::infinity();
      }
      open_ &= ~found;
    } else {
      leaves_.for_first_crossings(prepared_, leaf, met, limits_,
                                  [&](std::size_t i, std::uint32_t id, const Crossing& crossing) {
                                    keep_closer(rays_[i], id, crossing, results_[i]);
                                    limits_[i] = std::min(results_[i].t, rays_[i].t_max);
                                  });
    }
  }

  const Leaves& leaves_;
  const RayPacket<T>& packet_;
  std::span<const Ray<T>> rays_;
  std::span<Result> results_;
  std::uint32_t open_;  ///< A bit for each ray that may find something nearer.
  std::uint32_t found_ = 0;
  decltype(std::declval<const Leaves&>().prepare(std::declval<const RayPacket<T>&>(),
                                                 std::declval<std::span<const Ray<T>>>())) prepared_;
  typename RayPacket<T>::Lanes limits_;
};

/// Writes what its query finds of every ray.
template <class Query, class T, class Leaves, class Accel, class Probe, class Result>
void trace_packets(const Accel& accel, const Leaves& leaves, std::span<const Ray<T>> rays, std::span<Result> results,
                   Probe& probe) {
  constexpr std::size_t size = RayPacket<T>::size;
  for (std::size_t first = 0; first < rays.size(); first += size) {
    const std::span<const Ray<T>> part = rays.subspan(first, std::min(size, rays.size() - first));
    const std::span<Result> into = results.subspan(first, part.size());
    if constexpr (PacketAccelerator<Accel, T>) {
      const RayPacket<T> packet(part, accel.bounds());
      if (packet.is_coherent()) {
        if constexpr (PacketLeaves<Leaves, T>) {
          TogetherQuery<Query, T, Leaves> queries(leaves, packet, part, into);
          accel.traverse(packet, queries, probe);
        } else {
          PacketQuery<Query, T, Leaves> queries(leaves, packet, part);
          accel.traverse(packet, queries, probe);
          for (std::size_t i = 0; i < part.size(); ++i) into[i] = queries.result(i);
        }
        continue;
      }
    }
    for (std::size_t i = 0; i < part.size(); ++i) {
      Query query(leaves, part[i]);
      accel.traverse(part[i], QueryVisitor{query, leaves}, probe);
      into[i] = query.result();
    }
  }
}

}  // namespace detail

/// hits[i] becomes what closest_hit finds for rays[i]. It is fastest where each sixteen rays from the first one on are
/// neighbours, such as a square of pixels. Structures without packets are asked ray by ray.
template <class T, class Leaves, class Accel, class Probe>
void packet_closest_hits(const Accel& accel, const Leaves& leaves, std::span<const Ray<T>> rays, std::span<Hit<T>> hits,
                         Probe& probe) {
  detail::trace_packets<ClosestQuery<T, Leaves>>(accel, leaves, rays, hits, probe);
}

/// is_hit[i] becomes what any_hit finds for rays[i], likewise.
template <class T, class Leaves, class Accel, class Probe>
void packet_any_hits(const Accel& accel, const Leaves& leaves, std::span<const Ray<T>> rays,
                     std::span<std::uint8_t> is_hit, Probe& probe) {
  detail::trace_packets<AnyQuery<T, Leaves>>(accel, leaves, rays, is_hit, probe);
}

}  // namespace sightline
