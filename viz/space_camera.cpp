#include "viz/space_camera.h"

#include <vtkLight.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sightline::viz {
namespace {

double up_slope() { return std::tan(SpaceCamera::field_of_view * std::numbers::pi / 360); }

struct Range {
  double lo = 1e300, hi = -1e300;

  void extend(double x) { lo = std::min(lo, x), hi = std::max(hi, x); }
  double middle() const { return 0.5 * (lo + hi); }
};

void add_light(vtkRenderer& renderer, double x, double y, double z, double strength) {
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetIntensity(strength);
  renderer.AddLight(light);
}

}  // namespace

Axes axes_toward(double azimuth, double elevation) {
  azimuth *= std::numbers::pi / 180, elevation *= std::numbers::pi / 180;
  const Vec3d x(std::cos(azimuth), 0, -std::sin(azimuth));
  const Vec3d z(std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation));
  return {x, glm::cross(z, x), z};
}

std::optional<glm::dvec2> SpaceCamera::project(const Vec3d& p) const {
  const Vec3d q = p - eye;
  const double depth = -glm::dot(q, axes.z);
  if (!(depth > 0)) return std::nullopt;
  const double half = depth * up_slope();
  return glm::dvec2(glm::dot(q, axes.x) / (half * aspect), glm::dot(q, axes.y) / half);
}

double SpaceCamera::half_height_at(const Vec3d& p) const { return -glm::dot(p - eye, axes.z) * up_slope(); }

void SpaceCamera::aim(vtkCamera& camera) const {
  camera.SetViewAngle(field_of_view);
  camera.SetFocalPoint(focus.x, focus.y, focus.z);
  camera.SetPosition(eye.x, eye.y, eye.z);
  camera.SetViewUp(axes.y.x, axes.y.y, axes.y.z);
}

SpaceCamera fit_camera(const Axes& axes, std::span<const Vec3d> points, double aspect, double zoom) {
  const double right_slope = up_slope() * aspect;
  Vec3d lo(1e300), hi(-1e300);
  for (const Vec3d& p : points) lo = glm::min(lo, p), hi = glm::max(hi, p);
  // From the origin, what is far from it would be drawn small: the margin is a share of the distance.
  Vec3d middle = points.empty() ? Vec3d(0) : 0.5 * (lo + hi);
  double distance = 1;
  for (int round = 0; round < 4; ++round) {
    distance = 0;
    Range across, upward;
    for (const Vec3d& p : points) {
      const Vec3d q = p - middle;
      distance = std::max({distance, glm::dot(q, axes.z) + std::fabs(glm::dot(q, axes.x)) / right_slope,
                           glm::dot(q, axes.z) + std::fabs(glm::dot(q, axes.y)) / up_slope()});
    }
    for (const Vec3d& p : points) {
      const Vec3d q = p - middle;
      const double depth = std::max(distance - glm::dot(q, axes.z), 1e-3 * distance);
      across.extend(glm::dot(q, axes.x) / depth * distance);
      upward.extend(glm::dot(q, axes.y) / depth * distance);
    }
    if (points.empty()) break;
    middle += across.middle() * axes.x + upward.middle() * axes.y;
  }
  return {axes, middle + (distance > 0 ? 1.04 * distance / zoom : 1) * axes.z, middle, aspect};
}

void light_space(vtkRenderer& renderer) {
  renderer.AutomaticLightCreationOff();
  add_light(renderer, -0.6, 0.9, 1, 0.75);
  add_light(renderer, 0.8, 0.1, 1, 0.3);
}

}  // namespace sightline::viz
