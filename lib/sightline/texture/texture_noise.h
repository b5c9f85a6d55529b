#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "sightline/math/vec.h"
#include "sightline/noise/noise_field.h"

namespace sightline {

/// Noise that knows how far what a footprint takes away would have spread. Textures bend noise: by a step, by a wave;
/// and the mean of what is bent is not what is bent of the mean. So a texture widens its steps by the spread, as if
/// the octaves that are lost were normally distributed around their mean.
/// Heidrich, Slusallek and Seidel, "Sampling Procedural Shaders Using Affine Arithmetic", 1998; Dorn, Barnes, Lawrence
/// and Weimer, "Towards Automatic Band-Limited Procedural Shaders", 2015.
class TextureNoise {
 public:
  /// \throws std::invalid_argument as NoiseField does.
  explicit TextureNoise(const FieldOptions& options);

  double value(const Vec3d& p, double footprint = 0) const { return field_(p, footprint); }
  NoiseSample<double, 3> sample(const Vec3d& p, double footprint = 0) const { return field_.sample(p, footprint); }
  /// At many points, each with its footprint; equal to single ones to the last bit.
  void values(std::span<const Vec3d> points, std::span<double> values) const {
    field_.values<3, double>(points, values);
  }
  void samples(std::span<const Vec3d> points, std::span<const double> footprints,
               std::span<NoiseSample<double, 3>> samples) const {
    field_.samples<3, double>(points, footprints, samples);
  }

  /// Over all of space: the mean, and the standard deviation around it.
  double mean() const { return mean_; }
  double deviation() const { return octave_deviation_ * whole_amplitude_; }
  /// The standard deviation of what a footprint takes away: 0 for none, up to deviation().
  double spread(double footprint) const {
    return footprint > 0 ? octave_deviation_ * field_.lost_amplitude(footprint) : 0;
  }

 private:
  NoiseField field_;
  double mean_;
  double octave_deviation_;  ///< Of one octave of amplitude 1, measured: to some 1%.
  double whole_amplitude_;
};

/// The share of a normal distribution that is above `threshold`, but for a deviation of 0 a step: 1 where the mean is
/// above or on it.
double share_above(double threshold, double mean, double deviation);

/// The threshold that a share of the normal distribution of mean 0 and deviation 1 is above: infinite for 0 and 1.
double threshold_for(double share);

}  // namespace sightline
