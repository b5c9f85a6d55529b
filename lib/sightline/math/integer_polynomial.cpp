#include "sightline/math/integer_polynomial.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace sightline {
namespace {

void trim(IntegerPolynomial& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

long bits_of(const mpz_class& m) { return static_cast<long>(mpz_sizeinbase(m.get_mpz_t(), 2)); }

/// Divides by the largest common integer factor.
void make_primitive(IntegerPolynomial& p) {
  mpz_class content;
  for (const mpz_class& c : p) {
    content = gcd(content, c);
    if (content == 1) return;
  }
  if (content == 0) return;
  for (mpz_class& c : p) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), content.get_mpz_t());
}

/// A multiple of the remainder of a by b, which is not zero.
IntegerPolynomial pseudo_remainder(IntegerPolynomial a, const IntegerPolynomial& b) {
  while (degree(a) >= degree(b)) {
    const std::size_t shift = a.size() - b.size();
    const mpz_class lead = a.back();
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] *= b.back();
      if (i >= shift) a[i] -= lead * b[i - shift];
    }
    trim(a);
  }
  return a;
}

/// a / b where b divides a over the rationals: the quotient without common integer factors.
IntegerPolynomial exact_quotient(IntegerPolynomial a, const IntegerPolynomial& b) {
  IntegerPolynomial quotient(a.size() - b.size() + 1);
  // Scaling by the leading coefficient once a step keeps every division exact.
  mpz_class scale;
  mpz_pow_ui(scale.get_mpz_t(), b.back().get_mpz_t(), quotient.size());
  for (mpz_class& c : a) c *= scale;
  for (std::size_t i = quotient.size(); i-- > 0;) {
    mpz_divexact(quotient[i].get_mpz_t(), a[i + b.size() - 1].get_mpz_t(), b.back().get_mpz_t());
    for (std::size_t j = 0; j < b.size(); ++j) a[i + j] -= quotient[i] * b[j];
  }
  make_primitive(quotient);
  return quotient;
}

// ---- Modulo a prime

constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1;  // Mersenne's

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  __extension__ using Wide = unsigned __int128;
  const Wide wide = static_cast<Wide>(a) * b;
  const std::uint64_t sum = static_cast<std::uint64_t>(wide & prime) + static_cast<std::uint64_t>(wide >> 61);
  return sum >= prime ? sum - prime : sum;
}

std::vector<std::uint64_t> modulo_prime(const IntegerPolynomial& p) {
  std::vector<std::uint64_t> residues(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) residues[i] = mpz_fdiv_ui(p[i].get_mpz_t(), prime);
  return residues;
}

/// True only where a and b have no common divisor. The degree of one modulo a prime that divides no leading coefficient
/// is at least the true one (Brown, "On Euclid's algorithm and the computation of polynomial greatest common divisors",
/// 1971).
bool are_coprime_modulo_prime(const IntegerPolynomial& p, const IntegerPolynomial& q) {
  std::vector<std::uint64_t> a = modulo_prime(p), b = modulo_prime(q);
  if (a.empty() || b.empty() || a.back() == 0 || b.back() == 0) return false;
  if (a.size() < b.size()) std::swap(a, b);
  while (b.size() > 1) {
    while (a.size() >= b.size()) {
      const std::size_t shift = a.size() - b.size();
      const std::uint64_t lead = a.back();
      for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = product(a[i], b.back());
        if (i < shift) continue;
        const std::uint64_t part = product(lead, b[i - shift]);
        a[i] = a[i] >= part ? a[i] - part : a[i] + (prime - part);
      }
      while (!a.empty() && a.back() == 0) a.pop_back();
    }
    if (a.empty()) return false;
    std::swap(a, b);
  }
  return true;
}

}  // namespace

IntegerPolynomial to_integers(const ExactPolynomial& p) {
  long lowest = std::numeric_limits<long>::max();
  for (const Dyadic& c : p) {
    if (c.sign() != 0) lowest = std::min(lowest, c.exponent());
  }
  IntegerPolynomial integers(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i].sign() != 0) integers[i] = p[i].mantissa() << static_cast<mp_bitcnt_t>(p[i].exponent() - lowest);
  }
  trim(integers);
  return integers;
}

IntegerPolynomial derivative(const IntegerPolynomial& p) {
  IntegerPolynomial result;
  for (std::size_t i = 1; i < p.size(); ++i) result.push_back(p[i] * i);
  return result;
}

Dyadic evaluate(const IntegerPolynomial& p, const Dyadic& x) {
  if (p.empty()) return {};
  const long k = x.exponent();
  const mpz_class m = k > 0 ? mpz_class(x.mantissa() << static_cast<mp_bitcnt_t>(k)) : x.mantissa();
  const long fraction = k < 0 ? -k : 0;  // x = m / 2^fraction; Horner's rule, times 2^fraction once a step
  mpz_class sum = p.back();
  long scale = 0;
  for (std::size_t i = p.size() - 1; i-- > 0;) {
    scale += fraction;
    sum *= m;
    sum += p[i] << static_cast<mp_bitcnt_t>(scale);
  }
  return {std::move(sum), -scale};
}

int sign_within(const IntegerPolynomial& p, const Dyadic& lo, const Dyadic& hi) {
  if (p.empty()) return 0;
  const Dyadic middle = (lo + hi).scaled(-1), half = (hi - lo).scaled(-1);
  const long k = std::min({middle.exponent(), half.exponent(), 0L});
  const mpz_class m = middle.mantissa() << static_cast<mp_bitcnt_t>(middle.exponent() - k);
  const mpz_class h = half.mantissa() << static_cast<mp_bitcnt_t>(half.exponent() - k);
  // The polynomial in units of 2^k, moved to the middle: its constant must outweigh all else within h.
  IntegerPolynomial moved = p;
  const std::size_t n = p.size() - 1;
  for (std::size_t i = 0; i <= n; ++i) moved[i] <<= static_cast<mp_bitcnt_t>(-k) * (n - i);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = n; j-- > i;) moved[j] += moved[j + 1] * m;
  }
  mpz_class rest;
  for (std::size_t i = n; i > 0; --i) rest = (rest + abs(moved[i])) * h;
  return abs(moved[0]) > rest ? sgn(moved[0]) : 0;
}

IntegerPolynomial common_divisor(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  if (are_coprime_modulo_prime(a, b)) return {mpz_class(1)};
  IntegerPolynomial large = a, small = b;
  if (large.size() < small.size()) std::swap(large, small);
  make_primitive(large);
  make_primitive(small);
  while (!small.empty()) {
    IntegerPolynomial rest = pseudo_remainder(std::move(large), small);
    make_primitive(rest);
    large = std::move(small);
    small = std::move(rest);
  }
  return large;
}

std::vector<SquareFreeFactor> square_free_factors(const IntegerPolynomial& p) {
  std::vector<SquareFreeFactor> factors;
  if (degree(p) < 1) return factors;
  IntegerPolynomial repeated = common_divisor(p, derivative(p));
  if (degree(repeated) == 0) return {{p, 1}};
  // `rest` holds each root of multiplicity `multiplicity` or more once, `repeated` that many times less.
  IntegerPolynomial rest = exact_quotient(p, repeated);
  for (int multiplicity = 1; degree(rest) > 0; ++multiplicity) {
    IntegerPolynomial higher = common_divisor(rest, repeated);
    IntegerPolynomial factor = exact_quotient(rest, higher);
    if (degree(factor) > 0) factors.push_back({std::move(factor), multiplicity});
    repeated = exact_quotient(repeated, higher);
    rest = std::move(higher);
  }
  return factors;
}

std::pair<long, long> root_magnitudes(const IntegerPolynomial& p) {
  const std::size_t n = p.size() - 1;
  // |x| < 2 max |c_(n-i) / c_n|^(1/i), and the same of 1 / x.
  long upper = std::numeric_limits<long>::min(), lower = upper;
  const auto bound = [](const mpz_class& c, const mpz_class& lead, std::size_t i) {
    const long bits = bits_of(c) - bits_of(lead) + 1, step = static_cast<long>(i);  // |c / lead| < 2^bits
    return 1 + (bits >= 0 ? (bits + step - 1) / step : -(-bits / step));
  };
  for (std::size_t i = 1; i <= n; ++i) {
    if (p[n - i] != 0) upper = std::max(upper, bound(p[n - i], p[n], i));
    if (p[i] != 0) lower = std::max(lower, bound(p[i], p[0], i));
  }
  return {-lower, upper};
}

}  // namespace sightline
