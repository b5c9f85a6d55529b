#pragma once
/// Wood as the course builds it: rings around the y axis, moved by noise.

#include <span>

#include "sightline/noise/noise_options.h"
#include "sightline/texture/color.h"
#include "sightline/texture/footprint.h"
#include "sightline/texture/texture_noise.h"
#include "sightline/texture/texture_options.h"

namespace sightline {

struct WoodOptions {
  double texture_frequency = 1;  ///< Scales P for the rings: at distance d from the axis lies ring (frequency d)^2.
  double noise_frequency = 1;    ///< Scales P for the noise: how many bumps a ring has.
  double noise_amplitude = 1;    ///< How many rings noise of 1 moves a point by: how far bumps go.
  Color early{0.70f, 0.42f, 0.17f};
  Color late{0.26f, 0.11f, 0.035f};
  NoiseOptions noise{};

  static std::span<const TextureField<WoodOptions>> fields();
};

/// f(P) = ((texture_frequency X)^2 + (texture_frequency Z)^2 + noise_amplitude noise(noise_frequency P)) mod 1, and the
/// color early + f (late - early).
///
///   - The squares are kept with their rounding errors, so that a ring is where it belongs to some 2^-49 of its width
///     up to 2^52 from the axis, and not to 2^-53 of its number. Price: three fused products an axis, little
///     beside noise. Where a square overflows, f is NaN.
///   - Rings thinner than the footprint fade to their mean: f is the sawtooth's mean over the rings that a footprint
///     spans, in closed form. These count as evenly spread, which is right to first order. Price: the noise's gradient,
///     about as much again as its value.
///   - Noise too fine for the footprint gives way as NoiseField's does, and what it would have moved rings by is added
///     to what the footprint spans.
class Wood {
 public:
  using Options = WoodOptions;

  /// \throws std::invalid_argument naming the option that is out of its range.
  explicit Wood(const WoodOptions& options = {});

  const WoodOptions& options() const { return options_; }

  /// f: 0 is early wood, 1 late.
  double value(const Vec3d& p, const Footprint& footprint = {}) const;

  /// f with its derivative: exact within a ring, as if rings did not end; in a footprint that of the mean, with as wide
  /// a span at the points around.
  NoiseSample<double, 3> sample(const Vec3d& p, const Footprint& footprint = {}) const;

  Color operator()(const Vec3d& p, const Footprint& footprint = {}) const { return color(value(p, footprint)); }
  /// At as many points as there are footprints and colors; equal to single ones to the last bit.
  void colors(std::span<const Vec3d> points, std::span<const Footprint> footprints, std::span<Color> colors) const;

 private:
  static constexpr std::size_t block_size = 64;

  Color color(double f) const { return options_.early + static_cast<float>(f) * (options_.late - options_.early); }
  /// Of a footprint with a width.
  NoiseSample<double, 3> mean(const Vec3d& p, const NoiseSample<double, 3>& noise, const Footprint& footprint) const;
  /// Where a point is among the rings: its number mod 1, and its derivative.
  NoiseSample<double, 3> ring(const Vec3d& p, double noise, const Vec3d& noise_gradient) const;
  /// How many rings a footprint spans.
  double span(const Vec3d& gradient, const Footprint& footprint) const;

  WoodOptions options_;
  TextureNoise noise_;
};

}  // namespace sightline
