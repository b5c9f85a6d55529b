#include "viz/web/web_camera.h"

#include "viz/space_camera.h"

namespace sightline::viz {

WebCamera web_camera(const Aabb& bounds, const View& view) {
  const Axes axes = axes_toward(view.azimuth.value_or(24), view.elevation.value_or(20));
  std::vector<Vec3d> corners;
  for (const Vec3f& p : hull_of(bounds).points) corners.emplace_back(p);
  const SpaceCamera fitted = fit_camera(axes, corners, double(view.width) / view.height, view.zoom);
  return {Camera::looking_at(fitted.eye, fitted.focus, axes.y, SpaceCamera::field_of_view, view.width, view.height),
          fitted.focus};
}

}  // namespace sightline::viz
