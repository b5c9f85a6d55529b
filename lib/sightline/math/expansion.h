#pragma once
/// Exact sums and products of doubles as nonoverlapping expansions.
/// Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997.

#include <array>
#include <cmath>

namespace sightline {

/// high + low == a + b exactly, high the rounded sum (Knuth).
struct TwoTerms {
  double high;
  double low;
};
inline TwoTerms two_sum(double a, double b) {
  const double high = a + b;
  const double b_part = high - a;
  return {high, (a - (high - b_part)) + (b - b_part)};
}

/// high + low == a * b exactly, unless the product overflows or its low part underflows.
inline TwoTerms two_product(double a, double b) {
  const double high = a * b;
  return {high, std::fma(a, b, -high)};
}

/// The exact sum of at most `Capacity` doubles that do not overlap, in increasing magnitude, none of them zero.
///   E1  Adding one double to n terms leaves at most n + 1; multiplying n terms by m gives at most 2 n m.
/// Exact as long as no product leaves the range of double; products of three float-born differences never do.
template <int Capacity>
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(double x) { grow(x); }

  int size() const { return size_; }
  double term(int i) const { return terms_[i]; }

  void grow(double x) {
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
      const auto [high, low] = two_sum(x, terms_[i]);
      x = high;
      if (low != 0) terms_[kept++] = low;
    }
    if (x != 0) terms_[kept++] = x;
    size_ = kept;
  }

  /// -1, 0 or 1, exactly: the largest term decides.
  int sign() const { return size_ == 0 ? 0 : terms_[size_ - 1] > 0 ? 1 : -1; }

  /// Within one unit in the last place of the exact value.
  double estimate() const {
    double sum = 0;
    for (int i = 0; i < size_; ++i) sum += terms_[i];
    return sum;
  }

  Expansion operator-() const {
    Expansion negated = *this;
    for (int i = 0; i < size_; ++i) negated.terms_[i] = -negated.terms_[i];
    return negated;
  }

 private:
  std::array<double, Capacity> terms_;
  int size_ = 0;
};

template <int N, int M>
Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<N + M> sum;
  for (int i = 0; i < a.size(); ++i) sum.grow(a.term(i));
  for (int i = 0; i < b.size(); ++i) sum.grow(b.term(i));
  return sum;
}

template <int N, int M>
Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b) {
  return a + (-b);
}

template <int N, int M>
Expansion<2 * N * M> operator*(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<2 * N * M> product;
  for (int i = 0; i < a.size(); ++i) {
    for (int j = 0; j < b.size(); ++j) {
      const auto [high, low] = two_product(a.term(i), b.term(j));
      product.grow(low);
      product.grow(high);
    }
  }
  return product;
}

/// a - b without rounding.
inline Expansion<2> exact_difference(double a, double b) {
  Expansion<2> difference(a);
  difference.grow(-b);
  return difference;
}

}  // namespace sightline
