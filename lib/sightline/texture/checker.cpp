#include "sightline/texture/checker.h"

#include <cmath>

#include "sightline/math/dyadic.h"
#include "sightline/texture/waves.h"

namespace sightline {
namespace {

bool is_odd_whole(double whole) { return whole != 2 * std::floor(whole / 2); }

/// Of floor(a / b).
bool is_odd_quotient(const Dyadic& a, const Dyadic& b) {
  mpz_class dividend = a.mantissa(), divisor = b.mantissa(), quotient;
  const long shift = a.exponent() - b.exponent();
  if (shift >= 0) {
    dividend <<= static_cast<unsigned long>(shift);
  } else {
    divisor <<= static_cast<unsigned long>(-shift);
  }
  mpz_fdiv_q(quotient.get_mpz_t(), dividend.get_mpz_t(), divisor.get_mpz_t());
  return mpz_odd_p(quotient.get_mpz_t()) != 0;
}

}  // namespace

std::span<const TextureField<CheckerOptions>> CheckerOptions::fields() {
  using O = CheckerOptions;
  static constexpr std::array<TextureField<O>, 3> fields{{
      {"size", [](O& o) -> TextureSlot { return &o.size; }, 0x1p-20, 0x1p20, "a cell's edge"},
      {"even", [](O& o) -> TextureSlot { return &o.even; }, 0, 1, "color of the cell at the origin"},
      {"odd", [](O& o) -> TextureSlot { return &o.odd; }, 0, 1, "color of its neighbours"},
  }};
  return fields;
}

Checker::Checker(const CheckerOptions& options) : options_(options) { validate_texture("checker", options); }

Checker::Cell Checker::cell(double x) const {
  const double size = options_.size;
  double whole = std::floor(x / size);
  if (std::fabs(whole) < 0x1p52) {
    // The quotient may have been rounded up to a whole number, never down across one.
    double rest = std::fma(-whole, size, x);
    if (rest < 0) {
      whole -= 1;
      rest = std::fma(-whole, size, x);
    }
    return {is_odd_whole(whole), rest / size};
  }
  if (!std::isfinite(x)) return {false, 0};
  const double rest = std::fmod(x, 2 * size);  // exact, of the sign of x
  if (rest < 0) {
    const bool is_odd = rest >= -size;
    return {is_odd, (rest + (is_odd ? size : 2 * size)) / size};
  }
  const bool is_odd = rest >= size;
  return {is_odd, (is_odd ? rest - size : rest) / size};
}

double Checker::mean(double x, double extent) const {
  const Cell c = cell(x);
  return square_mean(c.is_odd, c.place, extent / options_.size);
}

bool Checker::is_odd_exactly(const AxisPlane& plane, const Vec3d& origin, const Vec3d& direction) const {
  bool is_odd = cell(plane.at).is_odd;  // C1
  const double t = (plane.at - origin[plane.axis]) / direction[plane.axis];
  for (const int axis : {(plane.axis + 1) % 3, (plane.axis + 2) % 3}) {
    const double way = t * direction[axis], x = (origin[axis] + way) / options_.size;
    // Three roundings of the way and two of the sum: at most 5 * 2^-53 of both, and what underflows.
    const double error = 0x1p-50 * ((std::fabs(origin[axis]) + std::fabs(way)) / options_.size) + 0x1p-900;
    if (std::fabs(x - std::nearbyint(x)) > error) {
      is_odd ^= is_odd_whole(std::floor(x));
      continue;
    }
    const Dyadic ahead = Dyadic(plane.at) - Dyadic(origin[plane.axis]), slope(direction[plane.axis]);
    const Dyadic along = Dyadic(origin[axis]) * slope + ahead * Dyadic(direction[axis]);
    is_odd ^= is_odd_quotient(along, slope * Dyadic(options_.size));
  }
  return is_odd;
}

}  // namespace sightline
