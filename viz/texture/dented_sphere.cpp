#include "viz/texture/dented_sphere.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "sightline/shape/mesh_builder.h"
#include "sightline/texture/normal_map.h"

namespace sightline::viz {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Linear light of clay that faces `n`, seen along -z.
Vec3d clay(const Vec3d& n) {
  const Vec3d key = glm::normalize(Vec3d(-0.6, 0.7, 0.75)), fill = glm::normalize(Vec3d(0.9, -0.1, 0.4));
  const double sky = 0.5 + 0.5 * n.y;
  return Vec3d(0.05, 0.065, 0.09) * sky + Vec3d(0.03, 0.02, 0.015) * (1 - sky) +
         Vec3d(0.72, 0.56, 0.38) * std::fmax(0, glm::dot(n, key)) +
         Vec3d(0.06, 0.09, 0.13) * std::fmax(0, glm::dot(n, fill));
}

/// The six faces of a cube, each a grid, blown up to the sphere and moved by the heights.
std::shared_ptr<const TriangleMesh> displaced_mesh(const Dents& dents, int divisions) {
  MeshBuilder builder;
  const auto count = static_cast<std::size_t>(divisions) + 1;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, next = (axis + 1) % 3, last = (axis + 2) % 3;
    const double side = face % 2 == 0 ? 1 : -1;
    std::vector<std::uint32_t> vertices;
    for (std::size_t j = 0; j < count; ++j) {
      for (std::size_t i = 0; i < count; ++i) {
        Vec3d p;
        p[axis] = side;
        p[next] = side * std::tan((2.0 * static_cast<double>(i) / divisions - 1) * 0.7853981633974483);
        p[last] = std::tan((2.0 * static_cast<double>(j) / divisions - 1) * 0.7853981633974483);
        p = glm::normalize(p);
        vertices.push_back(builder.vertex(Vec3f((1 + dents.at(p).value) * p)));
      }
    }
    for (std::size_t j = 0; j + 1 < count; ++j) {
      for (std::size_t i = 0; i + 1 < count; ++i) {
        const std::uint32_t a = vertices[j * count + i], b = vertices[j * count + i + 1],
                            c = vertices[(j + 1) * count + i + 1], d = vertices[(j + 1) * count + i];
        builder.triangle(a, b, c);
        builder.triangle(a, c, d);
      }
    }
  }
  return std::make_shared<const TriangleMesh>(builder.take());
}

/// Where a pixel's ray meets the surface, as a direction from the center; none where it does not.
struct Surface {
  bool is_met = false;
  Vec3d direction{0, 0, 1};
};

}  // namespace

NoiseSample<double, 3> Dents::at(const Vec3d& p) const {
  const auto sample = field.sample<3, double>(p);
  return {amplitude * sample.value, amplitude * sample.gradient};
}

DentedSphere dented_sphere(DentKind kind, const Dents& dents, int size, double reach, int divisions) {
  DentedSphere sphere;
  sphere.shaded.width = sphere.shaded.height = size;
  const auto pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  sphere.is_covered.assign(pixels, 0);
  sphere.shaded.bytes.assign(3 * pixels, 255);

  std::unique_ptr<Tracer> tracer;
  auto begin = Clock::now();
  if (kind == DentKind::displaced) {
    const auto mesh = displaced_mesh(dents, divisions);
    tracer = make_tracer("wide-tree", mesh);
    sphere.build_seconds = seconds_since(begin);
    sphere.triangles = mesh->size();
    sphere.bytes = tracer->structure_bytes() + tracer->leaf_bytes() + mesh->positions().size() * sizeof(Vec3f) +
                   mesh->size() * sizeof(TriangleMesh::Corners);
  }
  TraversalStats stats;
  const auto surface_at = [&](double x, double y, bool counts) -> Surface {
    if (tracer) {
      const Ray<float> ray{Vec3f(Vec3d(x, y, 4)), Vec3f(0, 0, -1)};
      Hit<float> hit;
      if (counts) {
        tracer->closest_hits(std::span(&ray, 1), std::span(&hit, 1), stats);
      } else {
        tracer->closest_hits(std::span(&ray, 1), std::span(&hit, 1));
      }
      if (!hit.is_hit()) return {};
      return {true, glm::normalize(Vec3d(x, y, 4 - double(hit.t)))};
    }
    const double z2 = 1 - x * x - y * y;
    if (z2 < 0) return {};
    return {true, {x, y, std::sqrt(z2)}};
  };
  const auto coordinate = [&](int i) { return ((i + 0.5) / size * 2 - 1) * reach; };
  const auto paint = [&](bool counts) {
    std::size_t at = 0;
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column, ++at) {
        const Surface surface = surface_at(coordinate(column), -coordinate(row), counts);
        if (!surface.is_met) continue;
        Vec3d n = surface.direction;
        if (kind != DentKind::none) {
          const auto dent = dents.at(n);
          // Of the surface at distance 1 + h from the center, or of one that is taken for it.
          n = dented_normal(n, dent.gradient, 1 / (1 + dent.value));
        }
        sphere.is_covered[at] = 1;
        const Vec3d light = clay(facing_normal(n, surface.direction, {0, 0, 1}));
        for (int channel = 0; channel < 3; ++channel) {
          sphere.shaded.bytes[3 * at + static_cast<std::size_t>(channel)] =
              static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(light[channel])));
        }
      }
    }
  };
  paint(true);
  const auto covered = static_cast<double>(std::count(sphere.is_covered.begin(), sphere.is_covered.end(), 1));
  begin = Clock::now();
  paint(false);
  sphere.nanoseconds = 1e9 * seconds_since(begin) / covered;
  sphere.nodes = static_cast<double>(stats.nodes) / covered;
  sphere.candidates = static_cast<double>(stats.candidates) / covered;
  sphere.noise_samples = kind == DentKind::none ? 0 : static_cast<double>(dents.field.octaves_within(0));
  return sphere;
}

}  // namespace sightline::viz
