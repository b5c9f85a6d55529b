#pragma once
/// Numbers of 1200 bits; heavy to compile, so only oracles include it.

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "bench/accuracy/oracle.h"

namespace sightline::bench {

using Wide =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<1200, boost::multiprecision::digit_base_2>,
                                  boost::multiprecision::et_off>;

inline True true_of(const Wide& x) {
  const double high = static_cast<double>(x);
  return {high, static_cast<double>(Wide(x - high))};
}

struct WideVector {
  Wide x, y, z;

  WideVector(const Wide& its_x, const Wide& its_y, const Wide& its_z) : x(its_x), y(its_y), z(its_z) {}
  explicit WideVector(const Vec3d& v) : x(v.x), y(v.y), z(v.z) {}
  friend WideVector operator-(const WideVector& a, const WideVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};
inline Wide dot(const WideVector& a, const WideVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline WideVector cross(const WideVector& a, const WideVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Of a t^2 + 2 b t + c.
std::vector<True> wide_quadratic_roots(const Wide& a, const Wide& b, const Wide& c);

}  // namespace sightline::bench
