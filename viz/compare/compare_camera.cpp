#include "viz/compare/compare_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viz/walk/walk_model.h"

namespace sightline::viz {

SpaceCamera camera_for(const TriangleMesh& mesh, const CompareLook& look, double aspect) {
  const Vec3d lo(mesh.bounds().lo), hi(mesh.bounds().hi);
  std::vector<Vec3d> corners;
  for (int corner = 0; corner < 8 && !mesh.bounds().is_empty(); ++corner) {
    corners.emplace_back(corner & 1 ? hi.x : lo.x, corner & 2 ? hi.y : lo.y, corner & 4 ? hi.z : lo.z);
  }
  return fit_camera(axes_toward(look.azimuth, look.elevation), corners, aspect, look.zoom);
}

Camera tracing_camera(const SpaceCamera& camera, int width, int height) {
  const double half_height = std::tan(SpaceCamera::field_of_view * std::numbers::pi / 360);
  return {camera.eye, -camera.axes.z, half_height * camera.aspect * camera.axes.x, half_height * camera.axes.y,
          width,      height};
}

Ray<float> ray_across(const Tracer& tracer) {
  const Aabb bounds = tracer.mesh().bounds();
  if (bounds.is_empty()) return {{-2, 0, 0}, {1, 0, 0}};
  const Vec3d lo(bounds.lo), size = Vec3d(bounds.hi) - lo;
  const double length = std::max(max_norm(size), 1e-30);
  std::optional<Ray<float>> best;
  float farthest = 0;
  for (const double up : {0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3}) {
    for (const double deep : {0.56, 0.46, 0.66, 0.36, 0.76}) {
      const Vec3d from = lo + Vec3d(-0.16 * length, up * size.y, deep * size.z);
      const Vec3d to = lo + Vec3d(size.x, (up - 0.24) * size.y, (deep - 0.1) * size.z);
      const Ray<float> ray{Vec3f(from), Vec3f(to - from)};
      Hit<float> hit;
      tracer.closest_hits(std::span(&ray, 1), std::span(&hit, 1));
      if (!best || (hit.is_hit() && hit.t > farthest)) {
        best = ray;
        farthest = hit.is_hit() ? hit.t : 0;
      }
    }
  }
  return farthest > 0 ? *best : usual_ray(tracer);
}

}  // namespace sightline::viz
