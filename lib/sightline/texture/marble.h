#pragma once
/// Marble: layers across an axis, stirred by turbulence.

#include <span>

#include "sightline/texture/color.h"
#include "sightline/texture/footprint.h"
#include "sightline/texture/texture_noise.h"
#include "sightline/texture/texture_options.h"

namespace sightline {

struct MarbleOptions {
  Wave wave = Wave::crease;  ///< How a layer goes over into the next.
  int axis = 0;              ///< Which layers lie across: 0 x, 1 y, 2 z.
  double layers = 1;         ///< Per unit of length.
  double sharpness = 6;      ///< Of creases: how thin veins are.
  double turbulence = 1.5;   ///< How many layers turbulence of 1 moves a point by.
  double noise_frequency = 1;
  int octaves = 6;
  Color stone{0.88f, 0.87f, 0.84f};
  Color vein{0.19f, 0.20f, 0.23f};
  NoiseOptions noise{};

  static std::span<const TextureField<MarbleOptions>> fields();
};

/// color = stone + wave(layers P[axis] + turbulence(P)) (vein - stone). A footprint gets the wave's mean over the
/// layers it spans, in closed form, as of wood; price: the turbulence's gradient. Perlin, "An Image Synthesizer", 1985.
class Marble {
 public:
  using Options = MarbleOptions;

  /// \throws std::invalid_argument naming the option that is out of its range.
  explicit Marble(const MarbleOptions& options = {});

  const MarbleOptions& options() const { return options_; }

  /// The share of vein. Its derivative is exact but where waves or turbulence crease.
  NoiseSample<double, 3> sample(const Vec3d& p, const Footprint& footprint = {}) const;
  double value(const Vec3d& p, const Footprint& footprint = {}) const;

  Color operator()(const Vec3d& p, const Footprint& footprint = {}) const {
    return mix(options_.stone, options_.vein, value(p, footprint));
  }

 private:
  double phase(const Vec3d& p, double turbulence) const;

  MarbleOptions options_;
  TextureNoise turbulence_;
};

}  // namespace sightline
