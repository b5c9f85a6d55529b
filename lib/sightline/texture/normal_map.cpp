#include "sightline/texture/normal_map.h"

#include <algorithm>
#include <cmath>

namespace sightline {
namespace {

Vec3d unit_or(Vec3d v, const Vec3d& otherwise) { return normalize_safely(v) ? v : otherwise; }

}  // namespace

Vec3d decode_normal(const Color& color, double strength) {
  const Vec3d n = 2.0 * Vec3d(color) - 1.0;
  return unit_or({strength * n.x, strength * n.y, std::max(n.z, 0.0)}, Vec3d(0, 0, 1));
}

Vec3d decode_normal_xy(double x, double y, double strength) {
  const double nx = 2 * x - 1, ny = 2 * y - 1;
  return unit_or({strength * nx, strength * ny, std::sqrt(std::max(0.0, 1 - (nx * nx + ny * ny)))}, Vec3d(0, 0, 1));
}

Vec3d dented_normal(const Vec3d& n, const Vec3d& du, const Vec3d& dv, const glm::dvec2& slope) {
  // The surface's gradient of the height; the determinant's sign is that of mirrored (u, v).
  const double area = glm::dot(n, glm::cross(du, dv));
  if (area == 0) return n;
  return dented_normal(n, (slope.x * glm::cross(dv, n) + slope.y * glm::cross(n, du)) / area);
}

Vec3d dented_normal(const Vec3d& n, const Vec3d& gradient, double strength) {
  return unit_or(n - strength * (gradient - glm::dot(gradient, n) * n), n);
}

glm::dvec2 height_slope(const ImageTexture& heights, const glm::dvec2& uv, const UvFootprint& footprint) {
  const auto step = [](double right, double below, int texels) {
    return std::clamp(std::fabs(right) + std::fabs(below), 1.0 / texels, 0.5);
  };
  const double du = step(footprint.right.x, footprint.below.x, heights.width());
  const double dv = step(footprint.right.y, footprint.below.y, heights.height());
  const auto height = [&](double u, double v) { return static_cast<double>(heights(glm::dvec2(u, v), footprint).x); };
  return {(height(uv.x + du / 2, uv.y) - height(uv.x - du / 2, uv.y)) / du,
          (height(uv.x, uv.y + dv / 2) - height(uv.x, uv.y - dv / 2)) / dv};
}

Vec3d facing_normal(const Vec3d& n, const Vec3d& geometric, const Vec3d& to_viewer) {
  Vec3d viewer = to_viewer, flat = geometric, shading = n;
  if (!normalize_safely(viewer)) return n;
  if (glm::dot(flat, viewer) < 0) flat = -flat, shading = -shading;  // N1
  const double cosine = glm::dot(shading, to_viewer);
  if (cosine > 0) return shading;                                                           // N2
  const Vec3d reflected = unit_or(shading - 2 * glm::dot(shading, viewer) * viewer, flat);  // N3
  if (glm::dot(reflected, to_viewer) > 0) return reflected;
  return glm::dot(flat, to_viewer) > 0 ? flat : viewer;  // N4
}

}  // namespace sightline
