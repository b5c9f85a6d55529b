#pragma once
/// Exact real roots of polynomials: the last resort of every intersection, where no floating-point bound decides.

#include <memory>
#include <vector>

#include "sightline/math/integer_polynomial.h"

namespace sightline {

/// One real root of one polynomial.
///   A1  The polynomial kept is a factor without repeated roots; its values at both ends of the open interval are not
///       zero and of unlike signs, and the interval has one root. Or the root is dyadic, and both ends are the root.
///   A2  The interval does not have 0 inside or at an end, unless the root is 0.
///   A3  Intervals of different roots of one factor do not overlap.
class AlgebraicRoot {
 public:
  /// How often the root is one of the polynomial that real_roots was given.
  int multiplicity() const { return multiplicity_; }

  /// The nearest double, rounded correctly, as of Dyadic::nearest.
  double nearest() const;

  /// -1, 0 or 1, exactly.
  static int compare(const AlgebraicRoot& a, const AlgebraicRoot& b);

  /// The same against a double, which may be infinite but not NaN.
  int compare(double x) const;

  /// The sign of another polynomial at this root, exactly.
  int sign_of(const ExactPolynomial& p) const;

 private:
  friend class RootIsolation;
  using Factor = std::shared_ptr<const IntegerPolynomial>;

  AlgebraicRoot(Factor factor, Dyadic lo, Dyadic hi, int sign_below)
      : factor_(std::move(factor)), lo_(std::move(lo)), hi_(std::move(hi)), sign_below_(sign_below) {}

  bool is_dyadic() const { return sign_below_ == 0; }
  bool is_rational() const { return degree(*factor_) == 1; }
  int compare(const Dyadic& x) const;
  int sign_at(const IntegerPolynomial& p) const;
  int sign_where_not_zero(const IntegerPolynomial& p);
  void refine();
  void refine_rational();
  void jump();
  bool cut_at(const Dyadic& x);
  void become(const Dyadic& x);

  Factor factor_;
  Dyadic lo_, hi_;
  int sign_below_;    ///< Of the factor at lo; 0 where the root is dyadic.
  int cut_bits_ = 0;  ///< The next refinement bets on a part 2^cut_bits_ times smaller; at first 0, for jump().
  int multiplicity_ = 1;
};

/// The distinct real roots in ascending order. None of a constant, the zero polynomial included: that every number is a
/// root of it, the caller must see. For any degree, made for those up to 4.
std::vector<AlgebraicRoot> real_roots(const ExactPolynomial&);

}  // namespace sightline
