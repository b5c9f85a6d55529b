#include "bench/accuracy/oracle.h"

#include <boost/multiprecision/gmp.hpp>

#include "bench/accuracy/oracle_wide.h"

namespace sightline::bench {

std::optional<TrueCrossing> true_crossing(const Triangle& triangle, const Ray<double>& ray) {
  const WideVector origin(ray.origin), direction(ray.direction);
  const WideVector a = WideVector(Vec3d(triangle.a)) - origin, b = WideVector(Vec3d(triangle.b)) - origin,
                   c = WideVector(Vec3d(triangle.c)) - origin;
  // Volumes that the direction spans with the edges: of one sign where it passes between them.
  const Wide u = dot(direction, cross(c, b)), v = dot(direction, cross(a, c)), w = dot(direction, cross(b, a));
  const bool has_positive = u > 0 || v > 0 || w > 0, has_negative = u < 0 || v < 0 || w < 0;
  if (has_positive == has_negative) return std::nullopt;  // of both signs, or all 0: seen edge-on
  const Wide sum = u + v + w;
  const Wide height = u * dot(a, direction) + v * dot(b, direction) + w * dot(c, direction);
  return TrueCrossing{true_of(height / (sum * dot(direction, direction))), true_of(v / sum), true_of(w / sum)};
}

bool truly_meets(const Aabb& box, const Ray<double>& ray) {
  using Rational = boost::multiprecision::mpq_rational;
  Rational lo = ray.t_min, hi = 0;
  bool is_bounded = std::isfinite(ray.t_max);
  if (is_bounded) hi = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const Rational o = ray.origin[axis], d = ray.direction[axis], below = Rational(box.lo[axis]) - o,
                   above = Rational(box.hi[axis]) - o;
    if (d == 0) {
      if (below > 0 || above < 0) return false;
      continue;
    }
    const Rational enter = (d > 0 ? below : above) / d, leave = (d > 0 ? above : below) / d;
    if (enter > lo) lo = enter;
    if (!is_bounded || leave < hi) hi = leave;
    is_bounded = true;
  }
  return !is_bounded || lo <= hi;
}

std::vector<True> wide_quadratic_roots(const Wide& a, const Wide& b, const Wide& c) {
  const Wide discriminant = b * b - a * c;
  if (discriminant < 0) return {};
  if (discriminant == 0) return {true_of(-b / a)};
  const Wide root = sqrt(discriminant);
  const Wide q = b > 0 ? Wide(-b - root) : Wide(root - b);
  True one = true_of(q / a), other = true_of(c / q);
  if (other < one) std::swap(one, other);
  return {one, other};
}

std::vector<True> true_quadratic_roots(double a, double b, double c) {
  return wide_quadratic_roots(Wide(a), Wide(b), Wide(c));
}

std::vector<True> true_sphere_roots(const Vec3d& center, double radius, const Ray<double>& ray) {
  const WideVector from = WideVector(ray.origin) - WideVector(center), direction(ray.direction);
  return wide_quadratic_roots(dot(direction, direction), dot(from, direction), dot(from, from) - Wide(radius) * radius);
}

std::array<True, 3> true_walk(const std::array<int, 4>& turn, const Vec3d& move, std::size_t count) {
  const Wide w = turn[0], x = turn[1], y = turn[2], z = turn[3], size = w * w + x * x + y * y + z * z;
  const Wide rows[3][3] = {
      {(w * w + x * x - y * y - z * z) / size, 2 * (x * y - w * z) / size, 2 * (x * z + w * y) / size},
      {2 * (x * y + w * z) / size, (w * w - x * x + y * y - z * z) / size, 2 * (y * z - w * x) / size},
      {2 * (x * z - w * y) / size, 2 * (y * z + w * x) / size, (w * w - x * x - y * y + z * z) / size}};
  WideVector at(Vec3d(0));
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = [&](int r) { return Wide(dot(at, {rows[r][0], rows[r][1], rows[r][2]}) + move[r]); };
    at = {row(0), row(1), row(2)};
  }
  return {true_of(at.x), true_of(at.y), true_of(at.z)};
}

}  // namespace sightline::bench
