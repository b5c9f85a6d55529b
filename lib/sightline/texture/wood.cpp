#include "sightline/texture/wood.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sightline/math/expansion.h"
#include "sightline/texture/waves.h"

namespace sightline {
namespace {

FieldOptions field_of(const WoodOptions& options) {
  validate_texture("wood", options);
  return {.noise = options.noise, .frequency = options.noise_frequency};
}

/// (frequency x)^2 mod 1, up to whole numbers and a few units of 2^-53: small summands of both signs.
double square_fraction(double frequency, double x) {
  const auto [scaled, lost] = two_product(frequency, x);
  const auto [square, rest] = two_product(scaled, scaled);
  const auto [cross, cross_rest] = two_product(2 * scaled, lost);
  const double parts = fraction(square) + (rest - std::floor(rest)) + (cross - std::floor(cross));
  return parts + (cross_rest + lost * lost);
}

}  // namespace

std::span<const TextureField<WoodOptions>> WoodOptions::fields() {
  using O = WoodOptions;
  static constexpr std::array<TextureField<O>, 7> fields{{
      {"texture_frequency", [](O& o) -> TextureSlot { return &o.texture_frequency; }, 0, 0x1p20,
       "scales the point for the rings: their number grows with its square"},
      {"noise_frequency", [](O& o) -> TextureSlot { return &o.noise_frequency; }, 0x1p-20, 0x1p20,
       "scales the point for the noise: bumps around a ring"},
      {"noise_amplitude", [](O& o) -> TextureSlot { return &o.noise_amplitude; }, 0, 0x1p20,
       "rings that noise of 1 moves a point by: how far bumps go"},
      {"early", [](O& o) -> TextureSlot { return &o.early; }, 0, 1, "color where a ring begins"},
      {"late", [](O& o) -> TextureSlot { return &o.late; }, 0, 1, "color where it ends"},
      {"noise", [](O& o) -> TextureSlot { return &o.noise.kind; }, 0, 0, "kind of noise"},
      {"seed", [](O& o) -> TextureSlot { return &o.noise.seed; }, 0, 0, "of the noise"},
  }};
  return fields;
}

Wood::Wood(const WoodOptions& options) : options_(options), noise_(field_of(options)) {}

NoiseSample<double, 3> Wood::ring(const Vec3d& p, double noise, const Vec3d& noise_gradient) const {
  const double f = options_.texture_frequency;
  const double number = square_fraction(f, p.x) + square_fraction(f, p.z) + options_.noise_amplitude * noise;
  return {fraction(number), Vec3d(2 * f * f * p.x, 0, 2 * f * f * p.z) + options_.noise_amplitude * noise_gradient};
}

double Wood::span(const Vec3d& gradient, const Footprint& footprint) const {
  // Along the gradient g, at s within half a footprint, the number changes by g s + (frequency s)^2.
  const double half = footprint.width / 2, slope = is_finite(gradient) ? glm::length(gradient) : 0;
  const double bend = options_.texture_frequency * half;
  const double range =
      slope >= 2 * options_.texture_frequency * bend
          ? slope * footprint.width
          : (slope / (2 * options_.texture_frequency) + bend) * (slope / (2 * options_.texture_frequency) + bend);
  // An interval of width w has the deviation w / sqrt(12).
  const double spread = options_.noise_amplitude * noise_.spread(footprint.width);
  return std::sqrt(range * range + 12 * spread * spread);
}

double Wood::value(const Vec3d& p, const Footprint& footprint) const {
  if (!(footprint.width > 0)) return ring(p, noise_.value(p), Vec3d(0)).value;
  return sample(p, footprint).value;
}

NoiseSample<double, 3> Wood::mean(const Vec3d& p, const NoiseSample<double, 3>& noise,
                                  const Footprint& footprint) const {
  const NoiseSample<double, 3> number = ring(p, noise.value, noise.gradient);
  const WaveMean mean = sawtooth_mean(number.value, span(number.gradient, footprint));
  return {mean.value, mean.slope * number.gradient};
}

NoiseSample<double, 3> Wood::sample(const Vec3d& p, const Footprint& footprint) const {
  const NoiseSample<double, 3> noise = noise_.sample(p, footprint.width);
  return footprint.width > 0 ? mean(p, noise, footprint) : ring(p, noise.value, noise.gradient);
}

void Wood::colors(std::span<const Vec3d> points, std::span<const Footprint> footprints, std::span<Color> colors) const {
  const auto is_wide = [](const Footprint& footprint) { return footprint.width > 0; };
  for (std::size_t first = 0; first < points.size(); first += block_size) {
    const std::size_t count = std::min(block_size, points.size() - first);
    const auto at = points.subspan(first, count);
    const auto around = footprints.subspan(first, count);
    const auto wide = static_cast<std::size_t>(std::count_if(around.begin(), around.end(), is_wide));
    if (wide == 0) {
      std::array<double, block_size> noise;
      noise_.values(at, std::span(noise).first(count));
      for (std::size_t i = 0; i < count; ++i) colors[first + i] = color(ring(at[i], noise[i], Vec3d(0)).value);
    } else if (wide == count) {
      std::array<double, block_size> widths;
      std::array<NoiseSample<double, 3>, block_size> noise;
      for (std::size_t i = 0; i < count; ++i) widths[i] = around[i].width;
      noise_.samples(at, std::span(widths).first(count), std::span(noise).first(count));
      for (std::size_t i = 0; i < count; ++i) colors[first + i] = color(mean(at[i], noise[i], around[i]).value);
    } else {
      for (std::size_t i = 0; i < count; ++i) colors[first + i] = (*this)(at[i], around[i]);
    }
  }
}

}  // namespace sightline
