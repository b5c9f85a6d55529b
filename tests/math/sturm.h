#pragma once
/// An oracle for real roots: Sturm chains over Boost's integers. Shares nothing with the library.

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <vector>

namespace sightline::oracle {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;
using Polynomial = std::vector<Integer>;  // lowest coefficient first

inline void normalize(Polynomial& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  Integer content = 0;
  for (const Integer& c : p) content = gcd(content, c);
  if (content > 1) {
    for (Integer& c : p) c /= content;
  }
}

inline Polynomial polynomial_of(const std::vector<Rational>& coefficients) {
  Integer common = 1;
  for (const Rational& c : coefficients) common = lcm(common, Integer(denominator(c)));
  Polynomial p;
  for (const Rational& c : coefficients) p.push_back(Integer(numerator(c)) * (common / Integer(denominator(c))));
  normalize(p);
  return p;
}

inline Polynomial derivative_of(const Polynomial& p) {
  Polynomial d;
  for (std::size_t i = 1; i < p.size(); ++i) d.push_back(p[i] * static_cast<int>(i));
  normalize(d);
  return d;
}

/// A positive multiple of the remainder; with `quotient`, that of the quotient.
inline Polynomial remainder(Polynomial a, const Polynomial& b, Polynomial* quotient = nullptr) {
  if (quotient) quotient->assign(a.size() >= b.size() ? a.size() - b.size() + 1 : 0, 0);
  while (!a.empty() && a.size() >= b.size()) {
    const std::size_t shift = a.size() - b.size();
    const Integer lead = b.back() < 0 ? Integer(-a.back()) : a.back(), scale = abs(b.back());
    if (quotient) {
      for (Integer& q : *quotient) q *= scale;
      (*quotient)[shift] += lead;
    }
    for (Integer& c : a) c *= scale;
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= lead * b[i];
    while (!a.empty() && a.back() == 0) a.pop_back();
  }
  normalize(a);
  return a;
}

inline Polynomial divisor_of(Polynomial a, Polynomial b) {
  while (!b.empty()) {
    Polynomial rest = remainder(a, b);
    a = std::move(b);
    b = std::move(rest);
  }
  return a;
}

/// The sign at a finite double halved as often as `halvings` says, plus `offset` likewise; exact.
inline int sign_at(const Polynomial& p, const Rational& x) {
  const Integer n = numerator(x), d = denominator(x);
  Integer sum = 0, power = 1;
  for (std::size_t i = p.size(); i-- > 0;) {
    sum = sum * n + p[i] * power;
    power *= d;
  }
  return sum.sign();
}

class SturmChain {
 public:
  explicit SturmChain(const Polynomial& p) {
    if (p.size() < 2) return;
    Polynomial square_free;
    remainder(p, divisor_of(p, derivative_of(p)), &square_free);
    normalize(square_free);
    chain_ = {square_free, derivative_of(square_free)};
    while (chain_.back().size() > 1) {
      Polynomial next = remainder(chain_[chain_.size() - 2], chain_.back());
      for (Integer& c : next) c = -c;
      chain_.push_back(std::move(next));
    }
  }

  int count() const {
    return changes([](const Polynomial& p) { return ends(p, -1); }) - changes_above();
  }

  /// Distinct roots <= x.
  int count_to(const Rational& x) const {
    const auto here = [&](const Polynomial& p) { return sign_at(p, x); };
    return changes([](const Polynomial& p) { return ends(p, -1); }) - changes(here);
  }

  bool has_root(const Rational& x) const { return !chain_.empty() && sign_at(chain_[0], x) == 0; }

 private:
  static int ends(const Polynomial& p, int side) { return p.back().sign() * (side < 0 && p.size() % 2 == 0 ? -1 : 1); }
  int changes_above() const {
    return changes([](const Polynomial& p) { return ends(p, 1); });
  }
  template <class Sign>
  int changes(Sign&& sign_of) const {
    int last = 0, count = 0;
    for (const Polynomial& p : chain_) {
      const int sign = sign_of(p);
      if (sign == 0) continue;
      count += last != 0 && sign != last;
      last = sign;
    }
    return count;
  }

  std::vector<Polynomial> chain_;
};

/// Where rounding to nearest changes over between d and its neighbour towards `to`.
inline Rational boundary(double d, double to) {
  const double next = std::nextafter(d, to);
  const Rational last = Rational(std::ldexp(1.0, 1023)) * 2;
  const auto value = [&](double x) { return std::isinf(x) ? (x > 0 ? last : Rational(-last)) : Rational(x); };
  return (value(d) + value(next)) / 2;
}

inline bool is_even(double d) {
  return std::isinf(d) || std::fmod(std::ldexp(d, d == 0 ? 0 : std::min(1074, 52 - std::ilogb(d))), 2.0) == 0;
}

/// The true roots that round to d: distinct ones of p.
inline int count_rounding_to(const SturmChain& chain, double d) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Rational lo = d == -infinity ? Rational(0) : boundary(d, -infinity);
  const Rational hi = d == infinity ? Rational(0) : boundary(d, infinity);
  int count = (d == infinity ? chain.count() : chain.count_to(hi)) - (d == -infinity ? 0 : chain.count_to(lo));
  if (d != infinity && chain.has_root(hi) && !is_even(d)) --count;
  if (d != -infinity && chain.has_root(lo) && is_even(d)) ++count;
  return count;
}

/// One chain for the distinct roots, one for those of multiplicity 2 or more, and so on.
inline std::vector<SturmChain> chains_of(Polynomial p) {
  std::vector<SturmChain> chains;
  while (p.size() > 1) {
    chains.emplace_back(p);
    p = divisor_of(p, derivative_of(p));
  }
  return chains;
}

/// True when `found`, of anything with nearest and multiplicity, are all the roots, each rounded correctly.
struct FoundRoot {
  double nearest;
  int multiplicity;
};
inline bool are_all_roots(const std::vector<Rational>& coefficients, const std::vector<FoundRoot>& found) {
  const std::vector<SturmChain> chains = chains_of(polynomial_of(coefficients));
  if (chains.empty()) return found.empty();
  if (chains[0].count() != static_cast<int>(found.size())) return false;
  for (const FoundRoot& root : found) {
    for (std::size_t m = 0; m < chains.size(); ++m) {
      int claimed = 0;
      for (const FoundRoot& other : found) {
        claimed += other.nearest == root.nearest && other.multiplicity > static_cast<int>(m);
      }
      if (count_rounding_to(chains[m], root.nearest) != claimed) return false;
    }
    if (root.multiplicity > static_cast<int>(chains.size())) return false;
  }
  return true;
}

}  // namespace sightline::oracle
