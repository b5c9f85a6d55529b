#include "viz/web/web_camera.h"

#include "viz/space_camera.h"

namespace sightline::viz {

WebCamera web_camera(const Aabb& bounds, const View& view) {
  const Axes axes = axes_toward(view.azimuth.value_or(24), view.elevation.value_or(20));
  std::vector<Vec3d> corners;
  for (const Vec3f& p : hull_of(bounds).points) corners.emplace_back(p);
  const SpaceCamera fitted = fit_camera(axes, corners, double(view.width) / view.height, view.zoom);
  // What the view turns around is as far away as the middle of the scene.
  const Vec3d middle = 0.5 * (Vec3d(bounds.lo) + Vec3d(bounds.hi));
  const Vec3d focus = fitted.focus + glm::dot(middle - fitted.focus, axes.z) * axes.z;
  return {Camera::looking_at(fitted.eye, focus, axes.y, SpaceCamera::field_of_view, view.width, view.height), focus};
}

}  // namespace sightline::viz
