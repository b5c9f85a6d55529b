#include "bench/peers/ferrari.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sightline::bench {
namespace {

/// The largest real root of z^3 + a z^2 + b z + c.
double largest_cubic_root(double a, double b, double c) {
  const double q = (a * a - 3 * b) / 9, r = (2 * a * a * a - 9 * a * b + 27 * c) / 54, q3 = q * q * q;
  if (r * r < q3) {
    const double angle = std::acos(std::clamp(r / std::sqrt(q3), -1.0, 1.0));
    return -2 * std::sqrt(q) * std::cos((angle + 2 * std::numbers::pi) / 3) - a / 3;
  }
  const double s = -std::copysign(std::cbrt(std::fabs(r) + std::sqrt(r * r - q3)), r);
  return s + (s == 0 ? 0 : q / s) - a / 3;
}

}  // namespace

int ferrari_roots(double a, double b, double c, double d, std::array<double, 4>& roots) {
  // y^4 + p y^2 + q y + r with x = y - a/4.
  const double a2 = a * a, p = b - 0.375 * a2, q = c - 0.5 * a * b + 0.125 * a2 * a;
  const double r = d - 0.25 * a * c + 0.0625 * a2 * b - 3.0 / 256 * a2 * a2;
  std::size_t count = 0;
  const auto add_pair = [&](double middle, double square) {
    if (!(square >= 0)) return;
    const double half = 0.5 * std::sqrt(square);
    roots[count++] = middle - half - 0.25 * a;
    roots[count++] = middle + half - 0.25 * a;
  };
  const double z = largest_cubic_root(2 * p, p * p - 4 * r, -q * q);
  if (z > 0) {
    const double s = std::sqrt(z), k = p + z, h = q / s;
    add_pair(-0.5 * s, z - 2 * (k - h));
    add_pair(0.5 * s, z - 2 * (k + h));
  } else if (const double square = p * p - 4 * r; square >= 0) {
    add_pair(0, 2 * (-p + std::sqrt(square)));
    add_pair(0, 2 * (-p - std::sqrt(square)));
  }
  std::sort(roots.begin(), roots.begin() + count);
  return static_cast<int>(count);
}

int ferrari_roots(const Torus& torus, const Ray<double>& ray, std::array<double, 4>& roots) {
  const double length = glm::length(ray.direction);
  const Vec3d d = ray.direction / length, o = ray.origin - torus.center, a = torus.axis;
  const double od = glm::dot(o, d), oo = glm::dot(o, o), oa = glm::dot(o, a), da = glm::dot(d, a);
  const double reach = torus.major + torus.minor, major2 = torus.major * torus.major;
  if (oo - od * od > reach * reach) return 0;
  const double k = oo + major2 - torus.minor * torus.minor;
  const int count = ferrari_roots(4 * od, 4 * od * od + 2 * k - 4 * major2 * (1 - da * da),
                                  4 * od * k - 8 * major2 * (od - oa * da), k * k - 4 * major2 * (oo - oa * oa), roots);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) roots[i] /= length;
  return count;
}

}  // namespace sightline::bench
