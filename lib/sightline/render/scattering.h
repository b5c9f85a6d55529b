#pragma once
/// How surfaces scatter light. Directions are of unit length and point away from the surface; frames have z along the
/// normal.

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

#include "sightline/math/vec.h"
#include "sightline/texture/color.h"

namespace sightline {

/// The share of unpolarized light that is reflected where it meets a smooth surface at cos_in >= 0 from the normal;
/// `eta` is the refractive index beyond over that before. 1 where all is reflected. Fresnel, 1823.
inline double fresnel(double cos_in, double eta) {
  const double sin2_out = (1 - cos_in * cos_in) / (eta * eta);
  if (sin2_out >= 1) return 1;
  const double cos_out = std::sqrt(1 - sin2_out);
  const double across = (cos_in - eta * cos_out) / (cos_in + eta * cos_out);
  const double along = (eta * cos_in - cos_out) / (eta * cos_in + cos_out);
  return (across * across + along * along) / 2;
}

/// That of a metal, by its color at right angles. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering",
/// 1994.
inline Color fresnel_of_metal(const Color& color, double cos_in) {
  const double rest = 1 - cos_in, rest2 = rest * rest;
  return color + static_cast<float>(rest2 * rest2 * rest) * (Color(1) - color);
}

inline Vec3d reflected(const Vec3d& to_viewer, const Vec3d& normal) {
  return 2 * glm::dot(to_viewer, normal) * normal - to_viewer;
}

/// Where light from the viewer goes beyond the surface: Snell's law. `eta` as in fresnel(), which is below 1 there.
inline Vec3d refracted(const Vec3d& to_viewer, const Vec3d& normal, double eta) {
  const double cos_in = glm::dot(to_viewer, normal);
  const double cos_out = std::sqrt(std::max(0.0, 1 - (1 - cos_in * cos_in) / (eta * eta)));
  return (cos_in / eta - cos_out) * normal - to_viewer / eta;
}

/// A direction as likely as its cosine: points of the unit disk, lifted. Shirley and Chiu, "A Low Distortion Map
/// Between Disk and Square", 1997; Malley's method.
inline glm::dvec2 on_disk(const glm::dvec2& square) {
  const double a = 2 * square.x - 1, b = 2 * square.y - 1;
  if (a == 0 && b == 0) return {0, 0};
  constexpr double quarter = std::numbers::pi / 4;
  const bool is_wide = std::fabs(a) > std::fabs(b);
  const double radius = is_wide ? a : b;
  const double angle = is_wide ? quarter * (b / a) : 2 * quarter - quarter * (a / b);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}
inline Vec3d cosine_direction(const glm::dvec2& square) {
  const glm::dvec2 p = on_disk(square);
  return {p.x, p.y, std::sqrt(std::max(0.0, 1 - p.x * p.x - p.y * p.y))};
}

/// Microfacets whose slopes are distributed after Trowbridge and Reitz (GGX), of width alpha > 0, with Smith's masking.
/// Walter, Marschner, Li and Torrance, "Microfacet Models for Refraction through Rough Surfaces", 2007; Heitz,
/// "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", 2014.
class Microfacets {
 public:
  explicit Microfacets(double roughness) : alpha2_(square(square(roughness))) {}

  /// The density of facets by their normals.
  double density(double cos_facet) const {
    const double c2 = cos_facet * cos_facet, d = c2 * (alpha2_ - 1) + 1;
    return alpha2_ / (std::numbers::pi * d * d);
  }
  /// The share of facets that a direction sees, and that both see.
  double seen(double cosine) const { return 1 / (1 + smith(cosine)); }
  double seen_by_both(double cos_a, double cos_b) const { return 1 / (1 + smith(cos_a) + smith(cos_b)); }

  /// A facet's normal, as likely as it is seen from `view`. Heitz, "Sampling the GGX Distribution of Visible Normals",
  /// 2018.
  Vec3d visible_facet(const Vec3d& view, const glm::dvec2& square_sample) const {
    const double alpha = std::sqrt(alpha2_);
    const Vec3d stretched = glm::normalize(Vec3d(alpha * view.x, alpha * view.y, view.z));
    const double across2 = stretched.x * stretched.x + stretched.y * stretched.y;
    const Vec3d x = across2 > 0 ? Vec3d(-stretched.y, stretched.x, 0) / std::sqrt(across2) : Vec3d(1, 0, 0);
    const Vec3d y = glm::cross(stretched, x);
    const double radius = std::sqrt(square_sample.x), angle = 2 * std::numbers::pi * square_sample.y;
    const double a = radius * std::cos(angle), s = (1 + stretched.z) / 2;
    const double b = (1 - s) * std::sqrt(1 - a * a) + s * radius * std::sin(angle);
    const Vec3d normal = a * x + b * y + std::sqrt(std::max(0.0, 1 - a * a - b * b)) * stretched;
    return glm::normalize(Vec3d(alpha * normal.x, alpha * normal.y, std::max(0.0, normal.z)));
  }

  /// Of directions that are reflected by visible facets, of solid angle.
  double density_of_reflected(double cos_view, double cos_facet) const {
    return density(cos_facet) * seen(cos_view) / (4 * cos_view);
  }

 private:
  static constexpr double square(double x) { return x * x; }
  double smith(double cosine) const {
    const double c2 = cosine * cosine;
    return (std::sqrt(1 + alpha2_ * (1 - c2) / c2) - 1) / 2;
  }

  double alpha2_;
};

}  // namespace sightline
