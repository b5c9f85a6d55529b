#pragma once

#include <optional>

#include "sightline/scene/surroundings.h"
#include "sightline/texture/image_texture.h"

namespace sightline {

/// What rays see that leave the scene.
class Sky {
 public:
  /// Opens the image, where it is one. \throws FileError
  explicit Sky(const Surroundings& surroundings);

  bool is_black() const;
  /// Radiance from a direction of unit length.
  Color toward(const Vec3d& direction) const;

 private:
  Surroundings surroundings_;
  std::optional<ImageTexture> image_;
};

}  // namespace sightline
