#include "sightline/texture/marble.h"

#include <array>
#include <cmath>

#include "sightline/math/expansion.h"
#include "sightline/texture/waves.h"

namespace sightline {
namespace {

FieldOptions field_of(const MarbleOptions& options) {
  validate_texture("marble", options);
  return {.noise = options.noise,
          .fractal = FractalKind::turbulence,
          .octaves = options.octaves,
          .frequency = options.noise_frequency};
}

}  // namespace

std::span<const TextureField<MarbleOptions>> MarbleOptions::fields() {
  using O = MarbleOptions;
  static constexpr std::array<TextureField<O>, 11> fields{{
      {"wave", [](O& o) -> TextureSlot { return &o.wave; }, 0, 0, "how a layer goes over into the next"},
      {"axis", [](O& o) -> TextureSlot { return &o.axis; }, 0, 2, "which layers lie across: 0 x, 1 y, 2 z"},
      {"layers", [](O& o) -> TextureSlot { return &o.layers; }, 0, 0x1p20, "per unit of length"},
      {"sharpness", [](O& o) -> TextureSlot { return &o.sharpness; }, 1, 1024, "of creases: how thin veins are"},
      {"turbulence", [](O& o) -> TextureSlot { return &o.turbulence; }, 0, 0x1p20,
       "layers that turbulence of 1 moves a point by"},
      {"noise_frequency", [](O& o) -> TextureSlot { return &o.noise_frequency; }, 0x1p-20, 0x1p20,
       "scales the point for the turbulence"},
      {"octaves", [](O& o) -> TextureSlot { return &o.octaves; }, 1, 32, "of the turbulence"},
      {"stone", [](O& o) -> TextureSlot { return &o.stone; }, 0, 1, "color where the wave is 0"},
      {"vein", [](O& o) -> TextureSlot { return &o.vein; }, 0, 1, "color where it is 1"},
      {"noise", [](O& o) -> TextureSlot { return &o.noise.kind; }, 0, 0, "kind of noise"},
      {"seed", [](O& o) -> TextureSlot { return &o.noise.seed; }, 0, 0, "of the noise"},
  }};
  return fields;
}

Marble::Marble(const MarbleOptions& options) : options_(options), turbulence_(field_of(options)) {}

double Marble::phase(const Vec3d& p, double turbulence) const {
  // Without the product's rounding, so that layers stay even far away.
  const auto [layer, rest] = two_product(options_.layers, p[options_.axis]);
  return fraction(fraction(layer) + (rest + options_.turbulence * turbulence));
}

double Marble::value(const Vec3d& p, const Footprint& footprint) const {
  if (footprint.width > 0) return sample(p, footprint).value;
  return wave_mean(options_.wave, phase(p, turbulence_.value(p)), 0, options_.sharpness).value;
}

NoiseSample<double, 3> Marble::sample(const Vec3d& p, const Footprint& footprint) const {
  const NoiseSample<double, 3> noise = turbulence_.sample(p, footprint.width);
  Vec3d gradient = options_.turbulence * noise.gradient;
  gradient[options_.axis] += options_.layers;
  double span = 0;
  if (footprint.width > 0) {
    const double range = is_finite(gradient) ? glm::length(gradient) * footprint.width : 0;
    const double spread = options_.turbulence * turbulence_.spread(footprint.width);
    span = std::sqrt(range * range + 12 * spread * spread);  // width w has the deviation w / sqrt(12)
  }
  const WaveMean mean = wave_mean(options_.wave, phase(p, noise.value), span, options_.sharpness);
  return {mean.value, mean.slope * gradient};
}

}  // namespace sightline
