#pragma once
/// Polynomials with integer coefficients: what exact roots are made of.

#include <gmpxx.h>

#include <utility>
#include <vector>

#include "sightline/math/dyadic.h"

namespace sightline {

/// Lowest coefficient first, the last one not zero; the zero polynomial has none.
using ExactPolynomial = std::vector<Dyadic>;
using IntegerPolynomial = std::vector<mpz_class>;

/// The degree; -1 for the zero polynomial.
inline int degree(const IntegerPolynomial& p) { return static_cast<int>(p.size()) - 1; }

/// The polynomial times the power of two that makes all coefficients integers; zeros in front are trimmed.
IntegerPolynomial to_integers(const ExactPolynomial&);

IntegerPolynomial derivative(const IntegerPolynomial&);

/// p(x), exactly.
Dyadic evaluate(const IntegerPolynomial& p, const Dyadic& x);

/// The sign of p wherever lo <= x <= hi; 0 where that could not be told, which a smaller range may settle. For lo = hi
/// the sign of p there.
int sign_within(const IntegerPolynomial& p, const Dyadic& lo, const Dyadic& hi);

/// A greatest common divisor without common integer factors; at least one of a and b is not zero. Degree 0, the usual
/// case, is mostly found modulo one prime.
IntegerPolynomial common_divisor(const IntegerPolynomial& a, const IntegerPolynomial& b);

/// The factors f_1, f_2, ... of p up to a number: p = f_1 f_2^2 f_3^3 ..., each without repeated roots, no two with a
/// common one. Those of degree 0 are left out. Musser, "Multivariate Polynomial Factorization", 1975.
struct SquareFreeFactor {
  IntegerPolynomial polynomial;
  int multiplicity;
};
std::vector<SquareFreeFactor> square_free_factors(const IntegerPolynomial& p);

/// k and m with 2^k < |x| < 2^m for all roots; the lowest coefficient is not zero, the degree at least 1.
/// Fujiwara, "Ueber die obere Schranke des absoluten Betrages der Wurzeln einer algebraischen Gleichung", 1916.
std::pair<long, long> root_magnitudes(const IntegerPolynomial&);

}  // namespace sightline
