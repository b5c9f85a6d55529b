#pragma once
/// Cameras of pictures in space: chosen by two angles, as close as everything fits.

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <glm/vec2.hpp>
#include <optional>
#include <span>

#include "sightline/math/vec.h"

namespace sightline::viz {

/// A camera's directions: x right, y up, z toward the eye; of unit length.
struct Axes {
  Vec3d x, y, z;
};

/// `azimuth` degrees to the right of the front (+z), `elevation` degrees above the horizon.
Axes axes_toward(double azimuth, double elevation);

struct SpaceCamera {
  static constexpr double field_of_view = 30;  ///< Vertical, in degrees.

  Axes axes;
  Vec3d eye, focus;
  double aspect = 1;  ///< Width over height.

  /// From -1 (left, bottom) to 1; nothing behind the eye.
  std::optional<glm::dvec2> project(const Vec3d& p) const;
  /// What half of the picture's height is at the depth of a point.
  double half_height_at(const Vec3d& p) const;

  void aim(vtkCamera& camera) const;
};

/// As close as all `points` fit, and these in the middle; `zoom` times nearer.
SpaceCamera fit_camera(const Axes& axes, std::span<const Vec3d> points, double aspect, double zoom);

/// Two lights that go with the camera.
void light_space(vtkRenderer& renderer);

}  // namespace sightline::viz
