#include "sightline/csg/settle.h"

#include <algorithm>
#include <optional>
#include <variant>

#include "sightline/csg/form_roots.h"
#include "sightline/math/algebraic_root.h"
#include "sightline/math/rounding.h"

namespace sightline {
namespace {

ExactPolynomial polynomial_of(const solid::LinearForm<Dyadic>& form) { return {form.level, form.slope}; }
ExactPolynomial polynomial_of(const solid::QuadraticForm<Dyadic>& form) { return {form.c, form.b + form.b, form.a}; }
ExactPolynomial polynomial_of(const solid::QuarticForm<Dyadic>& form) {
  return {form.coefficients.begin(), form.coefficients.end()};
}

ExactPolynomial polynomial_of(const Surface& surface, const FramedRay& ray) {
  const Line<Dyadic> line = ray.in<Dyadic>();
  return std::visit([&](const auto& s) { return polynomial_of(solid::form_of(s, line)); }, surface);
}

/// Far below all roots; of a constant, whether it is not positive.
bool begins_negative(const ExactPolynomial& polynomial) {
  for (std::size_t degree = polynomial.size(); degree-- > 0;) {
    const int sign = polynomial[degree].sign();
    if (sign != 0) return degree % 2 == 0 ? sign < 0 : sign > 0;
  }
  return true;
}

/// Off from what it was rounded from by at most this.
double rounding_of(double t) { return 0.5 * (next_up(std::fabs(t)) - std::fabs(t)); }

RootList exact_roots(const Surface& surface, const FramedRay& ray) {
  const ExactPolynomial polynomial = polynomial_of(surface, ray);
  RootList list;
  list.begins_negative = begins_negative(polynomial);
  for (const AlgebraicRoot& root : real_roots(polynomial)) {
    const double t = root.nearest();
    list.add({t, root.compare(t) == 0 ? 0 : rounding_of(t), root.multiplicity()});
  }
  return list;
}

/// By some hundred bits.
std::optional<RootList> wide_roots(const Surface& surface, const FramedRay& ray) {
  const Line<WideBall> line = ray.in<WideBall>();
  const RootList list = std::visit([&](const auto& s) { return roots_of(solid::form_of(s, line)); }, surface);
  return list.is_certain ? std::optional(list) : std::nullopt;
}

/// Whether what is known of a root leaves one nearest double.
bool is_rounded(const Root& root) {
  const double size = std::fabs(root.t);
  return root.radius == 0 || root.radius < 0.5 * (size - next_down(size));
}
bool are_rounded(const RootList& list) {
  return std::all_of(list.roots.begin(), list.roots.begin() + list.count, is_rounded);
}

AlgebraicRoot algebraic(const SurfaceRoot& a) {
  return real_roots(polynomial_of(a.surface, a.ray))[static_cast<std::size_t>(a.root)];
}

/// Where two enclosures are apart.
int order_of(const Root& a, const Root& b) {
  const double reach = (a.radius + b.radius) * (1 + 0x1p-50);
  return a.t + reach < b.t ? -1 : b.t + reach < a.t ? 1 : 0;
}

}  // namespace

RootList certain_roots(const Torus& torus, const FramedRay& ray) {
  if (ray.frame()) return settled_roots(torus, ray, Level::watertight);
  const RootList list = torus_roots(torus, ray.ray(), Level::precise);
  return list.is_certain ? list : exact_roots(torus, ray);
}

RootList accurate_roots(const Torus& torus, const FramedRay& ray, Level level) {
  if (ray.frame()) return settled_roots(torus, ray, level);
  if (level != Level::exact) {
    const RootList list = torus_roots(torus, ray.ray(), Level::precise);
    if (is_accurate(list, level)) return list;
  }
  return torus_roots(torus, ray.ray(), Level::exact);
}

RootList settled_roots(const Surface& surface, const FramedRay& ray, Level level) {
  const auto wide = wide_roots(surface, ray);
  if (wide && (level == Level::exact ? are_rounded(*wide) : is_accurate(*wide, level))) return *wide;
  return exact_roots(surface, ray);
}

Root settled_root(const Surface& surface, const FramedRay& ray, Level level, std::uint32_t index) {
  if (const auto wide = wide_roots(surface, ray)) {
    const Root& root = wide->roots[index];
    if (level == Level::exact ? is_rounded(root) : is_accurate(root.t, root.radius, level)) return root;
  }
  return exact_roots(surface, ray).roots[index];
}

int settled_order(const SurfaceRoot& a, const SurfaceRoot& b) {
  if (const auto a_list = wide_roots(a.surface, a.ray), b_list = wide_roots(b.surface, b.ray); a_list && b_list) {
    const int order =
        order_of(a_list->roots[static_cast<std::size_t>(a.root)], b_list->roots[static_cast<std::size_t>(b.root)]);
    if (order != 0) return order;
  }
  return AlgebraicRoot::compare(algebraic(a), algebraic(b));
}

int settled_order(const SurfaceRoot& a, double t) { return algebraic(a).compare(t); }

double nearest_root(const SurfaceRoot& root) { return algebraic(root).nearest(); }

}  // namespace sightline
