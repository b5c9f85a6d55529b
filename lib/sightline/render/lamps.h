#pragma once
/// Lights of a scene, as surfaces ask them.

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

#include "sightline/scene/scene.h"

namespace sightline {

/// A light where it stands. Units as in scene.h.
struct Lamp {
  enum class Kind : std::uint8_t { point, directional, spot, area };

  Kind kind = Kind::point;
  std::uint32_t light = no_item;  ///< Its number in the scene, if it is of the scene.
  Vec3d position{0};              ///< The middle of an area.
  Vec3d axis{0, 0, -1};           ///< Where it shines, of unit length.
  Vec3d right{0}, up{0};          ///< Of an area, its whole edges.
  Color strength{1};              ///< Radiant intensity, irradiance, or radiance.
  double cos_inner = 1, cos_outer = 0;
  double area = 0;

  bool is_area() const { return kind == Kind::area; }
};

/// What a lamp, or the part of it that was chosen, would send to a point if nothing were in between.
struct LampLight {
  Vec3d to_lamp{0};     ///< From the point, of unit length.
  Color irradiance{0};  ///< On a surface that faces it.
  double distance = std::numeric_limits<double>::infinity();
};

/// `square` chooses a point of an area, uniformly; of no account otherwise. Its irradiance is that of the whole lamp as
/// if all of it were there, so that means over the square are right.
///   What shines along an axis may be in the very plane of a ceiling: rays to it, which begin up to 4 `error` off the
///   point, end before that plane. They end so far in front of the lamp that neither their beginning, nor rounding, nor
///   a triangle's t, unless that is thin as well as large, goes beyond.
[[gnu::always_inline]] inline LampLight light_of(const Lamp& lamp, const Vec3d& point, const glm::dvec2& square,
                                                 double error = 0) {
  LampLight light;
  if (lamp.kind == Lamp::Kind::directional) {
    light.to_lamp = -lamp.axis;
    light.irradiance = lamp.strength;
    return light;
  }
  Vec3d way = lamp.position - point;
  if (lamp.is_area()) way += (square.x - 0.5) * lamp.right + (square.y - 0.5) * lamp.up;
  if (lamp.kind != Lamp::Kind::point) {
    const double size = max_norm(lamp.position) + max_norm(lamp.right) + max_norm(lamp.up) + max_norm(point);
    way += (8 * error + 0x1p-46 * size) * lamp.axis;
  }
  const double distance2 = glm::dot(way, way);
  if (!(distance2 > 0)) return light;  // in the lamp itself nothing can be said
  light.distance = std::sqrt(distance2);
  light.to_lamp = way / light.distance;
  double share = 1 / distance2;
  if (lamp.kind != Lamp::Kind::point) {
    const double cosine = -glm::dot(light.to_lamp, lamp.axis);
    if (lamp.is_area()) {
      share *= std::fmax(0, cosine) * lamp.area;
    } else if (cosine < lamp.cos_inner) {
      // Smooth between the two cones.
      const double x = lamp.cos_inner > lamp.cos_outer
                           ? std::fmax(0, (cosine - lamp.cos_outer) / (lamp.cos_inner - lamp.cos_outer))
                           : 0;
      share *= x * x * (3 - 2 * x);
    }
  }
  light.irradiance = static_cast<float>(share) * lamp.strength;
  return light;
}

/// Those that shine: black ones are left out, and areas without any.
std::vector<Lamp> lamps_of(const Scene& scene);

}  // namespace sightline
