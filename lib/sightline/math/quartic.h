#pragma once
/// Real roots of polynomials of degree at most four, in any type of numbers.

#include "sightline/math/quadratic.h"
#include "sightline/math/root_clusters.h"

namespace sightline {
namespace detail {

template <class M>
Root root_of(const Cluster<M>& cluster) {
  const double t = leading_of(cluster.mid);
  const double width = std::max(distance(cluster.mid, cluster.hi), distance(cluster.lo, cluster.mid));
  const double low = std::fabs(distance(M(t), cluster.mid));
  return {t, (width + low) * (1 + 0x1p-40), cluster.multiplicity};
}

template <int n, class N>
RootList bracketed_roots(const std::array<N, 5>& coefficients) {
  const auto f = bounded<N, n>(coefficients);
  RootList list;
  const double limit = root_limit(f);
  if (!(limit < 0x1p+1000)) {
    list.is_certain = !Arithmetic<N>::is_proven;
    return list;
  }
  const auto clusters = clusters_of(f, limit);
  list.begins_negative = (leading_of(f.c[n]) < 0) != (n % 2 == 1);
  list.is_certain = clusters.count <= n;
  for (int i = 0; i < std::min(clusters.count, n); ++i) {
    const auto& cluster = clusters.at[static_cast<std::size_t>(i)];
    list.add(root_of(cluster));
    list.is_certain = list.is_certain && (cluster.is_simple || !Arithmetic<N>::is_proven);
  }
  return list;
}

}  // namespace detail

/// Of sum coefficients[i] t^i, of any degree; of the zero polynomial there are none. With balls, roots that cannot be
/// told apart, and those that may not be there, are one of their joint multiplicity, and the list is not certain.
template <class N>
RootList quartic_roots(const std::array<N, 5>& coefficients) {
  RootList list;
  std::size_t degree = 4;
  for (; degree > 0; --degree) {
    const Sign lead = sign_of(coefficients[degree]);
    list.is_certain = lead.is_certain;
    if (!lead.is_certain) return list;
    if (lead.value != 0) break;
  }
  if (degree == 4) return detail::bracketed_roots<4>(coefficients);
  if (degree == 3) return detail::bracketed_roots<3>(coefficients);
  if constexpr (Arithmetic<N>::is_proven) {
    if (degree == 2) return detail::bracketed_roots<2>(coefficients);
  }
  return quadratic_roots(coefficients[2], coefficients[1] * N(0.5f), coefficients[0]);
}

}  // namespace sightline
