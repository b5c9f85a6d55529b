#pragma once
/// How an Integrator's surfaces get their colors from functions of space: a wave at a time, since these find many
/// points faster than one by one.

#include <algorithm>
#include <cmath>

#include "sightline/render/integrator.h"

namespace sightline {

/// Of what a slanted surface shows of a cone that is as wide as `width` there, it is longer than wide: the mean of
/// both.
inline double slanted_footprint(float width, const Vec3d& normal, const Vec3d& to_viewer) {
  return width / std::sqrt(std::max(std::fabs(glm::dot(normal, to_viewer)), 0x1p-4));
}

/// Fills painted_ where there are hits.
template <Effects has>
void Integrator<has>::paint(const RayWave& wave) {
  const Surfaces& surfaces = *moment_->surfaces;
  painted_.resize(hits_.size());
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    const WorldHit& hit = hits_[i];
    if (!hit.is_hit()) continue;
    const Ray<double>& ray = wave.rays[i];
    Painted& painted = painted_[i];
    surfaces.locate(ray, hit, painted.at);
    painted.material = surfaces.material(hit);
    const Texture* const function = (*scene_.materials)[painted.material].color_function;
    if (!function) continue;
    if (function != strokes_.function) finish_strokes();
    strokes_.function = function;
    strokes_.places.push_back(i);
    strokes_.points.emplace_back() = surfaces.local(hit, painted.at);
    double footprint = 0;
    if (scene_.has_footprints) {
      float width = 0, widening = pixel_width_;
      if constexpr (!is_slim) width = wave.paths[i].width, widening = wave.paths[i].spread;
      width += widening * static_cast<float>(hit.t);
      const double speed = std::sqrt(glm::dot(ray.direction, ray.direction));
      footprint = slanted_footprint(width, painted.at.outside, -ray.direction / speed);
    }
    strokes_.footprints.emplace_back() = surfaces.local_footprint(hit, painted.at, footprint);
  }
  finish_strokes();
}

template <Effects has>
void Integrator<has>::finish_strokes() {
  const std::size_t count = strokes_.points.size();
  if (count == 0) return;
  const StageClock clock(StageClock::of(times_, Effect::procedural_texture), StageClock::shading(times_));
  counters_[Effect::procedural_texture] += count;
  strokes_.colors.resize(count);
  strokes_.function->colors(strokes_.points, strokes_.footprints, strokes_.colors);
  for (std::size_t k = 0; k < count; ++k) painted_[strokes_.places[k]].color = strokes_.colors[k];
  strokes_.points.clear();
  strokes_.footprints.clear();
  strokes_.places.clear();
}

}  // namespace sightline
