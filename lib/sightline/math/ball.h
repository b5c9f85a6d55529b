#pragma once
/// Numbers with a proven bound, for decisions that are made only where they are certain.

#include <cmath>
#include <limits>
#include <type_traits>

#include "sightline/math/double_double.h"

namespace sightline {

/// What is known of a number's sign: 1, 0 or -1, or 0 and not certain.
struct Sign {
  int value;
  bool is_certain;
};

/// Rounded numbers have the sign that was computed.
template <class T>
requires std::is_floating_point_v<T> Sign sign_of(T x) { return {(x > 0) - (x < 0), true}; }

namespace detail {

/// How a type of midpoints rounds: by at most `unit` of the result.
template <class M>
struct Rounding;

template <>
struct Rounding<double> {
  static constexpr double unit = 0x1p-53;
  static double leading(double x) { return x; }
};
template <>
struct Rounding<DoubleDouble> {
  static constexpr double unit = 0x1p-99;  // 10 u^2 = 10 * 2^-106
  static double leading(const DoubleDouble& x) { return x.high; }
};

}  // namespace detail

/// All numbers within `radius` of `mid`. Operations contain every result that operands within their balls can have.
///   A1  A radius is computed by a few roundings to nearest of positive terms; `widen` is more than these.
///   A2  Where a result is so small that its rounding error is no longer a double, `step` is more than it.
///   A3  A result that overflows has a radius that is not finite, so that nothing about it is certain.
/// Sums and products of doubles have exactly their rounding error as radius, so that what is exact stays certain.
/// Rump, "Fast and Parallel Interval Arithmetic", 1999; van der Hoeven, "Ball Arithmetic", 2010.
template <class M>
struct Ball {
  M mid{};
  double radius = 0;

  Ball() = default;
  explicit Ball(double x) : mid(x) {}
  Ball(const M& m, double r) : mid(m), radius(r) {}

  double middle() const { return detail::Rounding<M>::leading(mid); }
  double size() const { return std::fabs(middle()); }
  Ball operator-() const { return {-mid, radius}; }
};

using DoubleBall = Ball<double>;
using WideBall = Ball<DoubleDouble>;

namespace detail {

inline constexpr double widen = 1 + 0x1p-48;  // A1
inline constexpr double smallest = 0x1p-900;  // A2: below it, errors of products may underflow
inline constexpr double step = 0x1p-1000;     // A2

/// A3: infinity where a number is not finite.
inline double guarded(double x, double radius) {
  return std::isfinite(x) ? radius : std::numeric_limits<double>::infinity();
}

/// A2 for a product: parts of its radius underflow as well, wherever a factor is not exact. Only 0 itself stays 0.
template <class A>
double lost_by_product(const A& a, const A& b, double high) {
  const bool is_zero = (a.size() == 0 && a.radius == 0) || (b.size() == 0 && b.radius == 0);
  return !is_zero && (std::fabs(high) < smallest || a.radius > 0 || b.radius > 0) ? step : 0;
}

/// What the factors' radii make of a product's, but for roundings.
template <class M>
double spread_of_product(const Ball<M>& a, const Ball<M>& b) {
  return a.size() * b.radius + b.size() * a.radius + a.radius * b.radius;
}

}  // namespace detail

template <class M>
Sign sign_of(const Ball<M>& x) {
  const double middle = x.middle();
  // The leading part of two is off by half a unit in its last place; doubling what may be off covers that.
  if (x.size() * (1 - 0x1p-50) > x.radius) return {middle > 0 ? 1 : -1, true};
  return {0, middle == 0 && x.radius == 0};
}

inline DoubleBall operator+(const DoubleBall& a, const DoubleBall& b) {
  const auto [high, low] = two_sum(a.mid, b.mid);
  return {high, detail::guarded(high, (a.radius + b.radius + std::fabs(low)) * detail::widen)};
}

inline DoubleBall operator*(const DoubleBall& a, const DoubleBall& b) {
  const auto [high, low] = two_product(a.mid, b.mid);
  double radius = (std::fabs(low) + detail::spread_of_product(a, b)) * detail::widen;
  radius += detail::lost_by_product(a, b, high);
  return {high, detail::guarded(high, radius)};
}

inline WideBall operator+(const WideBall& a, const WideBall& b) {
  const DoubleDouble sum = a.mid + b.mid;
  const double radius =
      (a.radius + b.radius + detail::Rounding<DoubleDouble>::unit * std::fabs(sum.high)) * detail::widen;
  return {sum, detail::guarded(sum.high, radius)};
}

inline WideBall operator*(const WideBall& a, const WideBall& b) {
  const DoubleDouble product = a.mid * b.mid;
  double radius = (detail::Rounding<DoubleDouble>::unit * std::fabs(product.high) + detail::spread_of_product(a, b)) *
                  detail::widen;
  radius += detail::lost_by_product(a, b, product.high);
  return {product, detail::guarded(product.high, radius)};
}

template <class M>
Ball<M> operator-(const Ball<M>& a, const Ball<M>& b) {
  return a + -b;
}

/// Not certain of anything where the divisor may be zero.
template <class M>
Ball<M> operator/(const Ball<M>& a, const Ball<M>& b) {
  const M quotient = a.mid / b.mid;
  const double high = std::fabs(detail::Rounding<M>::leading(quotient));
  const double least = b.size() * (1 - 0x1p-50) - b.radius;
  if (!(least > 0)) return {quotient, std::numeric_limits<double>::infinity()};
  constexpr double unit = detail::Rounding<M>::unit;
  double radius = (a.radius / least + high * (b.radius / least) + high * unit) * (1 + 0x1p-40);
  if (high < detail::smallest && (a.middle() != 0 || a.radius > 0)) radius += detail::step;
  return {quotient, detail::guarded(high, radius)};
}

/// Of a ball of positive numbers; not certain of anything where some are not.
template <class M>
Ball<M> sqrt(const Ball<M>& a) {
  using std::sqrt;
  if (a.middle() == 0 && a.radius == 0) return a;
  const double least = a.size() * (1 - 0x1p-50) - a.radius;
  if (!(a.middle() > 0 && least > 0)) return {a.mid, std::numeric_limits<double>::infinity()};
  const M root = sqrt(a.mid);
  const double high = detail::Rounding<M>::leading(root);
  constexpr double unit = detail::Rounding<M>::unit;
  // |sqrt(x) - sqrt(y)| = |x - y| / (sqrt(x) + sqrt(y))
  const double radius = (a.radius / high + high * unit) * (1 + 0x1p-40);
  return {root, detail::guarded(high, radius)};
}

}  // namespace sightline
