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
  Triple<DoubleDouble> w;
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

Vec3d leading_of(const Triple<DoubleDouble>& w) { return {w[0].high, w[1].high, w[2].high}; }

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
  Triple<WideBall> w;
  for (std::size_t i = 0; i < 3; ++i) {
    // S1; where digits may be lost to underflow as well.
    w[i] = {line.w[i], 0x1p-99 * std::fabs(line.w[i].high) + 0x1p-1000};
  }
  return detail::torus_polynomial(triple<WideBall>(torus.axis), WideBall(torus.major), WideBall(torus.minor), w,
                                  triple<WideBall>(ray.direction));
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
      quartic_roots(detail::torus_polynomial(triple<float>(a), static_cast<float>(torus.major),
                                             static_cast<float>(torus.minor), triple<float>(w), triple<float>(d)));
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

/// x * 2^k where that is exact, as it is without underflow; else `is_exact` becomes false.
Vec3d scaled(const Vec3d& v, int k, bool& is_exact) {
  const Vec3d result{std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
  is_exact = is_exact && Vec3d(std::ldexp(result.x, -k), std::ldexp(result.y, -k), std::ldexp(result.z, -k)) == v;
  return result;
}

/// What is too large or too small by itself, in units that are powers of two. Exact where that does not help: at lines
/// that begin 2^60 torus radii away.
RootList rescaled_roots(const Torus& torus, const Ray<double>& ray, Level level) {
  const double radius = torus.major + torus.minor;
  if (!(radius > 0)) return exact_roots(torus, ray);
  const int k = -std::ilogb(radius), m = -std::ilogb(max_norm(ray.direction)), n = -std::ilogb(max_norm(torus.axis));
  bool is_exact = true;
  const Vec3d radii = scaled({torus.major, torus.minor, 0}, k, is_exact);
  const Torus unit{scaled(torus.center, k, is_exact), scaled(torus.axis, n, is_exact), radii.x, radii.y};
  const Ray<double> unit_ray{scaled(ray.origin, k, is_exact), scaled(ray.direction, m, is_exact)};
  if (!is_exact || !sizes_of(unit, unit_ray, leading_of(seen_from(unit, unit_ray).w)).are_moderate()) {
    return exact_roots(torus, ray);
  }
  RootList list = torus_roots(unit, unit_ray, level);
  for (int i = 0; i < list.count; ++i) {
    Root& root = list.roots[static_cast<std::size_t>(i)];
    root.t = std::ldexp(root.t, m - k);
    if (root.radius > 0) root.radius = std::ldexp(root.radius, m - k) + std::numeric_limits<double>::denorm_min();
  }
  return list;
}

/// The polynomial at t in some 100 bits, from the point there, and a proven bound of its error.
class WideTorus {
 public:
  /// Sizes are moderate.
  WideTorus(const Torus& torus, const Ray<double>& ray, const Sizes& sizes)
      : ray_(ray), sizes_(sizes), axis_(triple<DoubleDouble>(torus.axis)), size2_(dot(axis_, axis_)) {
    for (int i = 0; i < 3; ++i) {
      from_center_[static_cast<std::size_t>(i)] = DoubleDouble(two_sum(ray.origin[i], -torus.center[i]));
    }
    const DoubleDouble major2(two_product(torus.major, torus.major)), minor2(two_product(torus.minor, torus.minor));
    difference_ = major2 - minor2;
    scale_ = {4 * major2.high, 4 * major2.low};
  }

  BoundedValue<DoubleDouble> at(double t) const {
    Triple<DoubleDouble> q;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      q[k] = from_center_[k] + DoubleDouble(two_product(t, ray_.direction[i]));
    }
    const DoubleDouble q2 = dot(q, q), g = q2 + difference_;
    const Triple<DoubleDouble> v = cross(axis_, q);
    const DoubleDouble value = size2_ * (g * g) - scale_ * dot(v, v);
    // As S2, of operations that are off by 10 u^2 at most: fewer than 32 times that, 2^-97.
    const double point = std::max({std::fabs(q[0].high), std::fabs(q[1].high), std::fabs(q[2].high)});
    const double a2 = 3 * sizes_.axis * sizes_.axis, w2 = 3 * point * point;
    const double g_size = w2 + sizes_.radius * sizes_.radius, s = 16 * sizes_.radius * sizes_.radius * a2;
    return {value, 0, 0x1p-97 * (a2 * g_size * g_size + s * w2) + 0x1p-700};
  }

 private:
  const Ray<double>& ray_;
  Sizes sizes_;
  Triple<DoubleDouble> axis_, from_center_;
  DoubleDouble size2_, difference_, scale_;
};

/// Rounds simple roots correctly by a step of Newton's from the double nearby, as far as 100 bits can; false where they
/// cannot. `f` is the polynomial in t - t0.
bool round_roots(const BoundedPolynomial<Arithmetic<DoubleBall>, 4>& f, const WideTorus& wide, double t0,
                 RootList& list) {
  for (int i = 0; i < list.count; ++i) {
    Root& root = list.roots[static_cast<std::size_t>(i)];
    const double start = t0 + root.t;
    // The step ends in the root for a slope somewhere between here and there (mean value theorem).
    const double away = 2 * root.radius + 0x1p-51 * std::fabs(start), size = std::fabs(root.t) + away;
    const double slope = f.at(root.t).slope;
    const double slope_off = (f.slope_bound(size) + 2 * away * f.half_curvature(size)) / std::fabs(slope);
    if (!(slope_off < 0x1p-4)) return false;
    const BoundedValue<DoubleDouble> at = wide.at(start);
    const DoubleDouble t(two_sum(start, -at.value.high / slope));
    const double off =
        std::fabs(t.low) +
        (at.bound / std::fabs(slope) + std::fabs(at.value.high / slope) * (slope_off + 0x1p-50)) * (1 + 0x1p-3);
    const double reach = off * (1 + 0x1p-40);
    // What is less than half way to the neighbours is rounded back.
    if (t.high + reach != t.high || t.high - reach != t.high || !(std::fabs(t.high) > 0x1p-900)) return false;
    root.t = t.high;
    root.radius = reach;
  }
  return true;
}

}  // namespace

RootList torus_roots(const Torus& torus, const Ray<double>& ray, Level level) {
  if (!is_finite(ray.origin) || !is_finite(ray.direction) || ray.direction == Vec3d(0)) return {};
  const SeenLine line = seen_from(torus, ray);
  const Vec3d w = leading_of(line.w);
  const Sizes sizes = sizes_of(torus, ray, w);
  const bool is_moderate = sizes.are_moderate();
  if (!is_moderate && level != Level::exact) return rescaled_roots(torus, ray, level);
  if (is_moderate && misses_sphere(torus, w, ray.direction)) return {};
  if (level == Level::fast) return float_roots(torus, ray, line);

  const std::array<double, 5> c = detail::torus_polynomial(triple<double>(torus.axis), torus.major, torus.minor,
                                                           triple<double>(w), triple<double>(ray.direction));
  RootList list;
  list.is_certain = false;
  if (level == Level::watertight) {
    list = quartic_roots(c);
    shift(list, line.t0);
    return list;
  }
  if (is_moderate) {
    const std::array<DoubleBall, 5> balls = bounded_polynomial(torus, sizes, c);
    list = quartic_roots(balls);
    if (list.is_certain && level == Level::exact && list.count > 0) {
      if (round_roots(bounded<DoubleBall, 4>(balls), WideTorus(torus, ray, sizes), line.t0, list)) return list;
      return exact_roots(torus, ray);
    }
  }
  if (!list.is_certain) list = quartic_roots(wide_polynomial(torus, ray, line));
  // Correct rounding is left to integers where even doubles were not enough to count.
  if (level == Level::exact && (list.count > 0 || !list.is_certain)) return exact_roots(torus, ray);
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
