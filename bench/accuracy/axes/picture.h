#pragma once
/// Little pictures of a scene, by one thread.

#include <memory>
#include <string>

#include "bench/accuracy/axis.h"
#include "sightline/render/film.h"
#include "sightline/render/renderer.h"

namespace sightline::bench {

std::shared_ptr<const Scene> picture_scene(const Effort& effort, const std::string& name);

/// 96 x 72 pixels, 48 x 36 where it is to be quick.
RenderSettings picture_settings(const Effort& effort, std::uint32_t samples);

/// By as many threads as asked for; the picture is the same.
FilmState picture_of(const Renderer& renderer, int threads);

/// Of each color of each pixel, as a screen shows it: what is brighter than white is white.
Errors picture_errors(const FilmState& picture, const FilmState& truth);

/// What is timed is taking the picture, without building.
Choice picture_choice(const std::string& name, const std::shared_ptr<const Scene>& scene,
                      const RenderSettings& settings, const FilmState& truth);

}  // namespace sightline::bench
