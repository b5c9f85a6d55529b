#include "sightline/texture/granite.h"

#include <array>

#include "sightline/math/random.h"

namespace sightline {
namespace {

NoiseCover cover_of(const GraniteOptions& options, double share, std::uint64_t which) {
  validate_texture("granite", options);
  FieldOptions field{.noise = options.noise,
                     .fractal = FractalKind::fbm,
                     .octaves = options.octaves,
                     .gain = options.gain,
                     .frequency = options.frequency};
  field.noise.seed = Random::hash(options.noise.seed ^ Random::hash(which));
  return NoiseCover(field, share, 1 / options.contrast);
}

}  // namespace

std::span<const TextureField<GraniteOptions>> GraniteOptions::fields() {
  using O = GraniteOptions;
  static constexpr std::array<TextureField<O>, 11> fields{{
      {"frequency", [](O& o) -> TextureSlot { return &o.frequency; }, 0x1p-20, 0x1p20,
       "of the largest grains, per unit of length"},
      {"feldspar", [](O& o) -> TextureSlot { return &o.feldspar; }, 0, 1, "its share of what is not mica"},
      {"mica", [](O& o) -> TextureSlot { return &o.mica; }, 0, 1, "its share of all"},
      {"contrast", [](O& o) -> TextureSlot { return &o.contrast; }, 0.125, 0x1p20, "between grains"},
      {"octaves", [](O& o) -> TextureSlot { return &o.octaves; }, 1, 32, "of the noise"},
      {"gain", [](O& o) -> TextureSlot { return &o.gain; }, 0x1p-10, 1, "from an octave to the next: how ragged"},
      {"quartz_color", [](O& o) -> TextureSlot { return &o.quartz_color; }, 0, 1, "of quartz"},
      {"feldspar_color", [](O& o) -> TextureSlot { return &o.feldspar_color; }, 0, 1, "of feldspar"},
      {"mica_color", [](O& o) -> TextureSlot { return &o.mica_color; }, 0, 1, "of mica"},
      {"noise", [](O& o) -> TextureSlot { return &o.noise.kind; }, 0, 0, "kind of noise"},
      {"seed", [](O& o) -> TextureSlot { return &o.noise.seed; }, 0, 0, "of the noise"},
  }};
  return fields;
}

Granite::Granite(const GraniteOptions& options)
    : options_(options), feldspar_(cover_of(options, options.feldspar, 1)), mica_(cover_of(options, options.mica, 2)) {}

Granite::Shares Granite::shares(const Vec3d& p, const Footprint& footprint) const {
  const double mica = mica_.value(p, footprint.width), feldspar = feldspar_.value(p, footprint.width);
  return {(1 - mica) * (1 - feldspar), (1 - mica) * feldspar, mica};
}

Color Granite::operator()(const Vec3d& p, const Footprint& footprint) const {
  const Shares s = shares(p, footprint);
  return static_cast<float>(s.quartz) * options_.quartz_color +
         static_cast<float>(s.feldspar) * options_.feldspar_color + static_cast<float>(s.mica) * options_.mica_color;
}

}  // namespace sightline
