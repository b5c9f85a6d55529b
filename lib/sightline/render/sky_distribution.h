#pragma once
/// Directions to an image of the sky, as likely as light comes from there.
///   D1  Densities are of solid angle, and integrate to 1: what sample() gives has exactly density() of it.
///   D2  The density is above 0 wherever the filtered image is not black, but for what is lost of floats.
/// Debevec, "A Median Cut Algorithm for Light Probe Sampling", 2005, names the problem; rows and then columns by
/// inverted sums as in Pharr and Humphreys, "Physically Based Rendering", 2004.

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "sightline/io/image_file.h"
#include "sightline/scene/surroundings.h"

namespace sightline {

class SkyDistribution {
 public:
  /// Of the image's luminance, filtered as Sky does. None where it is the same everywhere: there the surface's own
  /// choice of directions is best. Price: 4 bytes a texel, of at most 1024 x 512; larger images go by blocks of texels.
  /// \throws FileError
  static std::optional<SkyDistribution> of(const SkyImage& sky);
  /// As if the sky had read it.
  static std::optional<SkyDistribution> of(const Image& image, double rotation);

  struct Sample {
    Vec3d direction{0};  ///< Of unit length.
    double density = 0;  ///< 0 where nothing comes of the square.
  };
  /// \param square in [0, 1) x [0, 1), uniformly.
  Sample sample(const glm::dvec2& square) const;
  /// Of a direction of unit length.
  double density(const Vec3d& direction) const;

 private:
  SkyDistribution() = default;
  float at(std::size_t row, std::size_t column) const { return sums_[row * (columns_ + 1) + column]; }
  double density_in(std::size_t row, std::size_t column, double v) const;

  std::size_t columns_ = 0, rows_ = 0;  ///< Rows from straight down to straight up.
  std::vector<float> sums_;             ///< Of each row, from 0 to 1: of its cells before each, and of all.
  std::vector<float> row_sums_;         ///< The same of rows.
  double rotation_ = 0;
};

}  // namespace sightline
