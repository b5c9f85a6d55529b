#pragma once
/// Real roots, one degree after the other: between two roots of the derivative a polynomial is monotonic, so its signs
/// there tell whether it has a root.
///   C1  Outside the clusters of a polynomial it has no root. Clusters are ascending and apart.
///   C2  A simple cluster has exactly one root, where the polynomial changes its sign. Of any other nothing is known.
/// With bounds all this is proven, whatever the coefficients in their balls: what a cluster of the derivative holds
/// does not matter as long as the polynomial has one sign all over it. Without bounds it holds of the signs as
/// computed.

#include <algorithm>

#include "sightline/math/bounded_polynomial.h"

namespace sightline {
namespace detail {

/// Roots within [lo, hi], near mid.
template <class M>
struct Cluster {
  M lo, mid, hi;
  int multiplicity;
  bool is_simple;
};

template <class M>
struct Clusters {
  std::array<Cluster<M>, 6> at;
  int count = 0;

  void add(const Cluster<M>& cluster) {
    if (count < 6) at[static_cast<std::size_t>(count++)] = cluster;
  }
};

/// One place where the sign is known; `reach` is how far off a parabola through it, level there, has its roots.
template <class M>
struct Mark {
  M t;
  int sign;
  double reach;  ///< 0 where not known
};

template <class M>
M moved(const M& t, double by) {
  if constexpr (std::is_same_v<M, float>) {
    return t + static_cast<float>(by);
  } else {
    return t + M(by);
  }
}

template <class M>
double distance(const M& a, const M& b) {
  return leading_of(b + -a);
}

template <class M>
inline constexpr double last_place = 0x1p-52;
template <>
inline constexpr double last_place<float> = 0x1p-23;
template <>
inline constexpr double last_place<DoubleDouble> = 0x1p-98;

/// A step of Newton's this small, relative to t, is the last: what is left is its square, and of slopes in double
/// 2^-50.
template <class M>
inline constexpr double last_step = 0x1p-28;
template <>
inline constexpr double last_step<float> = 0x1p-13;
template <>
inline constexpr double last_step<DoubleDouble> = 0x1p-52;

/// The root between two marks of unlike signs. Newton's steps, halving where they leave what is known to hold the root;
/// then the smallest interval, growing by fours, whose ends have certain signs.
template <class A, int n, class M = typename A::Number>
Cluster<M> simple_root(const BoundedPolynomial<A, n>& f, const Mark<M>& from, const Mark<M>& to) {
  M lo = from.t, hi = to.t;
  const bool is_from = from.reach > 0 && !(to.reach > 0 && to.reach < from.reach);
  const double reach = is_from ? from.reach : -to.reach;
  M t = moved(is_from ? from.t : to.t, reach);
  const auto halfway = [&] { return moved(lo, 0.5 * distance(lo, hi)); };
  if (reach == 0 || !(is_less(lo, t) && is_less(t, hi))) t = halfway();
  double width = 0;  // about what t may be off by
  for (int round = 0; round < 200; ++round) {
    const BoundedValue<M> at = f.at(t);
    const double value = leading_of(at.value);
    width = (std::fabs(value) + 2 * at.bound) / std::fabs(at.slope);
    if (std::fabs(value) <= at.bound) break;  // of what is not proven: a zero
    ((value > 0) == (from.sign > 0) ? lo : hi) = t;
    const double by = -value / at.slope;
    M next = moved(t, by);
    const bool is_inside = is_less(lo, next) && is_less(next, hi);
    const double share = std::fabs(by) / std::fabs(leading_of(t));
    if (share <= last_step<M>) {
      if (is_inside) {
        t = next;
        width = 2 * at.bound / std::fabs(at.slope) + std::fabs(by) * (4 * share + 0x1p-48);
      }
      break;
    }
    if (!is_inside) next = halfway();
    if (!(is_less(lo, next) && is_less(next, hi))) break;
    t = next;
  }
  if constexpr (!A::is_proven) {
    return {t, t, t, 1, true};
  } else {
    lo = from.t;
    hi = to.t;
    width += last_place<M> * std::fabs(leading_of(t)) + underflow;
    for (bool is_low = true, is_high = true; is_low || is_high; width *= 4) {
      if (!(width <= std::numeric_limits<double>::max())) break;
      if (is_low) {
        const M x = moved(t, -width);
        if (!is_less(from.t, x)) {
          is_low = false;
        } else if (f.at(x).sign() == from.sign) {
          lo = x, is_low = false;
        }
      }
      if (is_high) {
        const M x = moved(t, width);
        if (!is_less(x, to.t)) {
          is_high = false;
        } else if (f.at(x).sign() == to.sign) {
          hi = x, is_high = false;
        }
      }
    }
    return {lo, t, hi, 1, true};
  }
}

/// The sign all over a cluster of the derivative, and the parabola there.
template <class A, int n, class M = typename A::Number>
Mark<M> mark_on(const BoundedPolynomial<A, n>& f, const Cluster<M>& extremum) {
  BoundedValue<M> at = f.at(extremum.mid);
  double curvature = 0;  // half the second derivative, roughly: it only guides the search
  const double x = leading_of(extremum.mid);
  for (std::size_t i = n; i >= 2; --i) {
    curvature = curvature * x + static_cast<double>(i * (i - 1) / 2) * leading_of(f.c[i]);
  }
  const double reach = std::sqrt(std::fabs(leading_of(at.value) / curvature));
  if constexpr (A::is_proven) {
    const double width =
        std::max(distance(extremum.mid, extremum.hi), distance(extremum.lo, extremum.mid)) * (1 + 0x1p-40);
    const double size = (std::fabs(x) + width) * (1 + 0x1p-40);
    // Taylor's formula around the middle.
    const double change = (std::fabs(at.slope) + f.slope_bound(size) + f.half_curvature(size) * width) * width;
    at.bound = (at.bound + change) * (1 + 0x1p-40);
  }
  return {extremum.mid, at.sign(), std::isfinite(reach) ? reach : 0};
}

/// Moves from `mark`, whose sign is not known, by growing steps to where it is, or to `limit`.
template <class A, int n, class M = typename A::Number>
bool find_sign(const BoundedPolynomial<A, n>& f, Mark<M>& mark, const Mark<M>& limit) {
  const double direction = is_less(mark.t, limit.t) ? 1 : -1;
  const double far = std::fabs(distance(mark.t, limit.t));
  const double least = last_place<M> * std::fabs(leading_of(mark.t)) + underflow;
  for (double by = std::max({least, mark.reach, far * 0x1p-60}); by < far; by *= 2) {
    const M t = moved(mark.t, direction * by);
    const int sign = f.at(t).sign();
    if (sign == 0) continue;
    mark = {t, sign, 0};
    return true;
  }
  mark = limit;
  return limit.sign != 0;
}

/// A power of two beyond all roots (Fujiwara, 1916); infinite where the leading coefficient is not certain.
template <class A, int n>
double root_limit(const BoundedPolynomial<A, n>& f) {
  const double lead = std::fabs(leading_of(f.c[n])) - 2 * f.bound[n];
  if (!(lead > 0)) return std::numeric_limits<double>::infinity();
  const int lead_exponent = std::ilogb(lead);
  int limit = std::numeric_limits<int>::min();
  for (int i = 1; i <= n; ++i) {
    const double size =
        std::fabs(leading_of(f.c[static_cast<std::size_t>(n - i)])) + 2 * f.bound[static_cast<std::size_t>(n - i)];
    if (size == 0) continue;
    if (!std::isfinite(size)) return std::numeric_limits<double>::infinity();
    const int bits = std::ilogb(size) + 1 - lead_exponent;  // |c / lead| < 2^bits
    limit = std::max(limit, bits >= 0 ? (bits + i - 1) / i : -(-bits / i));
  }
  return std::ldexp(1.0, std::max(limit + 2, -1000));
}

/// C1 and C2. The leading coefficient is certain not to be 0, and `limit` is beyond all roots of f and its derivatives
/// (which are no farther than those of f: Gauss and Lucas).
template <class A, int n, class M = typename A::Number>
Clusters<M> clusters_of(const BoundedPolynomial<A, n>& f, double limit) {
  Clusters<M> found;
  if constexpr (n == 1) {
    const M t = -f.c[0] / f.c[1];
    double width = 0;
    if constexpr (A::is_proven) {
      const BoundedValue<M> at = f.at(t);
      const double least = std::fabs(leading_of(f.c[1])) * (1 - 0x1p-50) - f.bound[1];  // its slope
      width = (std::fabs(leading_of(at.value)) + at.bound) / least * (1 + 0x1p-40) + underflow;
      width += 2 * last_place<M> * std::fabs(leading_of(t));  // the rounding of the ends
    }
    found.add({moved(t, -width), t, moved(t, width), 1, true});
    return found;
  }
  const int rising = leading_of(f.c[n]) > 0 ? 1 : -1;
  Mark<M> from{moved(M{}, -limit), n % 2 == 0 ? rising : -rising, 0};
  const Mark<M> end{moved(M{}, limit), rising, 0};
  const auto add_between = [&](const Mark<M>& a, const Mark<M>& b) {
    if (a.sign * b.sign < 0) found.add(simple_root(f, a, b));
  };
  if constexpr (n > 1) {
    const Clusters<M> extrema = clusters_of(f.derivative(), limit);
    int slope = -from.sign;
    for (int k = 0; k < extrema.count; ++k) {
      const Cluster<M>& extremum = extrema.at[static_cast<std::size_t>(k)];
      const Mark<M> here = mark_on(f, extremum);
      if (here.sign != 0) {
        add_between(from, {extremum.lo, here.sign, here.reach});
        from = {extremum.hi, here.sign, here.reach};
        slope = extremum.multiplicity % 2 == 0 ? slope : -slope;
        continue;
      }
      int multiplicity = extremum.multiplicity;
      if constexpr (!A::is_proven) {
        found.add({here.t, here.t, here.t, multiplicity + 1, multiplicity == 0});
        from = here;
        continue;
      }
      // Out to where the sign is certain; over the next extrema while it is not.
      Mark<M> left{extremum.lo, 0, here.reach}, right{extremum.hi, 0, here.reach};
      find_sign(f, left, from);
      bool is_alone = extremum.is_simple;
      for (;;) {
        const bool is_last = k + 1 == extrema.count;
        const Mark<M> next = is_last ? end : mark_on(f, extrema.at[static_cast<std::size_t>(k + 1)]);
        const M stop = is_last ? end.t : extrema.at[static_cast<std::size_t>(k + 1)].lo;
        if (find_sign(f, right, Mark<M>{stop, next.sign, 0})) break;
        ++k;
        is_alone = false;
        multiplicity += extrema.at[static_cast<std::size_t>(k)].multiplicity;
        right.t = extrema.at[static_cast<std::size_t>(k)].hi;
      }
      add_between(from, left);
      // A hill whose feet are above zero, or a valley whose rims are below it, holds no root.
      const bool is_empty = is_alone && left.sign == right.sign && left.sign == slope;
      if (!is_empty) found.add({left.t, extremum.mid, right.t, multiplicity + 1, false});
      from = right;
      slope = multiplicity % 2 == 0 ? slope : -slope;
    }
  }
  add_between(from, end);
  return found;
}

}  // namespace detail
}  // namespace sightline
