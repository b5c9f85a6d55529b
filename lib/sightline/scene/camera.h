#pragma once

#include <vector>

#include "sightline/math/aabb.h"
#include "sightline/math/ray.h"

namespace sightline {

/// A pinhole camera. Pixel (0, 0) is the top left one; rays go through pixel centers.
struct Camera {
  Vec3d eye{0, 0, 0};
  Vec3d forward{0, 0, -1};  ///< To the middle of the picture plane.
  Vec3d right{1, 0, 0};     ///< From the middle of the picture plane to its right edge.
  Vec3d up{0, 1, 0};        ///< From the middle to the top edge.
  int width = 1;
  int height = 1;

  /// Looks at `target` from `eye`, `y_up` upward in the picture, with a vertical field of view in degrees.
  static Camera looking_at(const Vec3d& eye, const Vec3d& target, const Vec3d& y_up, double field_of_view, int width,
                           int height);

  /// Sees all of `bounds`, y upward, from a little above and to the right of the front (+z).
  static Camera facing(const Aabb& bounds, int width, int height);

  Ray<float> ray(int x, int y) const;
};

/// One ray a pixel, row by row from the top.
std::vector<Ray<float>> primary_rays(const Camera& camera);

}  // namespace sightline
