/// What becomes of a watertight test where compilers contract a * b - c * d.

#include <cmath>
#include <memory>

#include "sightline/math/random.h"
#include "sightline/query/tracer.h"
#include "sightline/shape/mesh_builder.h"
#include "tests/hard_cases/build_parts.h"
#include "tests/hard_cases/random_vectors.h"

namespace sightline::hard {
namespace {

/// A closed sphere of triangles around (0, 0, 0).
std::shared_ptr<const TriangleMesh> ball() {
  constexpr int rings = 10, sectors = 20;
  MeshBuilder builder;
  const auto at = [&](int ring, int sector) {
    const double theta = 3.14159265358979 * ring / rings, phi = 2 * 3.14159265358979 * (sector % sectors) / sectors;
    if (ring == 0 || ring == rings) return Vec3f(0, 0, ring == 0 ? 1 : -1);
    return Vec3f(Vec3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)));
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      const Vec3f a = at(ring, sector), b = at(ring + 1, sector), c = at(ring + 1, sector + 1),
                  d = at(ring, sector + 1);
      if (ring + 1 < rings) builder.triangle(a, b, c);
      if (ring > 0) builder.triangle(a, c, d);
    }
  }
  return std::make_shared<const TriangleMesh>(builder.take());
}

/// a b - c d as this build compiles it; if that is contracted, the case fails.
struct AsCompiled {
  float operator()(float a, float b, float c, float d) const { return a * b - c * d; }
};
/// As compilers contract it that are not told otherwise: one of the products is not rounded.
struct Contracted {
  float operator()(float a, float b, float c, float d) const { return std::fma(a, b, -(c * d)); }
};

/// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013: edges that two triangles share have opposite
/// signs in these, because swapping the products negates their difference.
template <class Difference>
bool hits(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Ray<float>& ray) {
  constexpr Difference difference;
  const Vec3f size = glm::abs(ray.direction);
  const int z = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2, x = (z + 1) % 3, y = (z + 2) % 3;
  const float shear_x = ray.direction[x] / ray.direction[z], shear_y = ray.direction[y] / ray.direction[z];
  glm::vec2 p[3];
  float depth[3];
  for (int i = 0; i < 3; ++i) {
    const Vec3f v = (i == 0 ? a : i == 1 ? b : c) - ray.origin;
    p[i] = {v[x] - shear_x * v[z], v[y] - shear_y * v[z]};
    depth[i] = v[z] / ray.direction[z];
  }
  float edge[3];
  for (int i = 0; i < 3; ++i) {
    const glm::vec2 &from = p[(i + 1) % 3], &to = p[(i + 2) % 3];
    edge[i] = difference(to.x, from.y, to.y, from.x);
    if (edge[i] == 0) edge[i] = static_cast<float>(double(to.x) * from.y - double(to.y) * from.x);
  }
  const bool is_below = edge[0] < 0 || edge[1] < 0 || edge[2]<0, is_above = edge[0]> 0 || edge[1] > 0 || edge[2] > 0;
  if (is_below == is_above) return false;
  const float sum = edge[0] + edge[1] + edge[2];
  return (edge[0] * depth[0] + edge[1] * depth[1] + edge[2] * depth[2]) * sum > 0;
}

template <class Difference>
bool hits_any(const TriangleMesh& mesh, const Ray<float>& ray) {
  for (const auto& [a, b, c] : mesh.triangles()) {
    const auto& v = mesh.positions();
    if (hits<Difference>(v[a], v[b], v[c], ray)) return true;
  }
  return false;
}

/// From within, at points of edges, as near as floats come.
std::vector<Ray<float>> rays_at_edges(const TriangleMesh& mesh, std::uint64_t count) {
  Random random(41);
  std::vector<Ray<float>> rays;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto& corners = mesh.triangles()[random.below(static_cast<std::uint32_t>(mesh.triangles().size()))];
    const std::uint32_t k = random.below(3);
    const Vec3f &a = mesh.positions()[corners[k]], &b = mesh.positions()[corners[(k + 1) % 3]];
    const Vec3f origin(0.5 * random_in_cube(random)), target = a + random.uniform() * (b - a);
    rays.push_back({origin, target - origin});
  }
  return rays;
}

void judge(Tally& tally, const Ray<float>& ray, bool is_hit) {
  tally.decide(is_hit, [&] {
    return Example{vector_text(Vec3d(ray.origin)) + " -> " + vector_text(Vec3d(ray.direction)),
                   "hit: the ray starts inside a closed mesh", is_hit ? "hit" : "miss"};
  });
}

void run_contraction(Trial& trial) {
  const auto mesh = ball();
  const std::vector<Ray<float>> rays = rays_at_edges(*mesh, trial.count(20000));
  const std::vector<Ray<double>> wide = [&] {
    std::vector<Ray<double>> widened;
    for (const Ray<float>& ray : rays) widened.push_back({Vec3d(ray.origin), Vec3d(ray.direction)});
    return widened;
  }();
  std::vector<std::uint8_t> is_hit(rays.size());
  for (const AcceleratorInfo& info : accelerator_infos()) {
    const auto tracer = make_tracer(info.name, mesh);
    const auto judge_all = [&](Level level) {
      Tally& tally = trial.of(info.name, level);
      for (std::size_t i = 0; i < rays.size(); ++i) judge(tally, rays[i], is_hit[i]);
    };
    for (const Level level : triangle_levels) {
      tracer->any_hits(rays, is_hit, level);
      judge_all(level);
    }
    tracer->any_hits(wide, is_hit);
    for (const Level level : {Level::precise, Level::exact}) judge_all(level);
  }
  for (const Ray<float>& ray : rays) {
    judge(trial.of("Woop's test, as this build compiles it"), ray, hits_any<AsCompiled>(*mesh, ray));
    judge(trial.naive("Woop's test in float, contracted"), ray, hits_any<Contracted>(*mesh, ray));
  }
}

Sketch draw_contraction() {
  Sketch sketch{"Two triangles that share an edge, and a ray that comes through it, seen along the ray.", {}};
  return sketch.polygon({{-3, 0}, {0, -2}, {1, 2}})
      .polygon({{0, -2}, {3, 0.5}, {1, 2}})
      .dot({0.5, 0})
      .label({0.7, 0}, "on which side of the edge?")
      .label({-3, -2.5}, "to the left: a b - [c d] = -3e-9", Role::naive)
      .label({0.8, -2.5}, "to the right: c d - [a b] = -2e-9", Role::naive)
      .label({-3, 2.4}, "rounded alike, one is the other's negative", Role::truth);
}

}  // namespace

HardCase build_contraction() {
  return {
      .id = "fp-contract",
      .group = "build",
      .inputs = "a closed sphere of 360 triangles; 20000 rays of float from within it, at random points of its edges",
      .expected = "each ray hits: the mesh has no holes",
      .why =
          "a b - c d is negated exactly when the products are swapped, and a watertight test lives on that: what is "
          "left of "
          "an edge for one triangle is right of it for the other. GCC contracts it to a fused multiply-add by "
          "default, which rounds one product only, and both triangles may say no.",
      .oracle = Oracle::closed_form,
      .reference = "geogram, issue 382; boost.geometry, issues 702 and 1453; Woop, Benthin and Wald, 2013",
      .run = run_contraction,
      .draw = draw_contraction};
}

}  // namespace sightline::hard
