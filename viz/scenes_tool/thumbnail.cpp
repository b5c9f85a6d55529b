#include "viz/scenes_tool/thumbnail.h"

#include "sightline/render/exposure.h"
#include "sightline/render/film_image.h"
#include "sightline/render/renderer.h"

namespace sightline::scenes_tool {

Image thumbnail(std::shared_ptr<const Scene> scene, int width, int height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.samples = 4;
  const Renderer renderer(std::move(scene), settings);
  Film film(blank_film(width, height, renderer.samples(), 0));
  const std::atomic<bool> stops = false;
  expose(film, renderer, {}, stops);
  return {width, height, 3, picture_of(film.state(), 0).pixels};
}

}  // namespace sightline::scenes_tool
