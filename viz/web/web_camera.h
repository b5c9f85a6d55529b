#pragma once

#include "sightline/scene/camera.h"
#include "viz/partition_picture.h"

namespace sightline::viz {

/// From where a page's rays are picked, and around what its view turns.
struct WebCamera {
  Camera camera;
  Vec3d focus;
};
WebCamera web_camera(const Aabb& bounds, const View& view);

}  // namespace sightline::viz
