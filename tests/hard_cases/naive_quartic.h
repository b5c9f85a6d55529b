#pragma once
/// Quartics as first solvers have them.

#include <array>
#include <cmath>
#include <vector>

namespace sightline::hard {

/// Of t^2 + b t + c.
template <class T>
void add_quadratic_roots(T b, T c, T shift, std::vector<double>& found) {
  const T discriminant = b * b - 4 * c;
  if (!(discriminant >= 0)) return;
  found.push_back((-b - std::sqrt(discriminant)) / 2 + shift);
  found.push_back((-b + std::sqrt(discriminant)) / 2 + shift);
}

/// A real root of z^3 + a z^2 + b z + c, by the formula of Cardano or the cosine of a third; where there are three, the
/// lowest (0), highest (1) or middle one (2).
template <class T, int which>
T naive_cubic_root(T a, T b, T c) {
  const T q = (a * a - 3 * b) / 9, r = (2 * a * a * a - 9 * a * b + 27 * c) / 54;
  if (r * r < q * q * q) {
    const T angle = std::acos(r / std::sqrt(q * q * q));
    return -2 * std::sqrt(q) * std::cos((angle + which * 2 * T(3.14159265358979)) / 3) - a / 3;
  }
  const T size = std::cbrt(std::fabs(r) + std::sqrt(r * r - q * q * q)), s = r > 0 ? -size : size;
  return s + (s == 0 ? 0 : q / s) - a / 3;
}

/// Ferrari's way, as it stands in books: two quadratics, from a root of the resolvent cubic. Coefficients are from the
/// lowest on.
template <class T, int which = 1>
std::vector<double> naive_quartic_roots(const std::array<double, 5>& coefficients) {
  const auto k = [&](std::size_t i) { return static_cast<T>(coefficients[i]) / static_cast<T>(coefficients[4]); };
  const T b = k(3), c = k(2), d = k(1), e = k(0), b2 = b * b, shift = -b / 4;
  const T p = c - 3 * b2 / 8, q = d - b * c / 2 + b2 * b / 8, r = e - b * d / 4 + b2 * c / 16 - 3 * b2 * b2 / 256;
  const T z = naive_cubic_root<T, which>(2 * p, p * p - 4 * r, -q * q);
  std::vector<double> found;
  if (!(z > 0)) return found;
  const T s = std::sqrt(z);
  add_quadratic_roots(s, (p + z - q / s) / 2, shift, found);
  add_quadratic_roots(-s, (p + z + q / s) / 2, shift, found);
  return found;
}

}  // namespace sightline::hard
