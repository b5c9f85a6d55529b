#include "sightline/shape/torus.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sightline/math/algebraic_root.h"
#include "sightline/math/quartic.h"
#include "sightline/math/rounding.h"

namespace sightline {
namespace {

/// A line seen from the torus: `w` is the point at parameter t0, near the one closest to the center, from which
/// rounding does no harm however far away the ray begins.
///   S1  w is the exact point, rounded to double-double.
struct SeenLine {
  double t0;
  std::array<DoubleDouble, 3> w;
};

SeenLine seen_from(const Torus& torus, const Ray<double>& ray) {
  const Vec3d rough = ray.origin - torus.center;
  SeenLine line{-glm::dot(rough, ray.direction) / glm::dot(ray.direction, ray.direction), {}};
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble from_center(two_sum(ray.origin[i], -torus.center[i]));
    line.w[static_cast<std::size_t>(i)] = from_center + DoubleDouble(two_product(line.t0, ray.direction[i]));
  }
  return line;
}

template <class N>
std::array<N, 3> array_of(const Vec3d& v) {
  return {N(v.x), N(v.y), N(v.z)};
}

Vec3d leading_of(const std::array<DoubleDouble, 3>& w) { return {w[0].high, w[1].high, w[2].high}; }

/// Sizes that bound all intermediate results.
struct Sizes {
  double axis, direction, point, radius;

  /// Within these, nothing in the polynomial overflows, and what underflow adds to a coefficient is below 2^-700.
  bool are_moderate() const {
    constexpr double least = 0x1p-60, most = 0x1p+60;
    return std::min({axis, direction, radius}) > least && std::max({axis, direction, point, radius}) < most;
  }
};

Sizes sizes_of(const Torus& torus, const Ray<double>& ray, const Vec3d& w) {
  return {max_norm(torus.axis), max_norm(ray.direction), max_norm(w), torus.major + torus.minor};
}

/// True only where the line misses the sphere around the torus, of moderate sizes. The point is off by 2^-52 of its
/// size, and all else here by fewer than 2^5 roundings.
bool misses_sphere(const Torus& torus, const Vec3d& w, const Vec3d& direction) {
  const double along = glm::dot(w, direction), size2 = glm::dot(w, w);
  const double distance2 = size2 - along * along / glm::dot(direction, direction), radius = torus.major + torus.minor;
  return distance2 - 0x1p-46 * size2 > radius * radius * (1 + 0x1p-46);
}

/// The polynomial in double, each coefficient within a bound that takes sums of absolute values for sums:
///   S2  Components of w are off by 2 u of the largest, u = 2^-53. Up to 27 roundings later no coefficient is off by
///       more than 32 u = 2^-48 of its bound.
std::array<DoubleBall, 5> bounded_polynomial(const Torus& torus, const Sizes& sizes, const std::array<double, 5>& c) {
  const double a2 = 3 * sizes.axis * sizes.axis, d2 = 3 * sizes.direction * sizes.direction;
  const double wd = 3 * sizes.point * sizes.direction, w2 = 3 * sizes.point * sizes.point;
  const double major2 = torus.major * torus.major, g = w2 + major2 + torus.minor * torus.minor, s = 16 * major2 * a2;
  const std::array<double, 5> bound = {a2 * g * g + s * w2, 4 * a2 * wd * g + 2 * s * wd,
                                       a2 * (4 * wd * wd + 2 * d2 * g) + s * d2, 4 * a2 * d2 * wd, a2 * d2 * d2};
  std::array<DoubleBall, 5> balls;
  for (std::size_t i = 0; i < 5; ++i) balls[i] = {c[i], 0x1p-48 * bound[i] + 0x1p-700};
  return balls;
}

std::array<WideBall, 5> wide_polynomial(const Torus& torus, const Ray<double>& ray, const SeenLine& line) {
  std::array<WideBall, 3> w;
  for (std::size_t i = 0; i < 3; ++i) {
    // S1; where digits may be lost to underflow as well.
    w[i] = {line.w[i], 0x1p-99 * std::fabs(line.w[i].high) + 0x1p-1000};
  }
  return detail::torus_polynomial(array_of<WideBall>(torus.axis), WideBall(torus.major), WideBall(torus.minor), w,
                                  array_of<WideBall>(ray.direction));
}

void shift(RootList& list, double t0) {
  for (int i = 0; i < list.count; ++i) {
    Root& root = list.roots[static_cast<std::size_t>(i)];
    root.t += t0;
    if (root.radius > 0) root.radius += 0x1p-53 * std::fabs(root.t);
    root.radius *= 1 + 0x1p-50;
  }
}

RootList float_roots(const Torus& torus, const Ray<double>& ray, const SeenLine& line) {
  const double length = glm::length(ray.direction);
  const Vec3d w = leading_of(line.w), d = ray.direction / length, a = glm::normalize(torus.axis);
  RootList list =
      quartic_roots(detail::torus_polynomial(array_of<float>(a), static_cast<float>(torus.major),
                                             static_cast<float>(torus.minor), array_of<float>(w), array_of<float>(d)));
  for (int i = 0; i < list.count; ++i) {
    double& t = list.roots[static_cast<std::size_t>(i)].t;
    t = static_cast<float>(line.t0 + t / length);
  }
  return list;
}

RootList exact_roots(const Torus& torus, const Ray<double>& ray) {
  const std::array<Dyadic, 5> c = polynomial(torus, FramedRay(ray).in<Dyadic>());
  RootList list;
  for (const AlgebraicRoot& root : real_roots({c.begin(), c.end()})) {
    const double t = root.nearest();
    list.add({t, 0x1p-53 * std::fabs(t) + std::numeric_limits<double>::denorm_min(), root.multiplicity()});
  }
  return list;
}

/// Rounds certain roots correctly, as far as 100 bits can; false where they cannot.
bool round_roots(const std::array<WideBall, 5>& coefficients, const RootList& rough, double t0, RootList& list) {
  const auto f = bounded<WideBall, 4>(coefficients);
  list = rough;
  for (int i = 0; i < rough.count; ++i) {
    Root& root = list.roots[static_cast<std::size_t>(i)];
    const int sign = i % 2 == 0 ? 1 : -1;  // positive before the first of simple roots
    const detail::Mark<DoubleDouble> from{DoubleDouble(two_sum(root.t, -root.radius)), sign, 0};
    const detail::Mark<DoubleDouble> to{DoubleDouble(two_sum(root.t, root.radius)), -sign, 0};
    const auto cluster = detail::simple_root(f, from, to);
    const DoubleDouble t = cluster.mid + DoubleDouble(t0);
    const double width = std::max(detail::distance(cluster.mid, cluster.hi), detail::distance(cluster.lo, cluster.mid));
    const double off = (std::fabs(t.low) + width + 0x1p-100 * std::fabs(t.high)) * (1 + 0x1p-40);
    // What is less than half way to the neighbours is rounded back.
    if (t.high + off != t.high || t.high - off != t.high || !(std::fabs(t.high) > 0x1p-900)) return false;
    root.t = t.high;
    root.radius = off;
  }
  return true;
}

}  // namespace

RootList torus_roots(const Torus& torus, const Ray<double>& ray, Level level) {
  const SeenLine line = seen_from(torus, ray);
  const Vec3d w = leading_of(line.w);
  const Sizes sizes = sizes_of(torus, ray, w);
  const bool is_moderate = sizes.are_moderate();
  if (is_moderate && misses_sphere(torus, w, ray.direction)) return {};
  if (level == Level::fast) return float_roots(torus, ray, line);

  const std::array<double, 5> c = detail::torus_polynomial(array_of<double>(torus.axis), torus.major, torus.minor,
                                                           array_of<double>(w), array_of<double>(ray.direction));
  RootList list;
  list.is_certain = false;
  if (level == Level::watertight) {
    list = quartic_roots(c);
    shift(list, line.t0);
    return list;
  }
  if (is_moderate) list = quartic_roots(bounded_polynomial(torus, sizes, c));
  if (list.is_certain && (level == Level::precise || list.count == 0)) {
    shift(list, line.t0);
    return list;
  }
  const std::array<WideBall, 5> wide = wide_polynomial(torus, ray, line);
  if (!list.is_certain) list = quartic_roots(wide);
  if (level == Level::exact) {
    RootList rounded;
    return list.is_certain && round_roots(wide, list, line.t0, rounded) ? rounded : exact_roots(torus, ray);
  }
  shift(list, line.t0);
  return list;
}

Aabb bounds_of(const Torus& torus) {
  const Vec3d a2 = torus.axis * torus.axis / (max_norm(torus.axis) * max_norm(torus.axis));
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    const double across = a2[(i + 1) % 3] + a2[(i + 2) % 3];
    // Fewer than 16 roundings.
    const double reach = (torus.major * std::sqrt(across / (across + a2[i])) + torus.minor) * (1 + 0x1p-49);
    box.lo[i] = round_down(next_down(torus.center[i] - reach));
    box.hi[i] = round_up(next_up(torus.center[i] + reach));
  }
  return box;
}

Vec3d normal_at(const Torus& torus, const Vec3d& point) {
  const Vec3d q = point - torus.center, axis = torus.axis / max_norm(torus.axis);
  const Vec3d up = glm::normalize(axis);
  const double height = glm::dot(q, up);
  const Vec3d radial = q - height * up;
  const double distance = glm::length(radial);
  if (!(distance > 0)) return height < 0 ? -up : up;
  // On a lemon, where this is negative, outward is inward.
  const double side = glm::dot(q, q) + (torus.major - torus.minor) * (torus.major + torus.minor) < 0 ? -1 : 1;
  const Vec3d normal = side * q - (torus.major / distance) * radial;
  const double length = glm::length(normal);
  return length > 0 ? normal / length : radial / distance;
}

}  // namespace sightline
