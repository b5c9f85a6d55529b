#pragma once
/// What an Integrator's surfaces ask of lamps, and of all that is around them.

#include <cmath>
#include <limits>
#include <numbers>

#include "sightline/render/integrator.h"

namespace sightline {

/// The share that a way of choosing a direction has, where another might have chosen it as well: the balance heuristic
/// of Veach and Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995. Shares sum up to 1.
inline float balance(double density, double other) { return static_cast<float>(density / (density + other)); }

/// What is reflected of light that comes at this angle to a facet.
inline Color reflectance(const SurfaceMaterial& material, const Color& color, double dielectric, double cos_facet) {
  const auto metallic = static_cast<float>(material.values.metallic);
  Color share(static_cast<float>(dielectric) * (1 - metallic));
  if (metallic > 0) share += metallic * fresnel_of_metal(color, cos_facet);
  return share;
}

/// Asks the lamps.
template <Effects has>
void Integrator<has>::shine(const Shade& shade, const AnyPath& path, const Color& diffuse) {
  const SurfaceMaterial& material = shade.material;
  const bool is_glossy = has.has(Effect::glossy) && material.is_glossy;
  if (is_black(diffuse) && !is_glossy) return;
  std::uint32_t i = 0, areas = 0;
  for (const Lamp& lamp : moment_->lamps) {
    const bool is_area = has.has(Effect::soft_shadow) && lamp.is_area();
    const std::uint32_t number = i++, area = areas;
    areas += is_area;
    const std::uint32_t count = is_area ? scene_.light_samples : 1;
    for (std::uint32_t k = 0; k < count; ++k) {
      glm::dvec2 place(0.5);
      if (is_area) place = sampler(path.slot).square(Draw::light, path.depth, number << 8 | k);
      const LampLight from = light_of(lamp, shade.at.point, place);
      const double cosine = glm::dot(shade.normal, from.to_lamp);
      if (!(cosine > 0) || (shade.is_bent && !(glm::dot(shade.side, from.to_lamp) > 0))) continue;
      ++counters_[Effect::direct_light];
      Color share = static_cast<float>(cosine * std::numbers::inv_pi) * diffuse;
      if constexpr (has.has(Effect::glossy)) {
        if (is_glossy) share += highlight(shade, from.to_lamp, cosine);
      }
      Color light = path.weight * share * from.irradiance;
      if (is_area) light /= static_cast<float>(count);
      if (is_black(light)) continue;
      if (is_area) {
        add_area_ray(shade, path, from, light, area, number << 8 | k);
      } else {
        add_sight(to_point, shade, from.to_lamp, from.distance, light, path.slot);
      }
    }
  }
}

/// Sends a ray to an area lamp, number `lamp` of them, or what one would find in the mean.
template <Effects has>
void Integrator<has>::add_area_ray(const Shade& shade, const AnyPath& path, const LampLight& from, Color light,
                                   std::uint32_t lamp, std::uint32_t which) {
  if constexpr (has.has(Effect::soft_shadow)) {
    const bool is_first = path.depth == 0;
    AreaRay ray{lamp, 0, is_trial_ && is_first};
    if (scene_.shadow_error2 > 0 && !ray.is_trial) {
      // C3: surfaces that a sample meets after d others are at most 2^d, or, with interreflection, 3 of d > 0.
      const double allowed =
          scene_.shadow_error2 * std::exp2(-2.0 * path.depth - 1) / (moment_->area_lamps * scene_.light_samples);
      const ShadowChoice choice = choose_shadow_ray(light, allowed, is_first ? known_[path.slot] : LampsSeen(), lamp);
      ray.guess = choice.guess;
      if (ray.guess > 0) radiance_[path.slot] += Vec3d(ray.guess * light);
      if (sampler(path.slot).square(Draw::shadow, path.depth, which).x >= choice.probability) {
        ++counters_.shadow_rays_spared;
        return;
      }
      light /= static_cast<float>(choice.probability);
    }
    area_rays_.push_back(ray);
    add_sight(to_area, shade, from.to_lamp, from.distance, light, path.slot);
  }
}

/// What facets send to the viewer of a lamp's irradiance, their cosine included.
template <Effects has>
Color Integrator<has>::highlight(const Shade& shade, const Vec3d& to_lamp, double cosine) const {
  const Vec3d facet = glm::normalize(to_lamp + shade.to_viewer);
  const double cos_view = glm::dot(shade.normal, shade.to_viewer);
  const double cos_facet = std::clamp(glm::dot(facet, shade.to_viewer), 0.0, 1.0);
  const Microfacets facets(shade.material.values.roughness);
  const double share =
      facets.density(glm::dot(shade.normal, facet)) * facets.seen_by_both(cos_view, cosine) / (4 * cos_view);
  const double dielectric = shade.material.has_coat ? fresnel(cos_facet, shade.eta) : 0;
  return static_cast<float>(share) * reflectance(shade.material, shade.color, dielectric, cos_facet);
}

/// Asks what is all around: nothing but what shuts it out, the sky, or surfaces that light this one.
template <Effects has>
void Integrator<has>::look_around(const Shade& shade, const AnyPath& path, const Color& diffuse) {
  const auto direction = [&](Draw purpose) {
    const Vec3d up = cosine_direction(sampler(path.slot).square(purpose, path.depth));
    return frame_around(shade.normal).to_world(up);
  };
  if constexpr (has.has(Effect::ambient_occlusion)) {
    if (scene_.effects.has(Effect::ambient_occlusion)) {
      const Vec3d way = direction(Draw::occlusion);
      if (glm::dot(way, shade.side) > 0) {
        add_sight(to_occluder, shade, way, scene_.ambient.occlusion_distance,
                  path.weight * diffuse * scene_.ambient.color, path.slot);
      }
    }
  }
  if constexpr (has.has(Effect::environment)) {
    if (scene_.effects.has(Effect::environment)) {
      const Vec3d way = direction(Draw::environment);
      if (glm::dot(way, shade.side) > 0) {
        Color light = path.weight * diffuse * scene_.sky->toward(way);
        if (bright_) light *= balance(glm::dot(way, shade.normal) * std::numbers::inv_pi, bright_->density(way));
        add_sight(to_sky, shade, way, std::numeric_limits<double>::infinity(), light, path.slot);
      }
    }
  }
  if constexpr (has.has(Effect::interreflection)) {
    if (scene_.effects.has(Effect::interreflection) && shade.goes_scattered > 0) {
      const Vec3d way = direction(Draw::diffuse);
      if (glm::dot(way, shade.side) > 0) go_on(scattered, shade, path, way, shade.goes_scattered * diffuse);
    }
  }
}

/// Asks where an image of the sky is bright. Of each direction this has the share that look_around() and paths from
/// glossy surfaces leave it.
template <Effects has>
void Integrator<has>::look_at_sky(const Shade& shade, const AnyPath& path, const Color& diffuse) {
  if constexpr (has.has(Effect::environment)) {
    const bool is_glossy = asks_bright_sky(shade.material, path);
    if (is_black(diffuse) && !is_glossy) return;
    const auto [way, density] = bright_->sample(sampler(path.slot).square(Draw::sky, path.depth));
    const double cosine = glm::dot(shade.normal, way);
    if (!(density > 0 && cosine > 0) || !(glm::dot(shade.side, way) > 0)) return;
    const double by_diffuse = cosine * std::numbers::inv_pi;
    Color share = static_cast<float>(by_diffuse / (density + by_diffuse)) * diffuse;
    if constexpr (has_bright_gloss) {
      if (is_glossy) {
        const Vec3d facet = glm::normalize(way + shade.to_viewer);
        const double by_facets =
            Microfacets(shade.material.values.roughness)
                .density_of_reflected(glm::dot(shade.normal, shade.to_viewer), glm::dot(shade.normal, facet));
        share += highlight(shade, way, cosine) / static_cast<float>(density + by_facets);
      }
    }
    const Color light = path.weight * share * scene_.sky->toward(way);
    if (light == Color(0)) return;
    add_sight(to_sky, shade, way, std::numeric_limits<double>::infinity(), light, path.slot);
  }
}

}  // namespace sightline
