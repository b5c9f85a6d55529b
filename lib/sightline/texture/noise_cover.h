#pragma once

#include <cmath>

#include "sightline/texture/texture_noise.h"

namespace sightline {

/// Patches where noise is high, which cover a given share of space: as clouds do the sky, or grains a stone.
///
/// The threshold is where a normal distribution has that share above it; sums of octaves are close to one. The edge of
/// a patch is one as well, so that what a footprint takes from the noise only widens it, and the mean stays the share.
class NoiseCover {
 public:
  /// `softness` is an edge's deviation in units of the noise's; 0 makes edges sharp.
  /// \throws std::invalid_argument as NoiseField does.
  NoiseCover(const FieldOptions& options, double share, double softness)
      : noise_(options),
        softness_(softness * noise_.deviation()),
        threshold_(noise_.mean() + threshold_for(share) * std::hypot(noise_.deviation(), softness_)) {}

  /// From 0 for bare to 1 for covered.
  double value(const Vec3d& p, double footprint = 0) const {
    return share_above(threshold_, noise_.value(p, footprint), std::hypot(softness_, noise_.spread(footprint)));
  }

 private:
  TextureNoise noise_;
  double softness_, threshold_;
};

}  // namespace sightline
