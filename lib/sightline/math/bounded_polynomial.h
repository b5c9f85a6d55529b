#pragma once
/// Polynomials whose values come with a proven bound, at the cost of a few operations.

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "sightline/math/ball.h"

namespace sightline {

/// What the numbers N of a polynomial are computed in, and whether bounds are kept.
template <class N>
struct Arithmetic {
  static_assert(std::is_floating_point_v<N>);
  using Number = N;
  static constexpr bool is_proven = false;
  static N middle(const N& x) { return x; }
  static double radius(const N&) { return 0; }
};
template <class M>
struct Arithmetic<Ball<M>> {
  using Number = M;
  static constexpr bool is_proven = true;
  static M middle(const Ball<M>& x) { return x.mid; }
  static double radius(const Ball<M>& x) { return x.radius; }
};

namespace detail {

template <class T>
requires std::is_floating_point_v<T>
double leading_of(T x) { return static_cast<double>(x); }
inline double leading_of(const DoubleDouble& x) { return x.high; }

template <class T>
requires std::is_floating_point_v<T>
bool is_less(T a, T b) { return a < b; }
inline bool is_less(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

template <class T>
requires std::is_floating_point_v<T> T multiply_add(T a, T b, T c) { return std::fma(a, b, c); }
inline DoubleDouble multiply_add(const DoubleDouble& a, const DoubleDouble& b, const DoubleDouble& c) {
  return a * b + c;
}

/// More than what Horner's rule for degree 4 rounds by, as a share of sum |c_i t^i|; twice that, so that it pays for
/// the rounding of the bound as well.
template <class M>
inline constexpr double horner_unit = 0;  // unused: not proven
template <>
inline constexpr double horner_unit<double> = 0x1p-50;  // 4 fused operations of 2^-53
template <>
inline constexpr double horner_unit<DoubleDouble> = 0x1p-95;  // 8 operations of 10 * 2^-106 (Joldes et al., 2017)

/// More than what underflow adds in one step of Horner's rule.
inline constexpr double underflow = 0x1p-1000;

}  // namespace detail

/// A value, its slope as computed, and a proven bound of the value's error (0 where nothing is proven).
template <class M>
struct BoundedValue {
  M value;
  double slope;
  double bound;

  /// -1 or 1 where certain, else 0; as computed where nothing is proven. Never certain after an overflow.
  int sign() const {
    const double v = detail::leading_of(value), size = std::fabs(v);
    return size > bound && size <= std::numeric_limits<double>::max() ? (v > 0 ? 1 : -1) : 0;
  }
};

/// sum c_i t^i. For t exact, the value computed is off by at most sum bound_i |t|^i, from the radii of the coefficients
/// and from all rounding.
template <class A, int n>
struct BoundedPolynomial {
  using M = typename A::Number;
  std::array<M, n + 1> c;
  std::array<double, n + 1> bound;

  BoundedValue<M> at(const M& t) const {
    M value = c[n];
    double slope = 0, off = 0;
    const double x = detail::leading_of(t);
    for (std::size_t i = n; i-- > 0;) {
      slope = std::fma(slope, x, detail::leading_of(value));
      value = detail::multiply_add(value, t, c[i]);
    }
    if constexpr (A::is_proven) {
      const double size = std::fabs(x) * (1 + 0x1p-50);  // with the lower part of two
      off = bound[n];
      for (std::size_t i = n; i-- > 0;) off = std::fma(off, size, bound[i]);
    }
    return {value, slope, off};
  }

  BoundedPolynomial<A, n - 1> derivative() const {
    BoundedPolynomial<A, n - 1> d;
    for (std::size_t i = 0; i < n; ++i) {
      d.c[i] = c[i + 1] * M(static_cast<double>(i + 1));
      // Twice the unit of bound_(i+1) is left for this rounding, at each of the levels.
      d.bound[i] = bound[i + 1] * static_cast<double>(i + 1) * (1 + 0x1p-48) +
                   detail::horner_unit<M> * std::fabs(detail::leading_of(d.c[i]));
    }
    return d;
  }

  /// More than half of the largest |second derivative| within |t| <= size.
  double half_curvature(double size) const {
    double sum = 0;
    for (std::size_t i = n; i >= 2; --i) {
      const double pairs = static_cast<double>(i * (i - 1)) * (0.5 + 0x1p-30);
      sum = sum * size + pairs * (std::fabs(detail::leading_of(c[i])) + bound[i]);
    }
    return sum;
  }

  /// More than the largest |derivative's error| of slopes at |t| <= size.
  double slope_bound(double size) const {
    double sum = 0;
    for (std::size_t i = n; i >= 1; --i) {
      const double each = bound[i] + 0x1p-49 * std::fabs(detail::leading_of(c[i]));
      sum = sum * size + static_cast<double>(i) * (1 + 0x1p-30) * each;
    }
    return sum;
  }
};

template <class N, int n>
BoundedPolynomial<Arithmetic<N>, n> bounded(const std::array<N, 5>& coefficients) {
  using A = Arithmetic<N>;
  BoundedPolynomial<A, n> p;
  for (std::size_t i = 0; i <= n; ++i) {
    p.c[i] = A::middle(coefficients[i]);
    p.bound[i] = 0;
    if constexpr (A::is_proven) {
      p.bound[i] = A::radius(coefficients[i]) * (1 + 0x1p-40) + detail::underflow +
                   detail::horner_unit<typename A::Number> * std::fabs(detail::leading_of(p.c[i]));
    }
  }
  return p;
}

}  // namespace sightline
