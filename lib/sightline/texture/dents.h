#pragma once

#include "sightline/noise/noise_field.h"
#include "sightline/texture/normal_map.h"

namespace sightline {

/// Noise taken for heights of a surface.
struct DentOptions {
  double height = 0.1;      ///< Of noise 1, in units of length along the normal; below 0 it goes inward.
  FieldOptions field = {};  ///< Where its frequency is high beside 1 / height, dents are as steep as walls.
};

/// Dents by noise: the surface stays where it is, its normal is that of one moved by noise. Perlin, "An Image
/// Synthesizer", 1985; Blinn, "Simulation of Wrinkled Surfaces", 1978. Price: the derivative of one noise field.
class Dents {
 public:
  /// \throws std::invalid_argument naming the option of the field that is out of its range.
  explicit Dents(const DentOptions& options) : height_(options.height), field_(options.field) {}

  /// The unit normal at p in place of n. Where a footprint, the width of what is seen, makes octaves too fine, they
  /// give way to no dents.
  Vec3d normal(const Vec3d& n, const Vec3d& p, double footprint = 0) const {
    return dented_normal(n, field_.sample<3, double>(p, footprint).gradient, height_);
  }

 private:
  double height_;
  NoiseField field_;
};

}  // namespace sightline
