#pragma once
/// What is around and between the elements of a scene.

#include <cmath>
#include <filesystem>
#include <glm/vec2.hpp>
#include <numbers>
#include <optional>
#include <variant>

#include "sightline/texture/color.h"

namespace sightline {

/// A sky that changes with the sine of the height above the horizon, y up.
struct SkyGradient {
  Color zenith{0}, horizon{0};
  Color ground{0};  ///< Straight below.

  /// Toward a direction of unit length.
  Color toward(const Vec3d& direction) const {
    return mix(horizon, direction.y < 0 ? ground : zenith, std::fmin(1.0, std::fabs(direction.y)));
  }
};

/// An image of all directions: longitude from left to right, latitude from top (+y) to bottom.
struct SkyImage {
  std::filesystem::path image;
  double rotation = 0;  ///< Degrees, counter-clockwise as seen from above. At 0, -z is in the middle, +x right of it.

  /// Where a direction of any length but 0 is in the image, u to the right and v up; u is beyond 0 to 1 where turned.
  glm::dvec2 uv_of(const Vec3d& direction) const {
    using std::numbers::pi;
    return {0.5 + std::atan2(direction.x, -direction.z) / (2 * pi) + rotation / 360,
            std::atan2(std::hypot(direction.x, direction.z), -direction.y) / pi};
  }
};

/// What rays see that leave the scene: radiance that does not depend on where they start.
struct Surroundings {
  std::variant<Color, SkyGradient, SkyImage> background = Color(0);
  double intensity = 1;  ///< What the background's colors are multiplied by.
  bool lights = false;   ///< Surfaces are lit by it; otherwise it is only seen, directly and in mirrors and glass.
};

/// Light that comes from everywhere alike, in place of what surfaces send each other: of radiance `color`, so that a
/// white Lambert surface in it sends out `color`. Black is none.
struct Ambient {
  Color color{0};
  double occlusion_distance = 0;  ///< Surfaces closer than this shut it out; 0 for nothing does.
};

/// Of even density in all of space. Of what is seen through a length d, the share exp(-density d) is left, and the rest
/// is `color`; so what is infinitely far is the fog alone. Light on its way from lamps to surfaces is not dimmed.
struct Fog {
  double density = 0;  ///< Extinction per unit of length; 0 is none.
  Color color{0};
};

}  // namespace sightline
