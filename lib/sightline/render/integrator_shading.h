#pragma once
/// How an Integrator's surfaces take light. What they ask of lights is in integrator_lights.h.

#include <cmath>
#include <numbers>

#include "sightline/render/integrator_lights.h"
#include "sightline/render/integrator_painting.h"
#include "sightline/texture/normal_map.h"

namespace sightline {

template <Effects has>
void Integrator<has>::shade_miss(const Ray<double>& ray, AnyPath& path, [[maybe_unused]] double density) {
  Color light(0);
  if constexpr (has.has(Effect::fog)) in_fog(std::numeric_limits<double>::infinity(), path, light);
  const bool is_lit = !path.is_scattered || scene_.sky_lights;
  if (scene_.has_sky && is_lit) {
    const Vec3d way = glm::normalize(ray.direction);
    Color seen = path.weight * scene_.sky->toward(way);
    if constexpr (has_bright_gloss) {
      if (density > 0) seen *= balance(density, bright_->density(way));
    }
    light += seen;
  }
  if (light != Color(0)) radiance_[path.slot] += Vec3d(light);
}

/// What is left of a path after the length; what fog adds to it.
template <Effects has>
void Integrator<has>::in_fog(double length, Path& path, Color& light) const {
  if constexpr (has.has(Effect::fog)) {
    if (scene_.fog.density == 0 || path.medium != no_item) return;
    ++counters_[Effect::fog];
    const auto left = static_cast<float>(std::exp(-scene_.fog.density * length));
    light += (1 - left) * path.weight * scene_.fog.color;
    path.weight *= left;
  }
}

template <Effects has>
void Integrator<has>::shade(const Ray<double>& ray, AnyPath& path, std::size_t place) {
  constexpr bool is_painted = has.has(Effect::procedural_texture);
  const WorldHit& hit = hits_[place];
  const Surfaces& surfaces = *moment_->surfaces;
  SurfacePoint located;
  if constexpr (!is_painted) surfaces.locate(ray, hit, located);
  const SurfacePoint& at = is_painted ? painted_[place].at : located;
  const std::uint32_t number = is_painted ? painted_[place].material : surfaces.material(hit);
  const SurfaceMaterial& material = (*scene_.materials)[number];
  Shade shade{material, number, hit, at};
  shade.to_viewer = -ray.direction;
  if constexpr (has_footprints) path.width += path.spread * static_cast<float>(hit.t);
  [[maybe_unused]] double length = 0;
  if constexpr (has_lengths) {
    const double speed = std::sqrt(glm::dot(ray.direction, ray.direction));
    length = hit.t * speed;
    shade.to_viewer /= speed;
    if constexpr (has_more_rays)
      path.spread /= static_cast<float>(speed);  // from here on directions are of unit length
  }
  shade.slant = glm::dot(shade.at.outside, shade.to_viewer);
  shade.is_inside = shade.slant < 0;
  shade.side = shade.is_inside ? -shade.at.outside : shade.at.outside;

  Color light(0);
  if constexpr (has.has(Effect::absorption)) {
    if (path.medium != no_item) {
      const Color& absorption = (*scene_.materials)[path.medium].values.absorption;
      if (absorption != Color(0)) {
        path.weight *= glm::exp(-static_cast<float>(length) * absorption);
        ++counters_[Effect::absorption];
      }
    }
  }
  if constexpr (has.has(Effect::fog)) in_fog(length, path, light);
  if constexpr (has.has(Effect::emission)) {
    if (material.is_emitting) {
      light += path.weight * material.values.emission;
      ++counters_[Effect::emission];
    }
  }
  shade.color = color_at(shade, path, place);
  // A flat one faces the viewer, but edge-on.
  shade.is_bent = has.has(Effect::normal_map) || surfaces.is_smooth(hit) || !(std::fabs(shade.slant) > 0);
  shade.normal = shade.is_bent ? normal_at(shade, path) : shade.side;

  // What is neither diffuse nor asks for a specular effect is black (MaterialTable::of).
  Color diffuse = shade.color;
  if constexpr (is_specular) diffuse = share_out(shade, path);
  if constexpr (has.has(Effect::ambient)) {
    if (scene_.effects.has(Effect::ambient) && !is_black(diffuse)) {
      light += path.weight * diffuse * scene_.ambient.color;
      ++counters_[Effect::ambient];
    }
  }
  if constexpr (has.has(Effect::fog) || has.has(Effect::emission) || has.has(Effect::ambient)) {
    if (!is_black(light)) radiance_[path.slot] += Vec3d(light);
  }
  shine(shade, path, diffuse);
  if (!is_black(diffuse)) look_around(shade, path, diffuse);
  if constexpr (has.has(Effect::environment)) {
    if (bright_) look_at_sky(shade, path, diffuse);
  }
}

template <Effects has>
Color Integrator<has>::color_at(const Shade& shade, const AnyPath& path, std::size_t place) {
  const SurfaceMaterial& material = shade.material;
  Color color = material.values.color;
  if constexpr (has.has(Effect::procedural_texture)) {
    if (material.color_function) color *= painted_[place].color;
  }
  if constexpr (has.has(Effect::image_texture)) {
    if (material.color_image) {
      const StageClock clock(StageClock::of(times_, Effect::image_texture), StageClock::shading(times_));
      const Surfaces::ImagePlace in_image = moment_->surfaces->image_place(shade.hit, shade.at);
      const double seen = scene_.has_footprints ? slanted_footprint(path.width, shade.side, shade.to_viewer) : 0;
      const double width = in_image.scale * seen;
      color *= (*material.color_image)(in_image.uv, {{width, 0}, {0, width}});
      ++counters_[Effect::image_texture];
    }
  }
  return color;
}

template <Effects has>
Vec3d Integrator<has>::normal_at(const Shade& shade, const AnyPath& path) {
  const Surfaces& surfaces = *moment_->surfaces;
  Vec3d normal = surfaces.normal(shade.hit, shade.at);
  if constexpr (has.has(Effect::normal_map)) {
    const SurfaceMaterial& material = shade.material;
    if (material.normal_map || material.dents) {
      const StageClock clock(StageClock::of(times_, Effect::normal_map), StageClock::shading(times_));
      ++counters_[Effect::normal_map];
      const double footprint = scene_.has_footprints ? path.width : 0;
      if (material.normal_map) {
        const Surfaces::ImagePlace place = surfaces.image_place(shade.hit, shade.at);
        const double width = place.scale * footprint;
        const Color stored = (*material.normal_map)(place.uv, {{width, 0}, {0, width}});
        const TangentFrame frame = surfaces.tangent_frame(shade.hit, shade.at, normal);
        normal = frame.to_world(decode_normal(stored, material.values.normal_strength));
      }
      if (material.dents) normal = surfaces.dented(shade.hit, shade.at, normal, *material.dents, footprint);
    }
  }
  if (normal == shade.at.outside && std::fabs(shade.slant) > 0) return shade.side;
  // Of copies: a Shade whose address goes nowhere stays in registers.
  return facing_normal(normal, Vec3d(shade.at.outside), Vec3d(shade.to_viewer));
}

/// Sends on what is mirrored and what passes, and returns what is left to be scattered to all sides (I2).
template <Effects has>
Color Integrator<has>::share_out(Shade& shade, const Path& path) {
  const SurfaceMaterial& material = shade.material;
  const Material& values = material.values;
  if (!material.has_coat && values.metallic == 0 && !material.is_transparent) {
    return material.is_diffuse ? shade.color : Color(0);
  }
  shade.eta = shade.is_inside && material.is_transparent ? 1 / values.refractive_index : values.refractive_index;
  Vec3d facet = shade.normal;
  if constexpr (has.has(Effect::glossy)) {
    if (material.is_glossy) {
      const TangentFrame frame = frame_around(shade.normal);
      facet = frame.to_world(
          Microfacets(values.roughness)
              .visible_facet(frame.to_local(shade.to_viewer), sampler(path.slot).square(Draw::glossy, path.depth)));
    }
  }
  const double cos_facet = std::clamp(glm::dot(facet, shade.to_viewer), 0.0, 1.0);
  const double dielectric = material.has_coat ? fresnel(cos_facet, shade.eta) : 0;
  const Color reflection = reflectance(material, shade.color, dielectric, cos_facet);
  const Color rest = static_cast<float>((1 - values.metallic) * (1 - dielectric)) * shade.color;
  const Color passes = material.is_transparent ? static_cast<float>(values.transmission) * rest : Color(0);
  const Color diffuse = material.is_diffuse ? static_cast<float>(1 - values.transmission) * rest : Color(0);

  // With interreflection a path goes on in one direction from its second surface on, as likely as light goes there.
  float goes_reflected = 1, goes_through = 1;
  if constexpr (has.has(Effect::interreflection)) {
    if (scene_.effects.has(Effect::interreflection) && path.depth > 0) {
      const float all = largest(reflection) + largest(passes) + largest(diffuse);
      const auto chosen = static_cast<float>(sampler(path.slot).square(Draw::lobe, path.depth).x) * all;
      goes_reflected = chosen < largest(reflection) ? all / largest(reflection) : 0;
      const bool is_through = goes_reflected == 0 && chosen < largest(reflection) + largest(passes);
      goes_through = is_through ? all / largest(passes) : 0;
      shade.goes_scattered = goes_reflected == 0 && !is_through && largest(diffuse) > 0 ? all / largest(diffuse) : 0;
    }
  }
  if constexpr (reflects) {
    const Vec3d direction = reflected(shade.to_viewer, facet);
    if (goes_reflected > 0 && glm::dot(direction, shade.side) > 0) {
      float seen = goes_reflected;
      if (has.has(Effect::glossy) && material.is_glossy) {
        const Microfacets facets(values.roughness);
        const double cos_view = glm::dot(shade.normal, shade.to_viewer), cos_out = glm::dot(shade.normal, direction);
        seen *= cos_out > 0 ? static_cast<float>(facets.seen_by_both(cos_view, cos_out) / facets.seen(cos_view)) : 0;
      }
      go_on(material.is_glossy ? spread : mirrored, shade, path, direction, seen * reflection);
      if constexpr (has_bright_gloss) {
        RayWave& wave = next_[spread];
        if (asks_bright_sky(material, path) && wave.densities.size() < wave.rays.size()) {
          wave.densities.push_back(
              Microfacets(values.roughness)
                  .density_of_reflected(glm::dot(shade.normal, shade.to_viewer), glm::dot(shade.normal, facet)));
        }
      }
    }
  }
  if constexpr (has.has(Effect::refraction)) {
    if (goes_through > 0 && material.is_transparent && dielectric < 1) {
      const Vec3d direction = refracted(shade.to_viewer, shade.normal, shade.eta);
      if (glm::dot(direction, shade.side) < 0) go_on(passing, shade, path, direction, goes_through * passes);
    }
  }
  return diffuse;
}

template <Effects has>
void Integrator<has>::add_sight(Sight sight, const Shade& shade, const Vec3d& direction, double length,
                                const Color& light, std::uint32_t slot) {
  sights_[sight].add(shade.at.beyond(shade.side), direction, length, {light, slot});
}

template <Effects has>
void Integrator<has>::go_on(Kind kind, const Shade& shade, const Path& path, const Vec3d& direction,
                            const Color& weight) {
  Path next = path;
  next.weight = path.weight * weight;
  next.depth = static_cast<std::uint16_t>(path.depth + 1);
  next.is_scattered = kind == scattered;
  if (kind == passing) next.medium = shade.is_inside ? no_item : shade.number;
  if (kind == scattered) next.spread = std::max(next.spread, 0.5f);
  if (kind == spread) next.spread = std::max(next.spread, static_cast<float>(shade.material.values.roughness) / 2);
  const float largest_weight = largest(next.weight);
  if (next.depth > scene_.depth || !(largest_weight > scene_.cut_off * (kind != scattered))) {
    ++counters_.rays_cut_off;
    return;
  }
  if constexpr (has.has(Effect::interreflection)) {
    constexpr int sure = 3;  // bounces before chance decides
    if (kind == scattered && next.depth > sure) {
      const float survives = std::clamp(largest_weight, 0.05f, 1.0f);
      if (sampler(path.slot).square(Draw::survival, path.depth).x >= survives) return;
      next.weight /= survives;
    }
  }
  Ray<double> ray;
  ray.origin = shade.at.beyond(kind == passing ? -shade.side : shade.side);
  ray.direction = direction;
  next_[kind].add(ray, next);
}

}  // namespace sightline
