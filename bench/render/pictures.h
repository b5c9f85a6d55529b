#pragma once
/// Scenes to render, each beside what POV-Ray is given for it.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sightline/scene/camera.h"
#include "sightline/scene/scene.h"

namespace sightline::bench {

struct RenderPicture {
  std::string name, description;
  std::shared_ptr<const Scene> scene;
  std::function<std::string(const Camera&)> povray;  ///< The same scene in POV-Ray's language, seen by this camera.
  bool has_same_shades = true;                       ///< There; not where both make noise of their own.
};

/// A widget, and a sphere of wood; each under one lamp that is infinitely far.
std::vector<RenderPicture> render_pictures();

}  // namespace sightline::bench
