#include "viz/color_ramp.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace sightline::viz {
namespace {

/// Ottosson, "A perceptual color space for image processing" (Oklab), 2020: lightness, chroma and hue in degrees to
/// linear red, green and blue.
Rgb linear_from_oklch(double lightness, double chroma, double hue) {
  const double a = chroma * std::cos(hue * std::numbers::pi / 180), b = chroma * std::sin(hue * std::numbers::pi / 180);
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

}  // namespace

double linear_from_srgb(double component) {
  const double x = std::clamp(component, 0.0, 1.0);
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

double srgb_from_linear(double light) {
  const double x = std::clamp(light, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

Rgb ramp(double share, double darkest, double lightest) {
  share = share > 0 ? std::min(share, 1.0) : 0;
  const double lightness = darkest + (lightest - darkest) * share;
  const double hue = 305 - (lightest > 0.8 ? 200 : 235) * share;
  // Screens hold little chroma where it is dark or light, and in cyan: as much as fits.
  double chroma = 0.15;
  const auto is_on_screen = [&](const Rgb& color) {
    return std::all_of(color.begin(), color.end(), [](double x) { return x >= 0 && x <= 1; });
  };
  Rgb color = linear_from_oklch(lightness, chroma, hue);
  while (chroma > 0 && !is_on_screen(color)) color = linear_from_oklch(lightness, chroma -= 0.005, hue);
  for (double& component : color) component = srgb_from_linear(component);
  return color;
}

Rgb diverging(double x) {
  if (std::isnan(x)) return {0.5, 0.5, 0.5};
  const double share = std::min(std::fabs(x), 1.0);
  Rgb color = linear_from_oklch(0.97 - 0.42 * share, 0.13 * std::min(1.0, 1.4 * share), x < 0 ? 250 : 50);
  for (double& component : color) component = srgb_from_linear(component);
  return color;
}

std::array<char, 8> css_color(const Rgb& color) {
  std::array<char, 8> text{};
  const auto byte = [](double x) { return static_cast<unsigned>(std::lround(std::clamp(x, 0.0, 1.0) * 255)) & 255U; };
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(color[0]), byte(color[1]), byte(color[2]));
  return text;
}

}  // namespace sightline::viz
