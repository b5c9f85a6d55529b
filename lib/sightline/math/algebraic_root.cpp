#include "sightline/math/algebraic_root.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sightline {
namespace {

/// The value halfway from a double to the next one above, where rounding changes over. From the largest double, half of
/// what would be the last step.
Dyadic rounding_boundary(double below, double above) {
  constexpr double largest = std::numeric_limits<double>::max();
  const Dyadic beyond = Dyadic::power_of_two(std::numeric_limits<double>::max_exponent);
  const Dyadic lo = below < -largest ? -beyond : Dyadic(below), hi = above > largest ? beyond : Dyadic(above);
  return (lo + hi).scaled(-1);
}

int sign_of_difference(const Dyadic& a, const Dyadic& b) { return (a - b).sign(); }

}  // namespace

// ---- Refinement

void AlgebraicRoot::become(const Dyadic& x) {
  lo_ = hi_ = x;
  sign_below_ = 0;
}

/// Cuts the interval at x, which is inside; true where the root is above. Not once the root is found to be x.
bool AlgebraicRoot::cut_at(const Dyadic& x) {
  const int sign = evaluate(*factor_, x).sign();
  if (sign == 0) {
    become(x);
    return false;
  }
  (sign == sign_below_ ? lo_ : hi_) = x;
  return sign == sign_below_;
}

/// Cuts around where doubles find the root, once: that spares most of the first, small refinements. What they find only
/// guides; the cuts are exact.
void AlgebraicRoot::jump() {
  cut_bits_ = 1;
  const int exponent = static_cast<int>(std::max(lo_.floor_log2(), hi_.floor_log2()));
  if (std::abs(exponent) > 900) return;
  // In units of 2^exponent and of the largest term there.
  std::vector<double> c(factor_->size());
  std::vector<long> exponents(c.size());
  long largest = std::numeric_limits<long>::min();
  for (std::size_t i = 0; i < c.size(); ++i) {
    c[i] = mpz_get_d_2exp(&exponents[i], (*factor_)[i].get_mpz_t());
    exponents[i] += static_cast<long>(i) * exponent;
    if (c[i] != 0) largest = std::max(largest, exponents[i]);
  }
  for (std::size_t i = 0; i < c.size(); ++i) {
    c[i] = std::ldexp(c[i], static_cast<int>(std::max(exponents[i] - largest, -1100L)));
  }
  double lo = lo_.scaled(-exponent).nearest(), hi = hi_.scaled(-exponent).nearest(), x = lo + 0.5 * (hi - lo);
  for (int round = 0; round < 100; ++round) {
    double value = 0, slope = 0;
    for (std::size_t i = c.size(); i-- > 0;) {
      slope = slope * x + value;
      value = value * x + c[i];
    }
    ((value > 0) == (sign_below_ > 0) ? lo : hi) = x;
    double next = x - value / slope;
    if (!(next > lo && next < hi)) next = lo + 0.5 * (hi - lo);
    const bool is_near = std::fabs(next - x) <= 0x1p-44 * std::fabs(x);
    x = next;
    if (is_near) break;
  }
  for (const double side : {-1.0, 1.0}) {
    const Dyadic near = Dyadic(x + side * 0x1p-40 * std::fabs(x)).scaled(exponent);
    if (!is_dyadic() && lo_ < near && near < hi_) cut_at(near);
  }
  if (!is_dyadic() && (hi_ - lo_).floor_log2() - lo_.floor_log2() < -36) cut_bits_ = 30;
}

/// Makes the interval smaller, in the end by 2^cut_bits_ at once, which doubles each time: Abbott, "Quadratic Interval
/// Refinement for Real Roots", 2006. Intervals of several powers of two are first halved in exponent.
void AlgebraicRoot::refine() {
  if (is_dyadic()) return;
  if (cut_bits_ == 0) return jump();
  const long low = lo_.floor_log2(), high = hi_.floor_log2();  // A2
  if (std::abs(high - low) > 1) {
    const Dyadic middle = Dyadic::power_of_two(low + (high - low) / 2);
    cut_at(lo_.sign() < 0 ? -middle : middle);
    return;
  }
  // Where the chord between the ends crosses zero, to the nearest of 2^cut_bits_ parts.
  const Dyadic below = evaluate(*factor_, lo_), above = evaluate(*factor_, hi_), rise = below - above;
  const long k = std::min(below.exponent(), rise.exponent());
  const mpz_class numerator = abs(below.mantissa()) << static_cast<mp_bitcnt_t>(below.exponent() - k + cut_bits_ + 1);
  const mpz_class denominator = abs(rise.mantissa()) << static_cast<mp_bitcnt_t>(rise.exponent() - k);
  mpz_class part = (numerator / denominator + 1) >> 1;
  const mpz_class parts = mpz_class(1) << static_cast<mp_bitcnt_t>(cut_bits_);
  if (part == 0) part = 1;
  if (part == parts) part -= 1;
  const Dyadic step = (hi_ - lo_).scaled(-cut_bits_), start = lo_, end = hi_;
  const bool is_above = cut_at(start + step * Dyadic(part, 0));
  if (is_dyadic()) return;
  part += is_above ? 1 : -1;
  const bool is_inside = part != 0 && part != parts;  // else the part ends where the interval did
  const bool is_won = !is_inside || cut_at(start + step * Dyadic(part, 0)) != is_above;
  cut_bits_ = is_won ? 2 * cut_bits_ : std::max(1, cut_bits_ / 2);
}

/// The same for a root p / q: the quotient to twice as many bits.
void AlgebraicRoot::refine_rational() {
  const mpz_class &q = (*factor_)[1], p = -(*factor_)[0];
  cut_bits_ = std::max(64, 2 * cut_bits_);
  const long shift = cut_bits_ + static_cast<long>(mpz_sizeinbase(q.get_mpz_t(), 2)) -
                     static_cast<long>(mpz_sizeinbase(p.get_mpz_t(), 2));
  mpz_class dividend = p, divisor = q, quotient, rest;
  (shift > 0 ? dividend : divisor) <<= static_cast<mp_bitcnt_t>(std::abs(shift));
  mpz_fdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), dividend.get_mpz_t(), divisor.get_mpz_t());
  lo_ = Dyadic(quotient, -shift);
  hi_ = Dyadic(quotient + 1, -shift);
  if (rest == 0) become(lo_);
}

// ---- Questions

double AlgebraicRoot::nearest() const {
  AlgebraicRoot root = *this;
  for (;;) {
    const double below = root.lo_.nearest(), above = root.hi_.nearest();
    if (below == above) return below;
    if (std::nextafter(below, above) == above) {
      const Dyadic boundary = rounding_boundary(below, above);
      const int side = root.compare(boundary);
      return side < 0 ? below : side > 0 ? above : boundary.nearest();
    }
    root.is_rational() ? root.refine_rational() : root.refine();
  }
}

int AlgebraicRoot::compare(const Dyadic& x) const {
  if (is_dyadic()) return sign_of_difference(lo_, x);
  if (sign_of_difference(x, lo_) <= 0) return 1;
  if (sign_of_difference(x, hi_) >= 0) return -1;
  return evaluate(*factor_, x).sign() * sign_below_;  // A1: like the sign below, the root is above
}

int AlgebraicRoot::compare(double x) const {
  if (std::isinf(x)) return x > 0 ? -1 : 1;
  return compare(Dyadic(x));
}

int AlgebraicRoot::compare(const AlgebraicRoot& a, const AlgebraicRoot& b) {
  if (a.is_dyadic()) return -b.compare(a.lo_);
  if (b.is_dyadic()) return a.compare(b.lo_);
  if (sign_of_difference(a.hi_, b.lo_) <= 0) return -1;
  if (sign_of_difference(b.hi_, a.lo_) <= 0) return 1;
  if (a.factor_ == b.factor_) return 0;  // A3
  const IntegerPolynomial &f = *a.factor_, &g = *b.factor_;
  if (a.is_rational() && b.is_rational()) {
    return sgn(f[1]) * sgn(g[1]) * sgn(mpz_class(g[0] * f[1] - f[0] * g[1]));
  }
  const Dyadic &lo = a.lo_ < b.lo_ ? b.lo_ : a.lo_, &hi = a.hi_ < b.hi_ ? a.hi_ : b.hi_;
  const IntegerPolynomial common = common_divisor(f, g);
  // Of a divisor's roots only one can be in either interval, and none at an end (A1).
  if (degree(common) > 0 && evaluate(common, lo).sign() != evaluate(common, hi).sign()) return 0;
  AlgebraicRoot left = a, right = b;
  for (;;) {
    left.refine();
    right.refine();
    if (left.is_dyadic()) return -right.compare(left.lo_);
    if (right.is_dyadic()) return left.compare(right.lo_);
    if (sign_of_difference(left.hi_, right.lo_) <= 0) return -1;
    if (sign_of_difference(right.hi_, left.lo_) <= 0) return 1;
  }
}

int AlgebraicRoot::sign_where_not_zero(const IntegerPolynomial& p) {
  for (;;) {
    if (const int sign = sign_within(p, lo_, hi_); sign != 0) return sign;
    refine();
  }
}

int AlgebraicRoot::sign_at(const IntegerPolynomial& p) const {
  if (p.empty()) return 0;
  if (is_dyadic()) return evaluate(p, lo_).sign();
  if (const int sign = sign_within(p, lo_, hi_); sign != 0) return sign;
  const IntegerPolynomial common = common_divisor(*factor_, p);
  if (degree(common) > 0 && evaluate(common, lo_).sign() != evaluate(common, hi_).sign()) return 0;
  return AlgebraicRoot(*this).sign_where_not_zero(p);
}

int AlgebraicRoot::sign_of(const ExactPolynomial& p) const { return sign_at(to_integers(p)); }

// ---- Isolation

/// Roots are kept apart by those of the derivative, found in the same way: between two of them in succession the
/// polynomial is monotonic, so its signs there tell whether it has a root.
class RootIsolation {
 public:
  /// The roots of a polynomial of degree 1 or more without repeated ones, ascending.
  static std::vector<AlgebraicRoot> of_square_free(IntegerPolynomial p) {
    std::vector<AlgebraicRoot> roots;
    const bool has_zero = p.front() == 0;
    if (has_zero) p.erase(p.begin());
    if (degree(p) >= 1) {
      const auto factor = std::make_shared<const IntegerPolynomial>(std::move(p));
      degree(*factor) == 1 ? add_rational(factor, roots) : add_between_extrema(factor, roots);
    }
    if (has_zero) {
      const auto x = std::make_shared<const IntegerPolynomial>(IntegerPolynomial{0, 1});
      const auto is_negative = [](const AlgebraicRoot& root) { return root.hi_.sign() < 0; };
      roots.insert(std::partition_point(roots.begin(), roots.end(), is_negative), AlgebraicRoot(x, {}, {}, 0));
    }
    return roots;
  }

  static std::vector<AlgebraicRoot> of(const IntegerPolynomial& p) {
    std::vector<AlgebraicRoot> roots;
    for (SquareFreeFactor& factor : square_free_factors(p)) {
      for (AlgebraicRoot& root : of_square_free(std::move(factor.polynomial))) {
        root.multiplicity_ = factor.multiplicity;
        const auto is_less = [&root](const AlgebraicRoot& other) { return AlgebraicRoot::compare(other, root) < 0; };
        roots.insert(std::partition_point(roots.begin(), roots.end(), is_less), std::move(root));
      }
    }
    return roots;
  }

 private:
  static void add_rational(const AlgebraicRoot::Factor& factor, std::vector<AlgebraicRoot>& roots) {
    AlgebraicRoot root(factor, {}, {}, -sgn((*factor)[1]));
    root.refine_rational();
    roots.push_back(std::move(root));
  }

  static void add_between_extrema(const AlgebraicRoot::Factor& factor, std::vector<AlgebraicRoot>& roots) {
    const IntegerPolynomial& p = *factor;
    const auto [smallest, largest] = root_magnitudes(p);
    const Dyadic infinity = Dyadic::power_of_two(largest);
    Dyadic before = -infinity;
    int sign_before = degree(p) % 2 == 0 ? sgn(p.back()) : -sgn(p.back());
    const auto add = [&](const Dyadic& after, int sign_after) {
      if (sign_before == sign_after) return;
      Dyadic lo = before, hi = after;
      // A2: 0 is no root, and none is nearer to it than `smallest`.
      if (lo.sign() * hi.sign() <= 0) {
        const bool is_positive = sgn(p.front()) == sign_before;
        (is_positive ? lo : hi) = is_positive ? Dyadic::power_of_two(smallest) : -Dyadic::power_of_two(smallest);
      }
      roots.push_back(AlgebraicRoot(factor, std::move(lo), std::move(hi), sign_before));
    };
    // Extrema are nearer to 0 than the farthest complex root (Gauss and Lucas), so none is beyond `infinity`.
    for (AlgebraicRoot& extremum : of(derivative(p))) {
      const int sign = extremum.sign_where_not_zero(p);
      add(extremum.lo_, sign);
      before = extremum.hi_;
      sign_before = sign;
    }
    add(infinity, sgn(p.back()));
  }
};

std::vector<AlgebraicRoot> real_roots(const ExactPolynomial& p) { return RootIsolation::of(to_integers(p)); }

}  // namespace sightline
