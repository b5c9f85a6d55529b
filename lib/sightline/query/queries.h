#pragma once
/// Closest hit, any hit and all hits, written once over every structure's `traverse`.
///
/// T is the precision of the ray and of what is reported: tests run in double (exactly, where double cannot tell), and
/// t is rounded to T before hits are compared. So float queries are watertight and double queries precise.

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/query/leaves.h"

namespace sightline {
namespace detail {

/// Calls see(hit) for every crossing of the leaf's shapes within the ray's range.
template <class T, class Leaves, class Prepared, class See>
void for_each_hit(const Leaves& leaves, const Prepared& prepared, const Ray<T>& ray, LeafRange leaf, See&& see) {
  for (std::uint32_t position = leaf.first; position < leaf.first + leaf.count; ++position) {
    prepared.for_each_crossing(leaves.shape(position), [&](const Crossing& crossing) {
      const T t = static_cast<T>(crossing.t) + T(0);  // one zero, not two
      if (t > ray.t_min && t <= ray.t_max && t < std::numeric_limits<T>::infinity()) {
        see(Hit<T>{t, leaves.id(position), static_cast<T>(crossing.u), static_cast<T>(crossing.v)});
      }
    });
  }
}

}  // namespace detail

/// The nearest hit; of equally near ones that of the lowest id. A miss where there is none.
template <class T, class Leaves, class Accel, class Probe>
Hit<T> closest_hit(const Accel& accel, const Leaves& leaves, const Ray<T>& ray, Probe& probe) {
  if (!is_valid(ray)) return {};
  const auto prepared = leaves.prepare(to_double(ray));
  Hit<T> best;
  accel.traverse(
      ray,
      [&](LeafRange leaf) {
        detail::for_each_hit(leaves, prepared, ray, leaf, [&](const Hit<T>& hit) {
          if (is_closer(hit, best)) best = hit;
        });
        return std::min(best.t, ray.t_max);
      },
      probe);
  return best;
}

/// Whether anything is hit; stops at the first hit found, whichever it is.
template <class T, class Leaves, class Accel, class Probe>
bool any_hit(const Accel& accel, const Leaves& leaves, const Ray<T>& ray, Probe& probe) {
  if (!is_valid(ray)) return false;
  const auto prepared = leaves.prepare(to_double(ray));
  bool is_found = false;
  accel.traverse(
      ray,
      [&](LeafRange leaf) {
        for (std::uint32_t position = leaf.first; position < leaf.first + leaf.count && !is_found; ++position) {
          detail::for_each_hit(leaves, prepared, ray, {position, 1}, [&](const Hit<T>&) { is_found = true; });
        }
        return is_found ? -std::numeric_limits<T>::infinity() : ray.t_max;
      },
      probe);
  return is_found;
}

/// Every hit, nearest first, equal ones by id, each once however many leaves hold its primitive. A closed shape gives
/// the crossing where the ray enters and the one where it leaves.
template <class T, class Leaves, class Accel, class Probe>
std::vector<Hit<T>> all_hits(const Accel& accel, const Leaves& leaves, const Ray<T>& ray, Probe& probe) {
  if (!is_valid(ray)) return {};
  const auto prepared = leaves.prepare(to_double(ray));
  std::vector<Hit<T>> hits;
  accel.traverse(
      ray,
      [&](LeafRange leaf) {
        detail::for_each_hit(leaves, prepared, ray, leaf, [&](const Hit<T>& hit) { hits.push_back(hit); });
        return ray.t_max;
      },
      probe);
  std::sort(hits.begin(), hits.end(), is_closer<T>);
  hits.erase(std::unique(hits.begin(), hits.end()), hits.end());
  return hits;
}

}  // namespace sightline
