#include "sightline/math/dyadic.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace sightline {
namespace {

constexpr int digits = std::numeric_limits<double>::digits;
constexpr long largest_exponent = std::numeric_limits<double>::max_exponent - 1;        // of the leading bit
constexpr long smallest_exponent = std::numeric_limits<double>::min_exponent - digits;  // of any bit

}  // namespace

Dyadic::Dyadic(double x) {
  if (!std::isfinite(x)) throw std::invalid_argument("expected a finite number, found an infinite one or NaN");
  if (x == 0) return;
  int exponent = 0;
  auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), digits));  // an integer below 2^53
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  mantissa >>= zeros;  // short mantissas stay short in products
  mantissa_ = static_cast<long>(mantissa);
  exponent_ = exponent - digits + zeros;
}

double Dyadic::nearest() const {
  if (sign() == 0) return 0;
  const long leading = floor_log2();
  const double direction = sign();
  if (leading > largest_exponent) return direction * std::numeric_limits<double>::infinity();
  if (leading < smallest_exponent - 1) return direction * 0.0;
  const long last = std::max(leading - (digits - 1), smallest_exponent);  // the exponent of the result's last bit
  if (exponent_ >= last) return std::ldexp(mantissa_.get_d(), static_cast<int>(exponent_));
  const auto cut = static_cast<mp_bitcnt_t>(last - exponent_);
  const mpz_class magnitude = abs(mantissa_);
  const mpz_class kept = magnitude >> cut;
  auto bits = static_cast<std::uint64_t>(mpz_get_ui(kept.get_mpz_t()));
  const bool is_half = mpz_tstbit(magnitude.get_mpz_t(), cut - 1) != 0;
  const bool is_more = mpz_scan1(magnitude.get_mpz_t(), 0) < cut - 1;
  if (is_half && (is_more || (bits & 1) != 0)) ++bits;
  return direction * std::ldexp(static_cast<double>(bits), static_cast<int>(last));
}

namespace {

mpz_class shifted(const mpz_class& m, long bits) { return m << static_cast<mp_bitcnt_t>(bits); }

}  // namespace

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  if (a.sign() == 0) return b;
  if (b.sign() == 0) return a;
  if (a.exponent_ == b.exponent_) return {a.mantissa_ + b.mantissa_, a.exponent_};
  if (a.exponent_ > b.exponent_) return {shifted(a.mantissa_, a.exponent_ - b.exponent_) + b.mantissa_, b.exponent_};
  return {a.mantissa_ + shifted(b.mantissa_, b.exponent_ - a.exponent_), a.exponent_};
}

Dyadic operator-(const Dyadic& a, const Dyadic& b) {
  if (b.sign() == 0) return a;
  if (a.sign() == 0) return -b;
  if (a.exponent_ == b.exponent_) return {a.mantissa_ - b.mantissa_, a.exponent_};
  if (a.exponent_ > b.exponent_) return {shifted(a.mantissa_, a.exponent_ - b.exponent_) - b.mantissa_, b.exponent_};
  return {a.mantissa_ - shifted(b.mantissa_, b.exponent_ - a.exponent_), a.exponent_};
}

}  // namespace sightline
