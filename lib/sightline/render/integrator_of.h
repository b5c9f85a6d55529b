#pragma once
/// How an Integrator's waves go. How a surface takes light is in integrator_shading.h.

#include <limits>

#include "sightline/render/integrator.h"
#include "sightline/render/integrator_painting.h"
#include "sightline/render/integrator_shading.h"

namespace sightline {
namespace detail {

/// Squares of 4 x 4 pixels together: sixteen neighbours make a packet. `pixels` are those that are asked for.
inline std::vector<PixelPlace> in_squares(const TileRect& rect, std::span<const std::uint32_t> pixels) {
  constexpr int side = 4;
  std::vector<PixelPlace> order(rect.pixels());
  PixelPlace* next = order.data();
  for (int y = 0; y < rect.height; y += side) {
    for (int x = 0; x < rect.width; x += side) {
      const int right = std::min(x + side, rect.width), below = std::min(y + side, rect.height);
      for (int j = y; j < below; ++j) {
        for (int i = x; i < right; ++i) {
          *next++ = {rect.x + i, rect.y + j, static_cast<std::uint32_t>(j * rect.width + i)};
        }
      }
    }
  }
  if (pixels.size() < rect.pixels()) {
    std::vector<std::uint8_t> is_asked(rect.pixels());
    for (const std::uint32_t pixel : pixels) is_asked[pixel] = 1;
    std::erase_if(order, [&](const PixelPlace& place) { return !is_asked[place.in_tile]; });
  }
  return order;
}

}  // namespace detail

template <Effects has>
void Integrator<has>::add_samples(TileBuffer& tile, std::span<const std::uint32_t> pixels, SampleRange range,
                                  FactsAsked facts) {
  const std::vector<PixelPlace> order = detail::in_squares(tile.rect, pixels);
  for (sample_ = range.first; sample_ < range.last; ++sample_) {
    turn_to(*scene_.moments[sample_ % scene_.moments.size()]);
    for (std::size_t first = 0; first < order.size(); first += wave_size) {
      const auto places = std::span(order).subspan(first, std::min(wave_size, order.size() - first));
      if constexpr (has.has(Effect::soft_shadow)) recall(tile, places);
      look(places);
      trace(current_, StageClock::camera(times_));
      if (sample_ == 0 && facts != FactsAsked::none) note_facts(tile, places, facts);
      see();
      follow();
      for (std::size_t i = 0; i < places.size(); ++i) tile.sums[places[i].in_tile].add(radiance_[i]);
      if constexpr (has.has(Effect::soft_shadow)) remember(tile, places);
    }
  }
}

template <Effects has>
void Integrator<has>::turn_to(const Moment& moment) {
  moment_ = &moment;
  const Camera& camera = moment.lens.camera;
  column_ = camera.right / double(camera.width), row_ = camera.up / double(camera.height);
  pixel_width_ = static_cast<float>(2 * glm::length(row_));
}

template <Effects has>
void Integrator<has>::look(std::span<const PixelPlace> places) {
  places_ = places;
  current_.densities.clear();
  current_.rays.resize(places.size());
  if constexpr (!is_slim) current_.paths.resize(places.size());
  const bool is_spread = scene_.effects.has(Effect::antialiasing);
  const bool has_depth = has.has(Effect::depth_of_field) && scene_.effects.has(Effect::depth_of_field);
  if (is_spread || has_depth) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Sampler draws = sampler(static_cast<std::uint32_t>(i));
      aim(i, is_spread ? draws.square(Draw::pixel) : glm::dvec2(0.5));
      if (has_depth) focus(current_.rays[i], draws);
    }
  } else {
    for (std::size_t i = 0; i < places.size(); ++i) aim(i, glm::dvec2(0.5));
  }
  counters_.camera_rays += places.size();
  if (is_spread) counters_[Effect::antialiasing] += places.size();
  if (scene_.moments.size() > 1) counters_[Effect::motion_blur] += places.size();
}

/// `within` is a place in the pixel.
template <Effects has>
void Integrator<has>::aim(std::size_t i, const glm::dvec2& within) {
  const Camera& camera = moment_->lens.camera;
  const int x = places_[i].x, y = places_[i].y;
  radiance_[i] = Vec3d(0);
  Ray<double>& ray = current_.rays[i];
  ray = {};
  ray.origin = camera.eye;
  ray.direction =
      camera.forward + (2 * (x + within.x) - camera.width) * column_ + (camera.height - 2 * (y + within.y)) * row_;
  if constexpr (!is_slim) {
    Path& path = current_.paths[i];
    path = {};
    path.slot = static_cast<std::uint32_t>(i);
    path.spread = pixel_width_;
  }
}

/// From a place on the lens to where the ray is in focus.
template <Effects has>
void Integrator<has>::focus(Ray<double>& ray, const Sampler& draws) {
  if constexpr (has.has(Effect::depth_of_field)) {
    const Lens& lens = moment_->lens;
    const glm::dvec2 on_lens = lens.radius * on_disk(draws.square(Draw::lens));
    const Vec3d shift = on_lens.x * glm::normalize(lens.camera.right) + on_lens.y * glm::normalize(lens.camera.up);
    ray.origin += shift;
    ray.direction -= shift / lens.focus_distance;
    ++counters_[Effect::depth_of_field];
  }
}

/// Reads the hits of the camera's rays, which have just been traced.
template <Effects has>
void Integrator<has>::note_facts(TileBuffer& tile, std::span<const PixelPlace> places, FactsAsked facts) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    PixelFacts& fact = tile.facts[places[i].in_tile];
    const WorldHit& hit = hits_[i];
    const Ray<double>& ray = current_.rays[i];
    if (hit.is_hit()) {
      const SurfacePoint at = moment_->surfaces->locate(ray, hit);
      fact.depth = static_cast<float>(hit.t * glm::length(ray.direction));
      const Vec3d normal = moment_->surfaces->normal(hit, at);
      fact.normal = Vec3f(glm::dot(normal, ray.direction) > 0 ? -normal : normal);
      fact.object = moment_->surfaces->node(hit);
    }
    if (facts == FactsAsked::with_work) {
      std::uint64_t work = 0;
      moment_->world->closest_hit(ray, work);
      fact.work = static_cast<std::uint32_t>(std::min<std::uint64_t>(work, 0xffff'ffff));
    }
  }
}

/// Until no ray is left; each kind's rays by themselves, in the same order whatever is compiled (I1).
template <Effects has>
void Integrator<has>::follow() {
  bool goes_on = true;
  const auto wave = [&]<Kind kind>() {
    if constexpr (has.has(effects_of_kinds[kind])) {
      if (next_[kind].is_empty()) return;
      std::swap(current_, next_[kind]);
      next_[kind].clear();
      counters_[effects_of_kinds[kind]] += current_.rays.size();
      trace(current_, StageClock::of(times_, effects_of_kinds[kind]));
      see();
      goes_on = true;
    }
  };
  while (std::exchange(goes_on, false)) {
    wave.template operator()<mirrored>();
    wave.template operator()<spread>();
    wave.template operator()<passing>();
    wave.template operator()<scattered>();
  }
}

template <Effects has>
void Integrator<has>::trace(RayWave& wave, StageTimes::Clock::duration* time) {
  hits_.resize(wave.rays.size());
  {
    const StageClock clock(time);
    moment_->world->closest_hits(wave.rays, hits_);
  }
  const StageClock clock(StageClock::shading(times_));
  if constexpr (has.has(Effect::procedural_texture)) paint(wave);
  const bool sees_misses = scene_.has_sky || has.has(Effect::fog);
  for (std::size_t i = 0; i < wave.rays.size(); ++i) {
    [[maybe_unused]] FirstPath first{static_cast<std::uint32_t>(i), 0, pixel_width_};
    AnyPath* path;
    if constexpr (is_slim)
      path = &first;
    else
      path = &wave.paths[i];
    if (hits_[i].is_hit()) {
      shade(wave.rays[i], *path, i);
    } else if (sees_misses) {
      shade_miss(wave.rays[i], *path, wave.densities.empty() ? 0 : wave.densities[i]);
    }
  }
}

/// Adds the light that nothing stops.
template <Effects has>
void Integrator<has>::see() {
  const auto ask = [&]<Sight sight>() {
    if constexpr (has.has(effects_of_sights[sight])) {
      Sights& sights = sights_[sight];
      if (sights.rays().empty()) return;
      const StageClock clock(StageClock::of(times_, effects_of_sights[sight]));
      counters_[effects_of_sights[sight]] += sights.rays().size();
      is_stopped_.resize(sights.rays().size());
      const TraceWorld& world = has.has(Effect::refraction) && moment_->opaque ? *moment_->opaque : *moment_->world;
      world.any_hits(sights.rays(), is_stopped_);
      if constexpr (sight == to_area) {
        see_areas();
      } else
        for (std::size_t i = 0; i < sights.rays().size(); ++i) {
          if (is_stopped_[i]) continue;
          Color light = sights.lights()[i].color;
          if constexpr (has.has(Effect::refraction)) {
            if (moment_->clear) light *= passed(sights.rays()[i]);
          }
          radiance_[sights.lights()[i].slot] += Vec3d(light);
        }
      sights.clear();
    }
  };
  ask.template operator()<to_point>();
  ask.template operator()<to_area>();
  ask.template operator()<to_occluder>();
  ask.template operator()<to_sky>();
}

/// Where some rays are not sent, those that were count for them.
template <Effects has>
void Integrator<has>::see_areas() {
  if constexpr (has.has(Effect::soft_shadow)) {
    const Sights& sights = sights_[to_area];
    for (std::size_t i = 0; i < sights.rays().size(); ++i) {
      const auto& [color, slot] = sights.lights()[i];
      const AreaRay& ray = area_rays_[i];
      Color found(is_stopped_[i] ? 0.0f : 1.0f);
      if constexpr (has.has(Effect::refraction)) {
        if (moment_->clear && !is_stopped_[i]) found = passed(sights.rays()[i]);
      }
      if (ray.is_trial) {
        seen_[slot].add(ray.lamp, found != Color(0), found != Color(1));
        ++counters_.shadow_trials;
      }
      found -= ray.guess;
      if (found != Color(0)) radiance_[slot] += Vec3d(color * found);
    }
    area_rays_.clear();
  }
}

/// What earlier samples found of lamps: where the scene is another at each moment, nothing that holds.
template <Effects has>
void Integrator<has>::recall(const TileBuffer& tile, std::span<const PixelPlace> places) {
  const bool asks = scene_.shadow_error2 > 0 && scene_.moments.size() == 1 && moment_->area_lamps > 0;
  is_trial_ = asks && sample_ < LampsSeen::trials;
  for (std::size_t i = 0; i < places.size(); ++i) {
    known_[i] = LampsSeen(asks && !is_trial_ ? tile.sums[places[i].in_tile].lamps_seen : 0);
    seen_[i] = LampsSeen();
  }
}

template <Effects has>
void Integrator<has>::remember(TileBuffer& tile, std::span<const PixelPlace> places) const {
  if (!is_trial_) return;
  for (std::size_t i = 0; i < places.size(); ++i) {
    LampsSeen all(tile.sums[places[i].in_tile].lamps_seen);
    all.add(seen_[i]);
    tile.sums[places[i].in_tile].lamps_seen = all.bits();
  }
}

/// The share of light that what is transparent lets through, as if it went straight on.
template <Effects has>
Color Integrator<has>::passed(const Ray<double>& ray) {
  constexpr int most_boundaries = 64;
  const TraceWorld& world = *moment_->clear;
  const Surfaces& surfaces = *moment_->clear_surfaces;
  Color left(1);
  Ray<double> rest = ray;
  for (int i = 0; i < most_boundaries; ++i) {
    WorldHit hit;
    world.closest_hits(std::span<const Ray<double>>(&rest, 1), std::span(&hit, 1));
    if (!hit.is_hit()) return left;
    ++counters_[Effect::refraction];
    const SurfaceMaterial& material = (*scene_.materials)[surfaces.material(hit)];
    if (!material.is_transparent) return Color(0);
    const SurfacePoint at = surfaces.locate(rest, hit);
    const double cosine = glm::dot(at.outside, rest.direction);
    const bool is_leaving = cosine > 0;
    const Material& values = material.values;
    if (is_leaving) left *= glm::exp(-static_cast<float>(hit.t) * values.absorption);
    // By the same angle on both sides, as of a plate.
    const double through =
        material.has_coat ? 1 - fresnel(std::min(1.0, std::fabs(cosine)), values.refractive_index) : 1;
    left *= static_cast<float>((1 - values.metallic) * values.transmission * through) * values.color;
    if (largest(left) == 0) return left;
    rest.origin = at.beyond(is_leaving ? at.outside : -at.outside);
    rest.t_max -= hit.t;
    if (!(rest.t_max > 0)) return left;
  }
  return Color(0);
}

}  // namespace sightline
