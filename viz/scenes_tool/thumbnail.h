#pragma once

#include <memory>

#include "sightline/io/image_file.h"
#include "sightline/scene/scene.h"

namespace sightline::scenes_tool {

/// The scene as the renderer shows it with few samples, by its first camera or else from the front.
/// \throws as Renderer does.
Image thumbnail(std::shared_ptr<const Scene> scene, int width, int height);

}  // namespace sightline::scenes_tool
