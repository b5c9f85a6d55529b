#include "sightline/query/workloads.h"

#include <cmath>
#include <numbers>

#include "sightline/math/random.h"

namespace sightline {
namespace {

Vec3d point_in(const Vec3d& lo, const Vec3d& hi, Random& random) {
  const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
  return lo + Vec3d(x, y, z) * (hi - lo);
}

/// Uniform on the unit sphere (Archimedes: height and angle are independent).
Vec3d unit_vector(Random& random) {
  const double z = 2 * random.uniform_double() - 1, angle = 2 * std::numbers::pi * random.uniform_double();
  const double radius = std::sqrt(1 - z * z);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

struct SurfacePoint {
  Vec3d position;
  Vec3d normal;  ///< Of unit length, on the side that the ray came from; zero for a triangle without area.
};

SurfacePoint surface_point(const TriangleMesh& mesh, const Ray<float>& ray, const Hit<float>& hit) {
  const Triangle triangle = mesh[hit.prim_id];
  const Vec3d a(triangle.a), b(triangle.b), c(triangle.c);
  const Vec3d normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  const double side = glm::dot(normal, Vec3d(ray.direction)) > 0 ? -1 : 1;
  return {a + double(hit.u) * (b - a) + double(hit.v) * (c - a), length > 0 ? normal * (side / length) : Vec3d(0)};
}

/// The point rounded to float and lifted off its surface by twice what that rounding can lower it.
Vec3f lifted(const SurfacePoint& point) {
  const double rounding = glm::dot(glm::abs(point.normal), glm::abs(point.position)) * 0x1p-24;
  return Vec3f(point.position + (2 * rounding) * point.normal);
}

}  // namespace

std::vector<Ray<float>> random_rays(const Aabb& bounds, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const Vec3d half = 0.5 * (Vec3d(bounds.hi) - Vec3d(bounds.lo));
  const Vec3d lo = Vec3d(bounds.lo) - half, hi = Vec3d(bounds.hi) + half;
  std::vector<Ray<float>> rays(count);
  for (Ray<float>& ray : rays) {
    const Vec3d from = point_in(lo, hi, random), to = point_in(lo, hi, random);
    ray.origin = Vec3f(from);
    ray.direction = Vec3f(to - from);
  }
  return rays;
}

std::vector<Ray<float>> edge_rays(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed) {
  if (mesh.size() == 0) return {};
  Random random(seed);
  const Vec3d center = 0.5 * (Vec3d(mesh.bounds().lo) + Vec3d(mesh.bounds().hi));
  const double distance = glm::length(Vec3d(mesh.bounds().hi) - Vec3d(mesh.bounds().lo));
  std::vector<Ray<float>> rays(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& corners = mesh.triangles()[random.next() % mesh.size()];
    const std::size_t side = random.next() % 3;
    const Vec3d from(mesh.positions()[corners[side]]), to(mesh.positions()[corners[(side + 1) % 3]]);
    const double share = i % 4 == 0 ? 0 : random.uniform_double();
    rays[i].origin = Vec3f(center + distance * unit_vector(random));
    rays[i].direction = Vec3f(from + share * (to - from) - Vec3d(rays[i].origin));
  }
  return rays;
}

std::vector<Ray<float>> bounce_rays(const TriangleMesh& mesh, std::span<const Ray<float>> rays,
                                    std::span<const Hit<float>> hits, std::uint64_t seed) {
  Random random(seed);
  std::vector<Ray<float>> bounced;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!hits[i].is_hit()) continue;
    const SurfacePoint point = surface_point(mesh, rays[i], hits[i]);
    // A unit vector around the tip of the normal is cosine distributed.
    const Vec3d direction = point.normal + unit_vector(random);
    bounced.push_back({lifted(point), Vec3f(direction)});
  }
  return bounced;
}

std::vector<Ray<float>> shadow_rays(const TriangleMesh& mesh, std::span<const Ray<float>> rays,
                                    std::span<const Hit<float>> hits, const Vec3f& light) {
  std::vector<Ray<float>> shadows;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!hits[i].is_hit()) continue;
    const SurfacePoint point = surface_point(mesh, rays[i], hits[i]);
    if (!(glm::dot(point.normal, Vec3d(light) - point.position) > 0)) continue;
    const Vec3f origin = lifted(point);
    shadows.push_back({origin, light - origin, 0, 1});
  }
  return shadows;
}

}  // namespace sightline
