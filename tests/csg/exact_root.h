#pragma once
/// Numbers of the oracle: binary fractions of any length, polynomials of them, and roots a + b sqrt(c), all compared
/// exactly. Over Boost's integers; shares nothing with the library.

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace sightline::oracle {

/// mantissa * 2^exponent.
class Binary {
 public:
  using Integer = boost::multiprecision::cpp_int;

  Binary() = default;
  Binary(double x) {
    if (x == 0) return;
    mantissa_ = static_cast<long long>(std::ldexp(std::frexp(x, &exponent_), 53));
    exponent_ -= 53;
    const auto zeros = lsb(abs(mantissa_));
    mantissa_ >>= zeros;
    exponent_ += static_cast<int>(zeros);
  }

  int sign() const { return mantissa_.sign(); }

  friend Binary operator+(const Binary& a, const Binary& b) {
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    if (a.exponent_ < b.exponent_) return b + a;
    Binary sum;
    sum.mantissa_ = (a.mantissa_ << static_cast<unsigned>(a.exponent_ - b.exponent_)) + b.mantissa_;
    sum.exponent_ = b.exponent_;
    return sum;
  }
  friend Binary operator-(Binary a) {
    a.mantissa_ = -a.mantissa_;
    return a;
  }
  friend Binary operator-(const Binary& a, const Binary& b) { return a + -b; }
  friend Binary operator*(const Binary& a, const Binary& b) {
    Binary product;
    product.mantissa_ = a.mantissa_ * b.mantissa_;
    product.exponent_ = product.sign() == 0 ? 0 : a.exponent_ + b.exponent_;
    return product;
  }

 private:
  Integer mantissa_ = 0;
  int exponent_ = 0;
};

/// By powers of t, the constant first.
struct Polynomial {
  std::vector<Binary> coefficients;

  Polynomial() = default;
  Polynomial(double constant) : coefficients{Binary(constant)} {}
  Polynomial(double constant, double slope) : coefficients{Binary(constant), Binary(slope)} {}

  friend Polynomial operator+(Polynomial a, const Polynomial& b) {
    a.coefficients.resize(std::max(a.coefficients.size(), b.coefficients.size()));
    for (std::size_t i = 0; i < b.coefficients.size(); ++i) a.coefficients[i] = a.coefficients[i] + b.coefficients[i];
    return a;
  }
  friend Polynomial operator-(Polynomial a) {
    for (Binary& c : a.coefficients) c = -c;
    return a;
  }
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + -b; }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial product;
    if (a.coefficients.empty() || b.coefficients.empty()) return product;
    product.coefficients.resize(a.coefficients.size() + b.coefficients.size() - 1);
    for (std::size_t i = 0; i < a.coefficients.size(); ++i) {
      for (std::size_t j = 0; j < b.coefficients.size(); ++j) {
        Binary& c = product.coefficients[i + j];
        c = c + a.coefficients[i] * b.coefficients[j];
      }
    }
    return product;
  }
};

/// The sign of a + e sqrt(b), e being -1, 0 or 1 and b not negative.
inline int sign_of(const Binary& a, int e, const Binary& b) {
  const int left = a.sign(), right = e * b.sign();
  if (left == 0 || right == 0 || left == right) return left == 0 ? right : left;
  const int larger = (a * a - b).sign();
  return larger == 0 ? 0 : larger > 0 ? left : right;
}

/// The sign of a + e sqrt(b) + f sqrt(c).
inline int sign_of(const Binary& a, int e, const Binary& b, int f, const Binary& c) {
  const int left = sign_of(a, e, b), right = f * c.sign();
  if (left == 0 || right == 0 || left == right) return left == 0 ? right : left;
  const Binary twice = a + a;
  const int larger = sign_of(a * a + b - c, e * a.sign(), twice * twice * b);
  return larger == 0 ? 0 : larger > 0 ? left : right;
}

/// (a + e sqrt(b)) / d, d > 0.
struct Root {
  Binary a, b, d;
  int e = 0;
  bool is_double = false;

  /// The sign of this less the other one.
  int compare(const Root& other) const {
    return sign_of(a * other.d - other.a * d, e, other.d * other.d * b, -other.e, d * d * other.b);
  }
  int compare(const Binary& x) const { return sign_of(a - x * d, e, b); }
  int compare(double x) const { return compare(Binary(x)); }
};

/// Distinct real roots, ascending, of a polynomial of degree at most 2. None of 0.
inline std::vector<Root> roots_of(const Polynomial& polynomial) {
  std::vector<Binary> p = polynomial.coefficients;
  while (!p.empty() && p.back().sign() == 0) p.pop_back();
  if (p.size() < 2) return {};
  const bool falls = p.back().sign() < 0;
  for (Binary& c : p) c = falls ? -c : c;
  if (p.size() == 2) return {{-p[0], Binary(), p[1]}};
  if (p.size() > 3) throw std::logic_error("the oracle has no roots of degree 3 and more");
  const Binary discriminant = p[1] * p[1] - Binary(4) * p[2] * p[0], twice = p[2] + p[2];
  if (discriminant.sign() < 0) return {};
  if (discriminant.sign() == 0) return {{-p[1], Binary(), twice, 0, true}};
  return {{-p[1], discriminant, twice, -1}, {-p[1], discriminant, twice, 1}};
}

/// The sign far below all roots.
inline int first_sign(const Polynomial& polynomial) {
  for (std::size_t i = polynomial.coefficients.size(); i-- > 0;) {
    const int sign = polynomial.coefficients[i].sign();
    if (sign != 0) return i % 2 == 0 ? sign : -sign;
  }
  return 0;
}

/// Whether t is the double nearest to the root, the even one of two.
inline bool is_nearest(const Root& root, double t) {
  if (!std::isfinite(t)) return false;
  const auto middle = [&](double to) { return (Binary(t) + Binary(std::nextafter(t, to))) * Binary(0.5); };
  const int above_lo = root.compare(middle(-INFINITY)), above_hi = root.compare(middle(INFINITY));
  int exponent = 0;
  const bool is_even = std::fmod(std::ldexp(std::frexp(t, &exponent), 53), 2.0) == 0;
  return (above_lo > 0 || (above_lo == 0 && is_even)) && (above_hi < 0 || (above_hi == 0 && is_even));
}

/// Whether |root - t| <= bound.
inline bool is_within(const Root& root, double t, const Binary& bound) {
  return root.compare(Binary(t) - bound) >= 0 && root.compare(Binary(t) + bound) <= 0;
}

}  // namespace sightline::oracle
