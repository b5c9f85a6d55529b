#include <boost/multiprecision/gmp.hpp>

#include "bench/accuracy/oracle_wide.h"

namespace sightline::bench {
namespace {

using Rational = boost::multiprecision::mpq_rational;
using Polynomial = std::vector<Rational>;  ///< Lowest coefficient first; the last is not 0.

void trim(Polynomial& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

Rational value(const Polynomial& p, const Rational& x) {
  Rational sum = 0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
  return sum;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial all(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) all[i + k] += a[i] * b[k];
  }
  return all;
}

Polynomial negative_remainder(Polynomial a, const Polynomial& b) {
  while (a.size() >= b.size()) {
    const Rational factor = a.back() / b.back();
    const std::size_t shift = a.size() - b.size();
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= factor * b[i];
    a.back() = 0;
    trim(a);
  }
  for (Rational& x : a) x = -x;
  return a;
}

/// Sturm, "Memoire sur la resolution des equations numeriques", 1829: how many distinct real roots lie in (lo, hi].
class SturmChain {
 public:
  explicit SturmChain(const Polynomial& p) : chain_{p} {
    Polynomial slope;
    for (std::size_t i = 1; i < p.size(); ++i) slope.push_back(p[i] * i);
    while (!slope.empty()) {
      chain_.push_back(slope);
      slope = negative_remainder(chain_[chain_.size() - 2], chain_.back());
    }
  }

  int changes_at(const Rational& x) const {
    int changes = 0, last = 0;
    for (const Polynomial& p : chain_) {
      const Rational y = value(p, x);
      const int sign = (y > 0) - (y < 0);
      changes += sign != 0 && last != 0 && sign != last;
      if (sign != 0) last = sign;
    }
    return changes;
  }
  int count(const Rational& lo, const Rational& hi) const { return changes_at(lo) - changes_at(hi); }

 private:
  std::vector<Polynomial> chain_;
};

/// The only root in (lo, hi], by halving 130 times: by signs where the polynomial changes its sign there, else by the
/// chain.
True refined(const SturmChain& chain, const Polynomial& p, Rational lo, Rational hi) {
  const bool changes_sign = value(p, lo) * value(p, hi) < 0, is_negative = value(p, lo) < 0;
  for (int i = 0; i < 130; ++i) {
    const Rational middle = (lo + hi) / 2;
    const bool is_right = changes_sign ? (value(p, middle) < 0) == is_negative : chain.count(lo, middle) == 0;
    (is_right ? lo : hi) = middle;
  }
  const double high = static_cast<double>(hi);
  return {high, static_cast<double>(Rational(hi - Rational(high)))};
}

void isolate(const SturmChain& chain, const Polynomial& p, const Rational& lo, const Rational& hi, int count,
             std::vector<True>& roots) {
  if (count == 0) return;
  if (count == 1) return roots.push_back(refined(chain, p, lo, hi));
  const Rational middle = (lo + hi) / 2;
  const int below = chain.count(lo, middle);
  isolate(chain, p, lo, middle, below, roots);
  isolate(chain, p, middle, hi, count - below, roots);
}

}  // namespace

std::vector<True> true_torus_roots(double minor, const Ray<double>& ray) {
  // (|q|^2 + 1 - r^2)^2 - 4 (x^2 + y^2) along q = o + t d
  const auto square = [](const Rational& o, const Rational& d) { return Polynomial{o * o, 2 * o * d, d * d}; };
  const Polynomial x = square(ray.origin.x, ray.direction.x), y = square(ray.origin.y, ray.direction.y),
                   z = square(ray.origin.z, ray.direction.z);
  Polynomial size(3), across(3);
  for (std::size_t i = 0; i < 3; ++i) across[i] = x[i] + y[i], size[i] = across[i] + z[i];
  size[0] += 1 - Rational(minor) * Rational(minor);
  Polynomial p = product(size, size);
  for (std::size_t i = 0; i < 3; ++i) p[i] -= 4 * across[i];
  trim(p);
  const SturmChain chain(p);
  Rational limit = 1;  // Cauchy's bound
  for (const Rational& c : p) {
    const Rational share = abs(Rational(c / p.back())) + 1;
    if (share > limit) limit = share;
  }
  std::vector<True> roots;
  isolate(chain, p, -limit, limit, chain.count(-limit, limit), roots);
  return roots;
}

}  // namespace sightline::bench
