#pragma once
/// Closest hit, any hit and all hits, written once over every structure's `traverse`.
///
/// T is the precision of the ray and of what is reported; t is rounded to it before hits are compared. How accurate the
/// tests are is up to the leaves (leaves.h): exact decisions, with t computed in double, unless they are of level
/// `fast`. So by default float queries are watertight and double queries precise.

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/query/leaves.h"

namespace sightline {
namespace detail {

/// Whether a crossing at t, in the query's precision, is a hit.
template <class T>
bool is_in_range(const Ray<T>& ray, T t) {
  return t > ray.t_min && t <= ray.t_max && t < std::numeric_limits<T>::infinity();
}

/// The crossing's parameter in the query's precision, with one zero, not two.
template <class T>
T parameter(const Crossing& crossing) {
  return static_cast<T>(crossing.t) + T(0);
}

/// Leaves whose shapes have several crossings may tell the first alone, which is all that one hit needs.
template <class Leaves, class Prepared, class T, class See>
[[gnu::always_inline]] inline void for_first_crossings(const Leaves& leaves, Prepared& ray, LeafRange leaf, T far,
                                                       See&& see) {
  if constexpr (requires { leaves.for_first_crossings(ray, leaf, far, see); }) {
    leaves.for_first_crossings(ray, leaf, far, see);
  } else {
    leaves.for_each_crossing(ray, leaf, far, see);
  }
}

/// A ray as the leaves test with it.
template <class T, class Leaves>
using Prepared = decltype(std::declval<const Leaves&>().prepare(std::declval<const Ray<T>&>()));

template <class T>
Hit<T> hit_of(T t, std::uint32_t id, const Crossing& crossing) {
  return {t, id, static_cast<T>(crossing.u), static_cast<T>(crossing.v)};
}

/// Takes a crossing of the ray for the best hit where it is nearer.
template <class T>
[[gnu::always_inline]] inline void keep_closer(const Ray<T>& ray, std::uint32_t id, const Crossing& crossing,
                                               Hit<T>& best) {
  const T t = parameter<T>(crossing);
  if (!(t <= best.t) || !is_in_range(ray, t)) return;
  const Hit<T> hit = hit_of(t, id, crossing);
  if (is_closer(hit, best)) best = hit;
}

}  // namespace detail

/// Leaves that can be brought near before they are tested.
template <class L>
concept FetchingLeaves = requires(const L& leaves, LeafRange leaf) {
  leaves.fetch(leaf);
};

/// What a ray looks for and has found so far, told of one leaf after the other.
template <class T, class Leaves>
struct ClosestQuery {
  using Result = Hit<T>;
  static constexpr bool takes_any_order = false;

  const Ray<T>& ray;
  detail::Prepared<T, Leaves> prepared;
  Hit<T> best{};

  ClosestQuery(const Leaves& leaves, const Ray<T>& its_ray) : ray(its_ray), prepared(leaves.prepare(its_ray)) {}

  /// Returns the far limit.
  [[gnu::always_inline]] T visit(const Leaves& leaves, LeafRange leaf) {
    detail::for_first_crossings(leaves, prepared, leaf, std::min(best.t, ray.t_max),
                                [&](std::uint32_t id, const Crossing& crossing) {
                                  detail::keep_closer(ray, id, crossing, best);
                                  return true;
                                });
    return std::min(best.t, ray.t_max);
  }
  const Result& result() const { return best; }
};

template <class T, class Leaves>
struct AnyQuery {
  using Result = bool;
  static constexpr bool takes_any_order = true;

  const Ray<T>& ray;
  detail::Prepared<T, Leaves> prepared;
  bool is_found = false;

  AnyQuery(const Leaves& leaves, const Ray<T>& its_ray) : ray(its_ray), prepared(leaves.prepare(its_ray)) {}

  [[gnu::always_inline]] T visit(const Leaves& leaves, LeafRange leaf) {
    if constexpr (requires { leaves.has_crossing(prepared, leaf); }) {
      is_found = leaves.has_crossing(prepared, leaf);
    } else {
      detail::for_first_crossings(leaves, prepared, leaf, ray.t_max, [&](std::uint32_t, const Crossing& crossing) {
        is_found = detail::is_in_range(ray, detail::parameter<T>(crossing));
        return !is_found;
      });
    }
    return is_found ? -std::numeric_limits<T>::infinity() : ray.t_max;
  }
  Result result() const { return is_found; }
};

/// Tells a query of the leaves that a traversal comes to.
template <class Query, class Leaves>
struct QueryVisitor {
  static constexpr bool takes_any_order = Query::takes_any_order;

  Query& query;
  const Leaves& leaves;

  [[gnu::always_inline]] auto operator()(LeafRange leaf) const { return query.visit(leaves, leaf); }
  void fetch(LeafRange leaf) const requires FetchingLeaves<Leaves> { leaves.fetch(leaf); }
};

template <class Query, class Leaves>
QueryVisitor(Query&, const Leaves&) -> QueryVisitor<Query, Leaves>;

/// The nearest hit; of equally near ones that of the lowest id. A miss where there is none.
template <class T, class Leaves, class Accel, class Probe>
Hit<T> closest_hit(const Accel& accel, const Leaves& leaves, const Ray<T>& ray, Probe& probe) {
  ClosestQuery<T, Leaves> query(leaves, ray);
  accel.traverse(ray, QueryVisitor{query, leaves}, probe);
  return query.best;
}

/// Whether anything is hit; stops at the first hit found, whichever it is.
template <class T, class Leaves, class Accel, class Probe>
bool any_hit(const Accel& accel, const Leaves& leaves, const Ray<T>& ray, Probe& probe) {
  AnyQuery<T, Leaves> query(leaves, ray);
  accel.traverse(ray, QueryVisitor{query, leaves}, probe);
  return query.is_found;
}

/// Every hit, nearest first, equal ones by id, each once however many leaves hold its primitive. A closed shape gives
/// the crossing where the ray enters and the one where it leaves.
template <class T, class Leaves, class Accel, class Probe>
std::vector<Hit<T>> all_hits(const Accel& accel, const Leaves& leaves, const Ray<T>& ray, Probe& probe) {
  auto prepared = leaves.prepare(ray);
  std::vector<Hit<T>> hits;
  accel.traverse(
      ray,
      [&](LeafRange leaf) {
        leaves.for_each_crossing(prepared, leaf, ray.t_max, [&](std::uint32_t id, const Crossing& crossing) {
          const T t = detail::parameter<T>(crossing);
          if (detail::is_in_range(ray, t)) hits.push_back(detail::hit_of(t, id, crossing));
          return true;
        });
        return ray.t_max;
      },
      probe);
  std::sort(hits.begin(), hits.end(), is_closer<T>);
  hits.erase(std::unique(hits.begin(), hits.end()), hits.end());
  return hits;
}

}  // namespace sightline
