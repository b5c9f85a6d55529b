#include "sightline/shape/facet_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sightline/math/dyadic.h"

namespace sightline {
namespace {

template <class M>
Sign known_sign(const Ball<M>& x) {
  return sign_of(x);
}
Sign known_sign(const Dyadic& x) { return {x.sign(), true}; }

/// The sign of value.operator()<N>() with the first numbers N that are certain of it.
template <class Value>
int sign_in_any(const Value& value) {
  if (const Sign sign = known_sign(value.template operator()<DoubleBall>()); sign.is_certain) return sign.value;
  if (const Sign sign = known_sign(value.template operator()<WideBall>()); sign.is_certain) return sign.value;
  return known_sign(value.template operator()<Dyadic>()).value;
}

std::size_t index(int axis) { return static_cast<std::size_t>(axis); }

}  // namespace

FacetLine::FacetLine(const FramedRay& ray, const Vec3d& lo, const Vec3d& hi)
    : ray_(ray), error_(std::numeric_limits<double>::infinity()) {
  const auto line = ray.in<DoubleBall>();
  const auto& d = line.direction;
  z_axis_ = largest_axis(Vec3d(std::fabs(d[0].mid), std::fabs(d[1].mid), std::fabs(d[2].mid)));
  Sign sign = sign_of(d[index(z_axis_)]);
  if (!sign.is_certain || sign.value == 0) {
    const auto exact = ray.in<Dyadic>();
    for (z_axis_ = 2; z_axis_ > 0 && exact.direction[index(z_axis_)].sign() == 0;) --z_axis_;
    sign = {exact.direction[index(z_axis_)].sign(), false};
  }
  facing_ = sign.value;
  x_axis_ = (z_axis_ + 1) % 3;
  y_axis_ = (z_axis_ + 2) % 3;
  if (!sign.is_certain) return;

  const DoubleBall shear_x = d[index(x_axis_)] / d[index(z_axis_)], shear_y = d[index(y_axis_)] / d[index(z_axis_)];
  double aside = 0, away = 0;
  for (int axis = 0; axis < 3; ++axis) {
    origin_[axis] = line.origin[index(axis)].mid;
    aside = std::max(aside, line.origin[index(axis)].radius);
    away = std::max({away, std::fabs(lo[axis] - origin_[axis]), std::fabs(hi[axis] - origin_[axis])});
  }
  away *= 1 + 0x1p-50;
  if (!(away < 0x1p+500)) return;  // so that no product of two coordinates overflows
  // With u = 2^-53 and shears of at most 1 + u: z is off by u away + aside, its product with the shear by
  // 2 u away + aside + (away + aside) radius, x by 5 u away + 2 aside + (away + aside) radius, but for terms in u^2.
  const double radius = std::max(shear_x.radius, shear_y.radius);
  const double error = 0x1p-50 * away + 3 * aside + 2 * (away + aside) * radius;
  constexpr double underflow = 0x1p-1060;
  if (!std::isfinite(error)) return;
  error_ = error + underflow;
  shear_x_ = shear_x.mid;
  shear_y_ = shear_y.mid;
}

FacetLine::Verdict FacetLine::look(const solid::Facet& facet, Signs& signs) const {
  const auto& [a, b, c] = facet.vertices;
  const Seen sa = see(a), sb = see(b), sc = see(c);
  if (std::min({sa.x, sb.x, sc.x}) > error_ || std::max({sa.x, sb.x, sc.x}) < -error_ ||
      std::min({sa.y, sb.y, sc.y}) > error_ || std::max({sa.y, sb.y, sc.y}) < -error_) {
    return Verdict::outside;
  }
  const double size =
      std::max({std::fabs(sa.x), std::fabs(sb.x), std::fabs(sc.x), std::fabs(sa.y), std::fabs(sb.y), std::fabs(sc.y)});
  // Factors that are off by `error` make each of two products off by 2 size error + error^2; rounding adds
  // 4 u size^2 <= 2 size error. A product that underflows is off by 2^-1075.
  const double bound = 8 * error_ * (size + error_) + 0x1p-1060;
  const auto sign = [&](const Seen& p, const Seen& q) {
    const double value = p.x * q.y - p.y * q.x;
    return (value > bound) - (value < -bound);
  };
  signs = {{sign(sa, sb), sign(sb, sc), sign(sc, sa)}};
  const auto [least, most] = std::minmax({signs.of[0], signs.of[1], signs.of[2]});
  if (least < 0 && most > 0) return Verdict::outside;
  return least == most && least != 0 ? Verdict::all_alike : Verdict::unknown;
}

int FacetLine::edge_sign(const Vec3d& a, const Vec3d& b) const {
  return sign_in_any([&]<class N>() {
    const Line<N> line = ray_.in<N>();
    return dot(line.direction, cross(difference(triple<N>(a), line.origin), difference(triple<N>(b), line.origin)));
  });
}

/// With the origin moved by e x + e^2 y the edge function grows by (e x + e^2 y) . ((a - b) x direction): the first
/// coefficient that is not zero decides. All are zero only where the edge is parallel to the line.
int FacetLine::moved_edge_sign(const Vec3d& a, const Vec3d& b) const {
  if (const int sign = edge_sign(a, b); sign != 0) return sign;
  for (const int axis : {x_axis_, y_axis_}) {
    const int sign = sign_in_any([&]<class N>() {
      const int next = (axis + 1) % 3, last = (axis + 2) % 3;
      const auto d = ray_.in<N>().direction;
      return (N(a[next]) - N(b[next])) * d[index(last)] - (N(a[last]) - N(b[last])) * d[index(next)];
    });
    if (sign != 0) return sign;
  }
  return 0;
}

int FacetLine::passage(const solid::Facet& facet) const {
  Signs signs{};
  const Verdict verdict = look(facet, signs);
  if (verdict == Verdict::all_alike) return signs.of[0] * facing_;
  if (verdict == Verdict::outside || facing_ == 0) return 0;
  int way = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    int sign = signs.of[i] * facing_;
    if (sign == 0) sign = moved_edge_sign(facet.vertices[i], facet.vertices[(i + 1) % 3]);
    if (sign == 0 || sign == -way) return 0;
    way = sign;
  }
  return way;
}

bool FacetLine::crosses(const solid::Facet& facet) const {
  Signs signs{};
  const Verdict verdict = look(facet, signs);
  if (verdict != Verdict::unknown) return verdict == Verdict::all_alike;
  int way = 0;  // stays 0 where all edge functions are, that is, where the triangle is seen edge-on (E2)
  for (std::size_t i = 0; i < 3; ++i) {
    int sign = signs.of[i] * facing_;
    if (sign == 0) sign = edge_sign(facet.vertices[i], facet.vertices[(i + 1) % 3]);
    if (sign == 0) continue;
    if (sign == -way) return false;
    way = sign;
  }
  return way != 0;
}

}  // namespace sightline
