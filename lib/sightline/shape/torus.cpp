#include "sightline/shape/torus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

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

/// The sum of squares of high + low, up to what low^2 adds, where low is some roundings of what high comes from.
/// Rounding errors of the first order are kept (Ogita, Rump and Oishi, "Accurate sum and dot product", 2005).
[[gnu::always_inline]] inline DoubleDouble sum_of_squares(const Triple<DoubleDouble>& v) {
  const TwoTerms x = two_product(v[0].high, v[0].high), y = two_product(v[1].high, v[1].high),
                 z = two_product(v[2].high, v[2].high);
  const TwoTerms xy = two_sum(x.high, y.high), xyz = two_sum(xy.high, z.high);
  const double mixed = std::fma(v[0].high, v[0].low, std::fma(v[1].high, v[1].low, v[2].high * v[2].low));
  return DoubleDouble(two_sum(xyz.high, (x.low + y.low + z.low) + (xy.low + xyz.low) + (mixed + mixed)));
}

/// The polynomial at t in some 100 bits, from the point there, and a proven bound of its error.
class WideTorus {
 public:
  /// Sizes are moderate.
  WideTorus(const Torus& torus, const Ray<double>& ray, const Sizes& sizes)
      : ray_(ray), axis_(torus.axis), size2_(sum_of_squares(triple<DoubleDouble>(torus.axis))) {
    for (int i = 0; i < 3; ++i) {
      from_center_[static_cast<std::size_t>(i)] = DoubleDouble(two_sum(ray.origin[i], -torus.center[i]));
    }
    const DoubleDouble major2(two_product(torus.major, torus.major)), minor2(two_product(torus.minor, torus.minor));
    difference_ = major2 - minor2;
    scale_ = {4 * major2.high, 4 * major2.low};
    a2_ = 3 * sizes.axis * sizes.axis;
    radius2_ = sizes.radius * sizes.radius;
  }

  [[gnu::always_inline]] BoundedValue<DoubleDouble> at(double t) const {
    Triple<DoubleDouble> q;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      q[k] = from_center_[k] + DoubleDouble(two_product(t, ray_.direction[i]));
    }
    const DoubleDouble g = sum_of_squares(q) + difference_;
    const DoubleDouble v2 = sum_of_squares({cross_part(1, 2, q), cross_part(2, 0, q), cross_part(0, 1, q)});
    const DoubleDouble value = size2_ * (g * g) - scale_ * v2;
    // Of sums of absolute values, as in S2, q is off by 4 u^2, its square and that of v by fewer than 50, and the whole
    // by fewer than 2^8: 2^-98, and twice that.
    const double point = std::max({std::fabs(q[0].high), std::fabs(q[1].high), std::fabs(q[2].high)});
    const double w2 = 3 * point * point, g_size = w2 + radius2_;
    return {value, 0, 0x1p-97 * a2_ * (g_size * g_size + 16 * radius2_ * w2) + 0x1p-700};
  }

 private:
  /// A component of axis x q.
  DoubleDouble cross_part(int i, int j, const Triple<DoubleDouble>& q) const {
    const DoubleDouble &qi = q[static_cast<std::size_t>(i)], &qj = q[static_cast<std::size_t>(j)];
    const TwoTerms a = two_product(axis_[i], qj.high), b = two_product(-axis_[j], qi.high);
    const TwoTerms sum = two_sum(a.high, b.high);
    return {sum.high, (a.low + b.low + sum.low) + std::fma(axis_[i], qj.low, -axis_[j] * qi.low)};
  }

  const Ray<double>& ray_;
  Vec3d axis_;
  Triple<DoubleDouble> from_center_;
  DoubleDouble size2_, difference_, scale_;
  double a2_, radius2_;
};

/// Rounds simple roots correctly by steps of Newton's from the doubles nearby, as far as 100 bits can; false where they
/// cannot. `f` is the polynomial in t - t0.
bool round_roots(const BoundedPolynomial<Arithmetic<DoubleBall>, 4>& f, const WideTorus& wide, double t0,
                 RootList& list) {
  const auto roots = std::span(list.roots).first(static_cast<std::size_t>(list.count));
  double size = 0;  // of t - t0 wherever the steps come to
  for (const Root& root : roots) size = std::max(size, std::fabs(root.t) + 4 * root.radius);
  size += 0x1p-49 * (std::fabs(t0) + size);
  const double unsure = f.slope_bound(size), curvature = 2 * f.half_curvature(size);
  for (Root& root : roots) {
    double start = t0 + root.t, away = 2 * root.radius + 0x1p-51 * std::fabs(start);  // more than start is off by
    const double rounding = 0x1p-51 * (std::fabs(start) + std::fabs(root.t));         // more than start - t0 is
    bool is_rounded = false;
    // Where the polynomial is strongly curved the first step leaves too much, and the second next to nothing.
    for (int step = 0; step < 3 && !is_rounded; ++step) {
      // It ends in the root for a slope somewhere between here and there (mean value theorem).
      const double slope = f.at(start - t0).slope, per_slope = (1 + 0x1p-50) / std::fabs(slope);
      const double slope_off = (unsure + curvature * (away + rounding)) * per_slope;
      if (!(slope_off < 0x1p-4)) return false;
      const BoundedValue<DoubleDouble> at = wide.at(start);
      const double by = -at.value.high / slope;
      const DoubleDouble t(two_sum(start, by));
      const double left = (at.bound * per_slope + std::fabs(by) * (slope_off + 0x1p-50)) * (1 + 0x1p-3);
      const double reach = (std::fabs(t.low) + left) * (1 + 0x1p-40);
      if (!(std::fabs(t.high) > 0x1p-900) || !(reach < away)) return false;
      // What is less than half way to the neighbours is rounded back.
      is_rounded = t.high + reach == t.high && t.high - reach == t.high;
      root.t = start = t.high;
      root.radius = away = reach;
    }
    if (!is_rounded) return false;
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
