#pragma once

#include <vector>

#include "sightline/math/vec.h"
#include "sightline/math/volume_overlap.h"
#include "sightline/scene/camera.h"

namespace sightline {

/// What a camera may see: the pyramid from its eye through the edges of its picture, without an end.
///   F1  Holds all points of Camera::ray of every pixel: the eye is as those have it, and planes are tilted outward by
///       what rounding directions to float may turn them.
class ViewFrustum {
 public:
  explicit ViewFrustum(const Camera& camera);

  /// False only where no point of the volume is within; volumes near an edge of the pyramid may be taken to be seen.
  template <class V>
  bool may_see(const V& volume) const {
    for (const Vec3d& normal : normals_) {
      if (!(extent_along(volume, normal, eye_).hi >= 0)) return false;
    }
    return true;
  }

 private:
  Vec3d eye_;
  std::vector<Vec3d> normals_;  ///< Inward, of planes through the eye, of unit length.
};

}  // namespace sightline
