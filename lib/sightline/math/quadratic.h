#pragma once
/// Real roots of polynomials of degree one and two, in any type of numbers.

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "sightline/math/ball.h"
#include "sightline/math/root_list.h"

namespace sightline {
namespace detail {

template <class T>
requires std::is_floating_point_v<T> Root root_of(T t, int multiplicity) {
  return {static_cast<double>(t), 0, multiplicity};
}
inline Root root_of(const DoubleBall& t, int multiplicity) { return {t.mid, t.radius, multiplicity}; }
inline Root root_of(const WideBall& t, int multiplicity) {
  return {t.mid.high, (t.radius + std::fabs(t.mid.low)) * widen, multiplicity};
}

/// a b - c d with one rounding's error (Kahan; Jeannerod, Louvet and Muller, "Further Analysis of Kahan's Algorithm for
/// the Accurate Computation of 2 x 2 Determinants", 2013).
template <class T>
requires std::is_floating_point_v<T> T difference_of_products(T a, T b, T c, T d) {
  const T product = c * d;
  return std::fma(a, b, -product) + std::fma(-c, d, product);
}
inline WideBall difference_of_products(const WideBall& a, const WideBall& b, const WideBall& c, const WideBall& d) {
  return a * b - c * d;
}
/// Of exact factors only what is below the last digit is lost, however much of the products cancels.
inline DoubleBall difference_of_products(const DoubleBall& a, const DoubleBall& b, const DoubleBall& c,
                                         const DoubleBall& d) {
  const auto [one, one_low] = two_product(a.mid, b.mid);
  const auto [other, other_low] = two_product(c.mid, d.mid);
  const auto [high, low] = two_sum(one, -other);
  const auto [lows, lows_rest] = two_sum(one_low, -other_low);
  const auto [tail, tail_rest] = two_sum(low, lows);
  const auto [mid, rest] = two_sum(high, tail);
  const double radius = (std::fabs(rest) + std::fabs(tail_rest) + std::fabs(lows_rest) + spread_of_product(a, b) +
                         spread_of_product(c, d)) *
                        widen;
  return {mid, guarded(mid, radius + lost_by_product(a, b, one) + lost_by_product(c, d, other))};
}

template <class T>
requires std::is_floating_point_v<T> T scaled(T x, int exponent) { return std::ldexp(x, exponent); }
inline DoubleDouble scaled(const DoubleDouble& x, int exponent) {
  return {std::ldexp(x.high, exponent), std::ldexp(x.low, exponent)};
}
/// A2 where digits are lost.
template <class M>
Ball<M> scaled(const Ball<M>& x, int exponent) {
  const double radius = std::ldexp(x.radius, exponent) + (exponent < 0 && (x.size() > 0 || x.radius > 0) ? step : 0);
  return {scaled(x.mid, exponent), radius};
}

template <class T>
requires std::is_floating_point_v<T>
double leading_part(T x) { return static_cast<double>(x); }
template <class M>
double leading_part(const Ball<M>& x) {
  return x.middle();
}

}  // namespace detail

/// Of a t + b; where both are 0 there is no root, and begins_negative says that b <= 0.
template <class N>
RootList linear_roots(const N& a, const N& b) {
  RootList list;
  const Sign slope = sign_of(a);
  if (!slope.is_certain) {
    list.is_certain = false;
  } else if (slope.value == 0) {
    const Sign level = sign_of(b);
    list.is_certain = level.is_certain;
    list.begins_negative = level.value <= 0;
  } else {
    list.add(detail::root_of(-b / a, 1));
    list.begins_negative = slope.value > 0;
  }
  return list;
}

namespace detail {

/// Of a t^2 + 2 b t + c with a != 0, of which nothing over- or underflows.
template <class N>
void add_quadratic_roots(const N& a, const N& b, const N& c, bool opens_up, RootList& list) {
  using std::sqrt;
  const N discriminant = difference_of_products(b, b, a, c);
  const Sign kind = sign_of(discriminant);
  list.is_certain = kind.is_certain;
  list.begins_negative = !opens_up;
  if (!kind.is_certain || kind.value < 0) return;
  if (kind.value == 0) return list.add(root_of(-b / a, 2));
  const N root = sqrt(discriminant);
  const bool adds = leading_part(b) > 0;
  const N q = adds ? -(b + root) : root - b;
  Root one = root_of(q / a, 1), other = root_of(c / q, 1);
  if (opens_up != adds) std::swap(one, other);
  if constexpr (std::is_floating_point_v<N>) {
    if (one.t > other.t) std::swap(one, other);  // so close that rounding has changed their order
  }
  list.add(one);
  list.add(other);
}

}  // namespace detail

/// Of a t^2 + 2 b t + c. The root without cancellation first, the other one from the product of both (Kahan, "On the
/// Cost of Floating-Point Computation Without Extra-Precise Arithmetic", 2004). What could over- or underflow is
/// brought into range by powers of two, of the coefficients and of t.
template <class N>
RootList quadratic_roots(const N& a, const N& b, const N& c) {
  using detail::leading_part, detail::scaled;
  const Sign leading = sign_of(a);
  if (leading.is_certain && leading.value == 0) return linear_roots(b + b, c);
  RootList list;
  list.is_certain = leading.is_certain;
  if (!leading.is_certain) return list;
  const double size_a = std::fabs(leading_part(a)), size_b = std::fabs(leading_part(b)),
               size_c = std::fabs(leading_part(c));
  constexpr double large = std::is_same_v<N, float> ? 0x1p+62 : 0x1p+500;
  const double least = std::min(size_a, std::max(size_b, size_c));
  const auto are_below = [&](double limit) { return size_a < limit && size_b < limit && size_c < limit; };  // no NaN
  if (are_below(large) && least * large > 1) {
    detail::add_quadratic_roots(a, b, c, leading.value > 0, list);
  } else if (are_below(std::numeric_limits<double>::infinity())) {
    const int shift = size_c == 0 ? 0 : (std::ilogb(size_c) - std::ilogb(size_a)) / 2;  // a and c alike
    const int down =
        -std::max(std::ilogb(size_c == 0 ? size_a : size_c), size_b == 0 ? INT_MIN / 2 : std::ilogb(size_b) + shift);
    detail::add_quadratic_roots(scaled(a, 2 * shift + down), scaled(b, shift + down), scaled(c, down),
                                leading.value > 0, list);
    for (int i = 0; i < list.count; ++i) {
      Root& root = list.roots[static_cast<std::size_t>(i)];
      root = {std::ldexp(root.t, shift), std::ldexp(root.radius, shift) + (root.radius > 0 ? detail::step : 0),
              root.multiplicity};
    }
  } else {
    list.is_certain = std::is_floating_point_v<N>;
  }
  return list;
}

}  // namespace sightline
