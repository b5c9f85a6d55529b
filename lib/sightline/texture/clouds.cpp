#include "sightline/texture/clouds.h"

#include <array>

namespace sightline {
namespace {

NoiseCover cover_of(const CloudsOptions& options) {
  validate_texture("clouds", options);
  return NoiseCover({.noise = options.noise,
                     .fractal = FractalKind::fbm,
                     .octaves = options.octaves,
                     .gain = options.gain,
                     .frequency = options.frequency,
                     .warp = options.warp},
                    options.coverage, 1 / options.sharpness);
}

}  // namespace

std::span<const TextureField<CloudsOptions>> CloudsOptions::fields() {
  using O = CloudsOptions;
  static constexpr std::array<TextureField<O>, 10> fields{{
      {"frequency", [](O& o) -> TextureSlot { return &o.frequency; }, 0x1p-20, 0x1p20,
       "of the largest clouds, per unit of length"},
      {"coverage", [](O& o) -> TextureSlot { return &o.coverage; }, 0, 1, "how much of the sky they cover"},
      {"sharpness", [](O& o) -> TextureSlot { return &o.sharpness; }, 0.125, 0x1p20, "of their edges"},
      {"octaves", [](O& o) -> TextureSlot { return &o.octaves; }, 1, 32, "of the noise"},
      {"gain", [](O& o) -> TextureSlot { return &o.gain; }, 0x1p-10, 1, "from an octave to the next: how ragged"},
      {"warp", [](O& o) -> TextureSlot { return &o.warp; }, 0, 1024, "cells that they are bent by"},
      {"sky", [](O& o) -> TextureSlot { return &o.sky; }, 0, 1, "color between clouds"},
      {"cloud", [](O& o) -> TextureSlot { return &o.cloud; }, 0, 1, "color of clouds"},
      {"noise", [](O& o) -> TextureSlot { return &o.noise.kind; }, 0, 0, "kind of noise"},
      {"seed", [](O& o) -> TextureSlot { return &o.noise.seed; }, 0, 0, "of the noise"},
  }};
  return fields;
}

Clouds::Clouds(const CloudsOptions& options) : options_(options), cover_(cover_of(options)) {}

}  // namespace sightline
