#pragma once
/// Exact numbers: sums, differences and products of doubles, without any limit of size.

#include <gmpxx.h>

#include <compare>
#include <utility>

namespace sightline {

/// mantissa * 2^exponent. Every finite double is one, and sums, differences and products of them stay so.
class Dyadic {
 public:
  Dyadic() = default;

  /// Exact. \throws std::invalid_argument where x is infinite or NaN.
  explicit Dyadic(double x);

  Dyadic(mpz_class mantissa, long exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  static Dyadic power_of_two(long exponent) { return {mpz_class(1), exponent}; }

  const mpz_class& mantissa() const { return mantissa_; }
  long exponent() const { return exponent_; }

  /// -1, 0 or 1.
  int sign() const { return sgn(mantissa_); }

  /// The k for which 2^k <= |x| < 2^(k+1). Not for 0.
  long floor_log2() const { return exponent_ + static_cast<long>(mpz_sizeinbase(mantissa_.get_mpz_t(), 2)) - 1; }

  /// The nearest double, of two equally near ones the even one (IEEE 754): infinite beyond the range of double,
  /// subnormal or a zero of the same sign below it.
  double nearest() const;

  /// x * 2^k.
  Dyadic scaled(long k) const { return {mantissa_, exponent_ + k}; }

  Dyadic operator-() const { return {-mantissa_, exponent_}; }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }

  friend std::strong_ordering operator<=>(const Dyadic& a, const Dyadic& b) { return (a - b).sign() <=> 0; }
  friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).sign() == 0; }

 private:
  mpz_class mantissa_;
  long exponent_ = 0;
};

}  // namespace sightline
