#include "bench/accuracy/axes/picture.h"

#include <filesystem>

#include "bench/accuracy/error_sum.h"
#include "sightline/render/exposure.h"
#include "sightline/render/ray_count.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {

std::shared_ptr<const Scene> picture_scene(const Effort& effort, const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(effort.data_dir) / "scenes" / (name + ".json");
  return std::make_shared<const Scene>(make_scene(file.string(), effort.data_dir));
}

RenderSettings picture_settings(const Effort& effort, std::uint32_t samples) {
  RenderSettings settings;
  settings.width = effort.is_quick ? 48 : 96;
  settings.height = effort.is_quick ? 36 : 72;
  settings.samples = samples;
  settings.seed = effort.seed;
  return settings;
}

FilmState picture_of(const Renderer& renderer, int threads) {
  const std::atomic<bool> stops = false;
  Film film(blank_film(renderer.width(), renderer.height(), renderer.samples(), renderer.settings().error_bound));
  expose(film, renderer, {.threads = threads}, stops);
  return film.state();
}

Errors picture_errors(const FilmState& picture, const FilmState& truth) {
  ErrorSum sum;
  for (std::size_t i = 0; i < truth.sums.size(); ++i) {
    const auto shown = [i](const FilmState& film) {
      const PixelSum& pixel = film.sums[i];
      return glm::min(pixel.color / double(pixel.samples), Vec3d(1));
    };
    const Vec3d off = shown(picture) - shown(truth);
    for (int channel = 0; channel < 3; ++channel) sum.add(off[channel]);
  }
  return sum.errors();
}

Choice picture_choice(const std::string& name, const std::shared_ptr<const Scene>& scene,
                      const RenderSettings& settings, const FilmState& truth) {
  const auto renderer = std::make_shared<const Renderer>(scene, settings);
  const FilmState picture = picture_of(*renderer, 1);
  double samples = 0;
  for (const PixelSum& pixel : picture.sums) samples += pixel.samples;
  const double pixels = static_cast<double>(picture.sums.size());
  return {
      name,
      picture_errors(picture, truth),
      [renderer] { return picture_of(*renderer, 1).sums.front().color.x; },
      {{"samples/pixel", samples / pixels}, {"rays/pixel", static_cast<double>(rays_of(picture.counters)) / pixels}}};
}

}  // namespace sightline::bench
