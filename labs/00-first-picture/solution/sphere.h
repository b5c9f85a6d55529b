#pragma once
/// Lab 00: a ray, a sphere, a picture.

#include "sightline/math/ray.h"

namespace student {

using namespace sightline;

struct Ball {
  Vec3d center{0};
  double radius = 1;
};

/// The ray from (0, 0, 0) through the middle of pixel (x, y) of a picture of this size; (0, 0) is the pixel at the top
/// left. The picture hangs at z = -1, is as wide as 2 width / height and reaches from y = -1 at its bottom to y = 1 at
/// its top. The direction is not normalized: its z is -1.
inline Ray<double> camera_ray(int x, int y, int width, int height) {
  Ray<double> ray;
  // lab:hole camera_ray | 1. A ray through a pixel
  const double across = 2 * (x + 0.5) / height - double(width) / height;
  const double up = 1 - 2 * (y + 0.5) / height;
  ray.direction = {across, up, -1};
  // lab:end
  return ray;
}

/// The smallest t with t_min < t <= t_max at which the ray is on the ball's surface; nothing where there is none. A ray
/// that only touches the ball does hit it. The ray's direction has any length but 0.
inline std::optional<double> hit_sphere(const Ray<double>& ray, const Ball& ball) {
  // lab:hole hit_sphere | 2. Where a ray meets a sphere
  // |o + t d - c|^2 = r^2 is a t^2 + 2 b t + c = 0.
  const Vec3d from_center = ray.origin - ball.center;
  const double a = glm::dot(ray.direction, ray.direction);
  const double b = glm::dot(from_center, ray.direction);
  const double c = glm::dot(from_center, from_center) - ball.radius * ball.radius;
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  // The root in which nothing cancels first; the other one from the product of both, c / a.
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  double near = q / a, far = q == 0 ? near : c / q;
  if (near > far) std::swap(near, far);
  for (const double t : {near, far}) {
    if (t > ray.t_min && t <= ray.t_max) return t;
  }
  return std::nullopt;
  // lab:end
}

/// Of unit length, away from the center, at a point of the surface.
inline Vec3d normal_at(const Ball& ball, const Vec3d& point) {
  // lab:hole normal_at | 3. Which way a surface faces
  return glm::normalize(point - ball.center);
  // lab:end
}

/// How bright a surface is: the cosine of the angle between its normal and the way to the light, and 0 where it faces
/// away. Both have unit length.
inline double shade(const Vec3d& normal, const Vec3d& to_light) {
  // lab:hole shade | 4. Light
  return std::max(0.0, glm::dot(normal, to_light));
  // lab:end
}

/// What the picture shows.
inline constexpr Ball balls[] = {
    {{0, 0, -3}, 1}, {{-1.6, -0.4, -4}, 0.7}, {{1.3, 0.5, -2.6}, 0.45}, {{0, -101, -3}, 100}};

/// The way to the light from every point, for it is as far as the sun; not of unit length.
inline constexpr Vec3d to_sun{0.5, 1, 0.7};

/// From 0 (black) to 1: how bright the nearest ball is where the pixel's ray meets it; nothing is met: 0.05.
inline double pixel(int x, int y, int width, int height) {
  // lab:hole pixel | 5. The nearest one
  Ray<double> ray = camera_ray(x, y, width, height);
  double brightness = 0.05;
  for (const Ball& ball : balls) {
    const std::optional<double> t = hit_sphere(ray, ball);
    if (!t) continue;
    ray.t_max = *t;  // what lies farther is no longer looked for
    brightness = shade(normal_at(ball, ray.at(*t)), glm::normalize(to_sun));
  }
  return brightness;
  // lab:end
}

}  // namespace student
