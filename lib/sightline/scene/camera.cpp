#include "sightline/scene/camera.h"

#include <cmath>
#include <numbers>

namespace sightline {
namespace {

/// Of unit length, as `forward` is, and at right angles to it. Where that is along y_up the horizon is free: then as
/// close to an axis as may be.
Vec3d to_the_right(const Vec3d& forward, const Vec3d& y_up) {
  const double size = max_norm(y_up);
  const auto across = [&](const Vec3d& v) { return v - glm::dot(v, forward) * forward; };
  Vec3d side = glm::cross(forward, y_up);
  if (max_norm(side) <= 0x1p-20 * size) {
    // The product's rounding, up to 2^-51, is no longer small beside it, and leads away from right angles.
    side = size > 0 ? across(across(glm::cross(forward, y_up / size))) : Vec3d(0);
    if (!(max_norm(side) > 0x1p-50)) {
      const Vec3d a = glm::abs(forward);
      side = Vec3d(0);
      side[a.x <= a.y && a.x <= a.z ? 0 : a.y <= a.z ? 1 : 2] = 1;
      side = across(side);
    }
  }
  return glm::normalize(side / max_norm(side));
}

}  // namespace

Camera Camera::looking_at(const Vec3d& eye, const Vec3d& target, const Vec3d& y_up, double field_of_view, int width,
                          int height) {
  Camera camera;
  camera.eye = eye;
  camera.width = width;
  camera.height = height;
  camera.forward = glm::normalize(target - eye);
  camera.right = to_the_right(camera.forward, y_up);
  const double half_height = std::tan(field_of_view * std::numbers::pi / 360);
  camera.up = glm::cross(camera.right, camera.forward) * half_height;
  camera.right *= half_height * width / height;
  return camera;
}

Camera Camera::facing(const Aabb& bounds, int width, int height) {
  constexpr double field_of_view = 35;
  const Vec3d lo(bounds.lo), hi(bounds.hi);
  const Vec3d center = 0.5 * lo + 0.5 * hi;
  const double radius = 0.5 * glm::length(hi - lo);
  const double half_angle = field_of_view * std::numbers::pi / 360;
  const double narrow_half_angle = std::atan(std::tan(half_angle) * std::fmin(1.0, double(width) / height));
  const double distance = radius > 0 ? 0.85 * radius / std::sin(narrow_half_angle) : 1;
  const Vec3d toward_eye = glm::normalize(Vec3d(0.45, 0.35, 1));
  return looking_at(center + distance * toward_eye, center, {0, 1, 0}, field_of_view, width, height);
}

Ray<float> Camera::ray(int x, int y) const {
  const double across = (2 * x + 1 - width) / double(width);
  const double upward = (height - 2 * y - 1) / double(height);
  Ray<float> ray;
  ray.origin = Vec3f(eye);
  ray.direction = Vec3f(glm::normalize(forward + across * right + upward * up));
  return ray;
}

std::vector<Ray<float>> primary_rays(const Camera& camera) {
  std::vector<Ray<float>> rays;
  rays.reserve(std::size_t(camera.width) * camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) rays.push_back(camera.ray(x, y));
  }
  return rays;
}

}  // namespace sightline
