#pragma once
/// Doubles that remember what their rounding error is bounded by: the cheapest filter before exact decisions.

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "sightline/math/root_list.h"

namespace sightline {

/// The value of sums and products as rounded, and the same of the sizes of all terms.
///   Z1  Each term is off by at most `depth` factors of 1 + 2^-53 (its own roundings and those of the sums that it goes
///       through), so that the value is off by `depth` times 2^-53 of `size`.
///   Z2  Numbers that go in are at most `largest` in size, and at most eight of them multiply; then nothing overflows,
///       and all that underflow may add up to is below `step`.
/// The depth of an expression is a constant that the compiler knows. Shewchuk, "Adaptive Precision Floating-Point
/// Arithmetic and Fast Robust Geometric Predicates", 1997, bounds the errors of his filters so.
struct SizedDouble {
  double value = 0;
  double size = 0;
  int depth = 0;

  static constexpr double largest = 0x1p+32;
  static constexpr double step = 0x1p-500;

  SizedDouble() = default;
  explicit SizedDouble(double x) : value(x), size(std::fabs(x)) {}
  SizedDouble(double v, double s, int d) : value(v), size(s), depth(d) {}

  /// |exact - value| is at most this; the last factor is for the rounding of sizes and of the bound itself.
  double error() const { return size * (depth * (0x1p-53 * (1 + 0x1p-40))) + step; }
  /// Surely; a product is not, since it may have underflowed.
  bool is_zero() const { return depth == 0 && value == 0; }

  SizedDouble operator-() const { return {-value, size, depth}; }
  friend SizedDouble operator+(const SizedDouble& a, const SizedDouble& b) {
    const double sum = a.value + b.value;
    if (a.depth == 0 && b.depth == 0) return {sum, std::fabs(sum), 1};  // one term, rounded once
    return {sum, a.size + b.size, std::max(a.depth, b.depth) + 1};
  }
  friend SizedDouble operator-(const SizedDouble& a, const SizedDouble& b) { return a + -b; }
  friend SizedDouble operator*(const SizedDouble& a, const SizedDouble& b) {
    return {a.value * b.value, a.size * b.size, a.depth + b.depth + 1};
  }
};

/// The value of sums and products as rounded, and a bound of its error that follows every operation: tighter than sizes
/// where terms cancel early, and dearer. Numbers that go in are limited alike (Z2).
struct BoundedDouble {
  double value = 0;
  double bound = 0;  ///< But for the few roundings that it went through itself, which error() makes up for.

  BoundedDouble() = default;
  explicit BoundedDouble(double x) : value(x) {}
  BoundedDouble(double v, double b) : value(v), bound(b) {}

  double error() const { return bound * (1 + 0x1p-40) + SizedDouble::step; }
  bool is_zero() const { return value == 0 && bound == 0; }

  BoundedDouble operator-() const { return {-value, bound}; }
  friend BoundedDouble operator+(const BoundedDouble& a, const BoundedDouble& b) {
    const double sum = a.value + b.value;
    return {sum, a.bound + b.bound + std::fabs(sum) * 0x1p-53};
  }
  friend BoundedDouble operator-(const BoundedDouble& a, const BoundedDouble& b) { return a + -b; }
  friend BoundedDouble operator*(const BoundedDouble& a, const BoundedDouble& b) {
    const double product = a.value * b.value;
    return {product, std::fabs(a.value) * b.bound + std::fabs(b.value) * a.bound + a.bound * b.bound +
                         std::fabs(product) * 0x1p-53};
  }
};

template <class N>
concept NumberWithError = std::is_same_v<N, SizedDouble> || std::is_same_v<N, BoundedDouble>;

/// Of a t + b, with proven radii. `is_certain` is false where doubles cannot tell.
template <NumberWithError N>
RootList linear_roots(const N& a, const N& b) {
  RootList list;
  const double error_a = a.error(), error_b = b.error(), size_a = std::fabs(a.value);
  list.begins_negative = a.value > 0;
  if (size_a > 0x1p+20 * error_a) [[likely]] {
    // |b/a - B/A| <= (|b - B| + |b/a| |a - A|) / |A|, and |A| is |a| but for 2^-20 of it.
    const double t = -b.value / a.value;
    list.add({t, (error_b + std::fabs(t) * error_a) / size_a * (1 + 0x1p-19) + std::fabs(t) * 0x1p-52, 1});
  } else {
    list.is_certain = a.is_zero() && std::fabs(b.value) > error_b;
    list.begins_negative = b.value < 0;
  }
  return list;
}

/// Of a t^2 + 2 b t + c, likewise.
template <NumberWithError N>
RootList quadratic_roots(const N& a, const N& b, const N& c) {
  RootList list;
  const double error_a = a.error(), error_b = b.error(), error_c = c.error();
  const double size_a = std::fabs(a.value), size_b = std::fabs(b.value), size_c = std::fabs(c.value);
  const double square = b.value * b.value, product = a.value * c.value, discriminant = square - product;
  // Of the coefficients ...
  const double of_terms = (2 * size_b + error_b) * error_b + size_a * error_c + (size_c + error_c) * error_a;
  // ... and of the three roundings above.
  const double error = (of_terms + (square + std::fabs(product)) * 0x1p-52) * (1 + 0x1p-40) + SizedDouble::step;
  list.begins_negative = a.value < 0;
  list.is_certain = size_a > 0x1p+20 * error_a && std::fabs(discriminant) > error;
  if (!list.is_certain || discriminant < 0) return list;
  const double root = std::sqrt(discriminant);
  const double q = b.value > 0 ? -(b.value + root) : root - b.value, size_q = std::fabs(q);
  // |sqrt(x) - sqrt(y)| <= |x - y| / sqrt(x), and |q| is no smaller than the root.
  const double error_q = (error_b + error / root) * (1 + 0x1p-40) + size_q * 0x1p-51;
  list.is_certain = size_q > 0x1p+20 * error_q;
  if (!list.is_certain) return list;
  const double inverse_a = 1 / a.value, inverse_q = 1 / q;
  const double one = q * inverse_a, other = c.value * inverse_q;
  const double size_one = std::fabs(one), size_other = std::fabs(other);
  constexpr double slack = 1 + 0x1p-18;  // for divisors that are off by 2^-20, and for these roundings
  const Root first{one, (error_q + size_one * error_a) * std::fabs(inverse_a) * slack + size_one * 0x1p-51, 1};
  const Root second{other, (error_c + size_other * error_q) * std::fabs(inverse_q) * slack + size_other * 0x1p-51, 1};
  const bool is_first_lower = (a.value > 0) != (b.value <= 0);
  list.add(is_first_lower ? first : second);
  list.add(is_first_lower ? second : first);
  return list;
}

}  // namespace sightline
