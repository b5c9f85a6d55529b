#pragma once

#include "sightline/io/image_file.h"
#include "sightline/scene/scene.h"

namespace sightline::scenes_tool {

/// The scene as its first camera sees it, or else from the front: colors of materials with their textures under a soft
/// sky, without shadows. Solids are cut by rays, as they are.
/// \throws std::invalid_argument and std::length_error as instances_of() and Instances::flattened() do.
Image thumbnail(const Scene& scene, int width, int height);

}  // namespace sightline::scenes_tool
