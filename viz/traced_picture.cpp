#include "viz/traced_picture.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>

namespace sightline::viz {
namespace {

/// Normals at vertices, each the sum of its triangles' normals by area; not normalized.
std::vector<Vec3d> vertex_normals(const TriangleMesh& mesh) {
  std::vector<Vec3d> normals(mesh.positions().size(), Vec3d(0));
  for (std::uint32_t id = 0; id < mesh.size(); ++id) {
    const auto [a, b, c] = mesh[id];
    const Vec3d normal = glm::cross(Vec3d(b) - Vec3d(a), Vec3d(c) - Vec3d(a));
    for (const std::uint32_t corner : mesh.triangles()[id]) normals[corner] += normal;
  }
  return normals;
}

Vec3d unit(const Vec3d& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : Vec3d(0, 0, 1);
}

/// Linear light of white clay whose surface faces `normal`, seen along `view`.
Vec3d clay(const Vec3d& normal, const Vec3d& view, const Camera& camera) {
  const Vec3d right = unit(camera.right), up = unit(camera.up);
  const Vec3d key = unit(-0.6 * right + 0.8 * up - 0.9 * camera.forward);
  const Vec3d fill = unit(0.9 * right + 0.1 * up - 0.5 * camera.forward);
  const double sky = 0.5 + 0.5 * normal.y;
  const double edge = std::pow(1 - std::fmin(1, std::fabs(glm::dot(normal, view))), 3);
  Vec3d light = Vec3d(0.045, 0.06, 0.085) * sky + Vec3d(0.03, 0.02, 0.015) * (1 - sky);
  light += Vec3d(0.66, 0.52, 0.36) * std::fmax(0, glm::dot(normal, key));
  light += Vec3d(0.05, 0.08, 0.13) * std::fmax(0, glm::dot(normal, fill));
  return light + Vec3d(0.10, 0.13, 0.16) * edge;
}

}  // namespace

TracedPicture trace_picture(const Tracer& tracer, const Camera& camera) {
  const auto pixels = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  TracedPicture picture{std::vector<Hit<float>>(pixels), std::vector<std::uint32_t>(pixels),
                        std::vector<std::uint32_t>(pixels)};
  tbb::parallel_for(0, camera.height, [&](int y) {
    for (int x = 0; x < camera.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * camera.width + x;
      const Ray<float> ray = camera.ray(x, y);
      TraversalStats stats;
      tracer.closest_hits(std::span(&ray, 1), std::span(&picture.hits[pixel], 1), stats);
      picture.work[pixel] = static_cast<std::uint32_t>(stats.nodes + stats.leaves + stats.candidates);
      picture.candidates[pixel] = static_cast<std::uint32_t>(stats.candidates);
    }
  });
  return picture;
}

Image shaded_picture(const TriangleMesh& mesh, const Camera& camera, const std::vector<Hit<float>>& hits) {
  const std::vector<Vec3d> normals = vertex_normals(mesh);
  Image image{camera.width, camera.height, 3, {}};
  image.pixels.reserve(hits.size() * 3);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Hit<float>& hit = hits[static_cast<std::size_t>(y) * camera.width + x];
      Vec3d light = Vec3d(0.80, 0.85, 0.90) - Vec3d(0.25, 0.24, 0.22) * (double(y) / camera.height);
      if (hit.is_hit()) {
        const Vec3d view = unit(Vec3d(camera.ray(x, y).direction));
        const auto [a, b, c] = mesh.triangles()[hit.prim_id];
        const double u = hit.u, v = hit.v;
        Vec3d normal = unit((1 - u - v) * normals[a] + u * normals[b] + v * normals[c]);
        if (glm::dot(normal, view) > 0) normal = -normal;
        light = clay(normal, view, camera);
      }
      for (int channel = 0; channel < 3; ++channel) image.pixels.push_back(static_cast<float>(light[channel]));
    }
  }
  return image;
}

Agreement compare_with(const Tracer& oracle, const Camera& camera, const std::vector<Hit<float>>& hits, int stride) {
  std::atomic<std::size_t> compared = 0, differing = 0;
  const int rows = (camera.height + stride - 1) / stride;
  tbb::parallel_for(0, rows, [&](int row) {
    const int y = row * stride;
    for (int x = 0; x < camera.width; x += stride) {
      const Ray<float> ray = camera.ray(x, y);
      Hit<float> hit;
      oracle.closest_hits(std::span(&ray, 1), std::span(&hit, 1));
      ++compared;
      if (hit != hits[static_cast<std::size_t>(y) * camera.width + x]) ++differing;
    }
  });
  return {compared, differing};
}

}  // namespace sightline::viz
