#pragma once
/// Clouds: noise of many octaves over a threshold.

#include <span>

#include "sightline/texture/color.h"
#include "sightline/texture/footprint.h"
#include "sightline/texture/noise_cover.h"
#include "sightline/texture/texture_options.h"

namespace sightline {

struct CloudsOptions {
  double frequency = 1;    ///< Of the largest clouds, per unit of length.
  double coverage = 0.5;   ///< How much of the sky they cover, from 0 to 1.
  double sharpness = 1.5;  ///< Of their edges: 1 / their width in deviations of the noise.
  int octaves = 7;
  double gain = 0.55;  ///< From an octave to the next: how ragged they are.
  double warp = 0.3;   ///< How many cells they are bent by.
  Color sky{0.16f, 0.36f, 0.75f};
  Color cloud{0.95f, 0.95f, 0.96f};
  NoiseOptions noise{};

  static std::span<const TextureField<CloudsOptions>> fields();
};

/// color = sky + cover(P) (cloud - sky), and that in the mean where a footprint is given: the sky's mean color is the
/// same from afar. Price: a complementary error function, some 20 ns beside the octaves.
/// Gardner, "Visual Simulation of Clouds", 1985; Musgrave, in Ebert et al., "Texturing and Modeling", 1994.
class Clouds {
 public:
  using Options = CloudsOptions;

  /// \throws std::invalid_argument naming the option that is out of its range.
  explicit Clouds(const CloudsOptions& options = {});

  const CloudsOptions& options() const { return options_; }

  /// The share of cloud.
  double value(const Vec3d& p, const Footprint& footprint = {}) const { return cover_.value(p, footprint.width); }

  Color operator()(const Vec3d& p, const Footprint& footprint = {}) const {
    return mix(options_.sky, options_.cloud, value(p, footprint));
  }

 private:
  CloudsOptions options_;
  NoiseCover cover_;
};

}  // namespace sightline
