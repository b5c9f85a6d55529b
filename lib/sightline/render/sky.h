#pragma once

#include <optional>

#include "sightline/render/sky_distribution.h"
#include "sightline/scene/surroundings.h"
#include "sightline/texture/image_texture.h"

namespace sightline {

/// What rays see that leave the scene.
class Sky {
 public:
  /// Opens the image, where it is one. \throws FileError
  explicit Sky(const Surroundings& surroundings);

  bool is_black() const;
  bool is_image() const { return image_.has_value(); }
  /// Radiance from a direction of unit length.
  Color toward(const Vec3d& direction) const;

  /// Makes distribution() of an image. \throws FileError
  void distribute();
  /// Null before, and where directions that are chosen evenly do as well.
  const SkyDistribution* distribution() const { return distribution_ ? &*distribution_ : nullptr; }

 private:
  Surroundings surroundings_;
  std::optional<ImageTexture> image_;
  std::optional<SkyDistribution> distribution_;
};

}  // namespace sightline
