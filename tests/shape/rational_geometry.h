#pragma once
/// Vectors of rational numbers, for oracles.

#include <boost/multiprecision/cpp_int.hpp>

#include "sightline/shape/line.h"

namespace sightline {

using Rational = boost::multiprecision::cpp_rational;

struct ExactVector {
  Rational x, y, z;

  Rational& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
};

inline ExactVector exact(const Vec3d& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
inline ExactVector operator+(const ExactVector& p, const ExactVector& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
inline ExactVector operator-(const ExactVector& p, const ExactVector& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
inline ExactVector operator*(const Rational& s, const ExactVector& p) { return {s * p.x, s * p.y, s * p.z}; }
inline Rational dot(const ExactVector& p, const ExactVector& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
inline ExactVector cross(const ExactVector& p, const ExactVector& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

struct ExactLine {
  ExactVector origin, direction;
};

inline ExactLine exact(const Ray<double>& ray, const Frame& frame = {}) {
  const ExactLine world{exact(ray.origin), exact(ray.direction)};
  ExactLine line;
  for (int i = 0; i < 3; ++i) {
    const auto& row = frame.rows[static_cast<std::size_t>(i)];
    const ExactVector v = exact(Vec3d(row[0], row[1], row[2]));
    line.origin[i] = dot(v, world.origin) + Rational(row[3]);
    line.direction[i] = dot(v, world.direction);
  }
  return line;
}

}  // namespace sightline
