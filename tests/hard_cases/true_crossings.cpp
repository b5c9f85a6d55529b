#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "tests/hard_cases/mesh_question.h"

namespace sightline::hard {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

struct Whole {
  Integer x, y, z;
};
Whole operator-(const Whole& p, const Whole& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
Whole operator+(const Whole& p, const Whole& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
Whole operator*(const Integer& s, const Whole& p) { return {s * p.x, s * p.y, s * p.z}; }
Integer dot(const Whole& p, const Whole& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
Whole cross(const Whole& p, const Whole& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

/// Exponent of the last of a double's 53 bits.
int last_place(double x) { return x == 0 ? 1000 : std::ilogb(x) - 52; }

Integer scaled(double x, int exponent) {
  if (x == 0) return 0;
  const int own = last_place(x);
  return Integer(static_cast<std::int64_t>(std::ldexp(x, -own))) << (own - exponent);
}
Whole scaled(const Vec3d& p, int exponent) {
  return {scaled(p.x, exponent), scaled(p.y, exponent), scaled(p.z, exponent)};
}

/// Surely missed: the line passes an edge on the one side and another on the other, by far more than doubles err.
bool is_far_off(const Ray<double>& ray, const Triangle& triangle) {
  const Vec3d a = Vec3d(triangle.a) - ray.origin, b = Vec3d(triangle.b) - ray.origin,
              c = Vec3d(triangle.c) - ray.origin;
  const double reach = glm::length(a) + glm::length(b) + glm::length(c) + glm::length(ray.origin),
               doubt = 1e-12 * reach * reach * glm::length(ray.direction);
  const double u = glm::dot(ray.direction, glm::cross(c, b)), v = glm::dot(ray.direction, glm::cross(a, c)),
               w = glm::dot(ray.direction, glm::cross(b, a));
  return std::min({u, v, w}) < -doubt && std::max({u, v, w}) > doubt;
}

std::optional<Rational> crossing(const Ray<double>& ray, const Triangle& triangle) {
  const Vec3d corners[3] = {Vec3d(triangle.a), Vec3d(triangle.b), Vec3d(triangle.c)};
  int exponent = 1000;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Vec3d& p : corners) exponent = std::min(exponent, last_place(p[axis]));
    exponent = std::min({exponent, last_place(ray.origin[axis]), last_place(ray.direction[axis])});
  }
  const Whole a = scaled(corners[0], exponent), b = scaled(corners[1], exponent), c = scaled(corners[2], exponent),
              o = scaled(ray.origin, exponent), d = scaled(ray.direction, exponent);
  const Whole normal = cross(b - a, c - a);
  const Integer slope = dot(normal, d), height = dot(normal, a - o);
  if (slope == 0) return std::nullopt;
  const Whole point = slope * o + height * d;  // times the slope
  const int side = slope > 0 ? 1 : -1;
  const auto is_outside = [&](const Whole& from, const Whole& to) {
    return dot(cross(to - from, point - slope * from), normal) * side < 0;
  };
  if (is_outside(a, b) || is_outside(b, c) || is_outside(c, a)) return std::nullopt;
  return Rational(Integer(side * height), Integer(side * slope));
}

/// To nearest, of two equally near ones the even.
template <class T>
T rounded(const Rational& t) {
  T best = static_cast<T>(t.convert_to<double>());
  for (const T towards : {-std::numeric_limits<T>::infinity(), std::numeric_limits<T>::infinity()}) {
    const T next = std::nextafter(best, towards);
    if (!std::isfinite(next) || !std::isfinite(best)) continue;
    const Rational better = abs(Rational(best) - t) - abs(Rational(next) - t);
    if (better > 0 ||
        (better == 0 &&
         std::fmod(std::ldexp(double(next), -std::ilogb(next) + std::numeric_limits<T>::digits - 1), 2.0) == 0))
      best = next;
  }
  return best;
}

}  // namespace

std::vector<TrueCrossing> true_crossings(const TriangleMesh& mesh, const Ray<double>& ray) {
  std::vector<std::pair<Rational, std::uint32_t>> found;
  for (std::uint32_t id = 0; id < mesh.size(); ++id) {
    const Triangle triangle = mesh[id];
    if (is_far_off(ray, triangle)) continue;
    const std::optional<Rational> t = crossing(ray, triangle);
    if (!t || (std::isfinite(ray.t_min) && *t <= Rational(ray.t_min))) continue;
    if (std::isfinite(ray.t_max) && *t > Rational(ray.t_max)) continue;
    found.emplace_back(*t, id);
  }
  std::sort(found.begin(), found.end());
  std::vector<TrueCrossing> crossings;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::uint32_t rank =
        i == 0 ? 0 : crossings[i - 1].rank + static_cast<std::uint32_t>(found[i].first != found[i - 1].first);
    crossings.push_back({found[i].second, rank, rounded<float>(found[i].first), rounded<double>(found[i].first)});
  }
  return crossings;
}

}  // namespace sightline::hard
