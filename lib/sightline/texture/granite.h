#pragma once
/// Granite: grains of three minerals.

#include <span>

#include "sightline/texture/color.h"
#include "sightline/texture/footprint.h"
#include "sightline/texture/noise_cover.h"
#include "sightline/texture/texture_options.h"

namespace sightline {

struct GraniteOptions {
  double frequency = 8;   ///< Of the largest grains, per unit of length.
  double feldspar = 0.5;  ///< Its share of what is not mica, from 0 to 1; the rest is quartz.
  double mica = 0.15;     ///< Its share of all, from 0 to 1.
  double contrast = 8;    ///< Between grains: 1 / the width of their edges in deviations of the noise.
  int octaves = 5;
  double gain = 0.7;  ///< From an octave to the next: how ragged grains are.
  Color quartz_color{0.62f, 0.61f, 0.60f};
  Color feldspar_color{0.66f, 0.42f, 0.34f};
  Color mica_color{0.05f, 0.05f, 0.06f};
  NoiseOptions noise{};

  static std::span<const TextureField<GraniteOptions>> fields();
};

/// Feldspar lies in quartz where one noise is high, mica over both where another is. Far away all that is left is their
/// mean color, by their shares, as if the two noises had nothing to do with each other. Price: two sums of octaves.
/// Peachey, "Solid Texturing of Complex Surfaces", 1985; Perlin, "An Image Synthesizer", 1985.
class Granite {
 public:
  using Options = GraniteOptions;

  /// \throws std::invalid_argument naming the option that is out of its range.
  explicit Granite(const GraniteOptions& options = {});

  const GraniteOptions& options() const { return options_; }

  /// How much there is of each mineral; together 1.
  struct Shares {
    double quartz, feldspar, mica;
  };
  Shares shares(const Vec3d& p, const Footprint& footprint = {}) const;

  Color operator()(const Vec3d& p, const Footprint& footprint = {}) const;

 private:
  GraniteOptions options_;
  NoiseCover feldspar_, mica_;
};

}  // namespace sightline
