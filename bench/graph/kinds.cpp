#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "bench/graph/run.h"
#include "bench/verify.h"
#include "sightline/math/random.h"
#include "sightline/query/tracer.h"
#include "sightline/scene/culling.h"
#include "sightline/scene/scenes.h"
#include "sightline/shape/instances.h"

namespace sightline::bench {
namespace {

constexpr std::size_t node_count = 400, ray_count = 1000, timed_rays = 100, view_count = 60;
constexpr double space = 10;  ///< Things are strewn from -space to space.

using Mesh = std::shared_ptr<const TriangleMesh>;

/// Rings of a ball, or of anything round.
Mesh ball(std::uint32_t around, std::uint32_t across) {
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> triangles;
  for (std::uint32_t i = 0; i <= across; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      const double down = std::numbers::pi * i / across, turn = 2 * std::numbers::pi * k / around;
      positions.emplace_back(std::sin(down) * std::cos(turn), std::sin(down) * std::sin(turn), std::cos(down));
    }
  }
  for (std::uint32_t i = 0; i < across; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      const std::uint32_t a = i * around + k, b = i * around + (k + 1) % around;
      triangles.push_back({a, a + around, b + around});
      triangles.push_back({a, b + around, b});
    }
  }
  return std::make_shared<const TriangleMesh>(std::move(positions), std::move(triangles));
}

Mesh box(const Vec3f& half) {
  std::vector<Vec3f> positions;
  for (int i = 0; i < 8; ++i) positions.push_back(half * Vec3f(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  return std::make_shared<const TriangleMesh>(std::move(positions), std::vector<TriangleMesh::Corners>{{0, 2, 1},
                                                                                                       {1, 2, 3},
                                                                                                       {4, 5, 6},
                                                                                                       {5, 7, 6},
                                                                                                       {0, 1, 4},
                                                                                                       {1, 5, 4},
                                                                                                       {2, 6, 3},
                                                                                                       {3, 6, 7},
                                                                                                       {0, 4, 2},
                                                                                                       {2, 4, 6},
                                                                                                       {1, 3, 5},
                                                                                                       {3, 7, 5}});
}

double volume_of(const TriangleMesh& mesh) {
  double six = 0;
  for (std::uint32_t i = 0; i < mesh.size(); ++i) {
    const Triangle t = mesh[i];
    six += glm::dot(Vec3d(t.a), glm::cross(Vec3d(t.b), Vec3d(t.c)));
  }
  return std::fabs(six) / 6;
}

/// Copies of a mesh in random places and directions, each as large as a ball of radius 0.6.
struct Field {
  std::string name;
  double thing_volume;  ///< Of one.
  LiveScene live;
  std::vector<Mesh> placed;  ///< By node - 1.
  std::vector<Ray<float>> rays;
  std::vector<Camera> cameras;
  std::vector<std::vector<bool>> hit, seen;  ///< By ray or camera, and node - 1.
};

Scene strewn(const Mesh& mesh, Random& random, double scale) {
  const auto number = [&] { return 2 * random.uniform_double() - 1; };
  const Vec3d middle(mesh->bounds().center());
  Scene scene;
  scene.geometries.push_back({"thing", MeshGeometry{mesh, {}, {}}});
  for (std::size_t i = 0; i < node_count; ++i) {
    const Transform place = Transform::translation(space * Vec3d(number(), number(), number())) *
                            Transform::rotation(Vec3d(number(), number(), number()), 360 * number()) *
                            Transform::scaling(Vec3d(scale)) * Transform::translation(-middle);
    scene.graph.set_geometry(scene.graph.add(root_node, "", place), 0);
  }
  return scene;
}

/// Whether anything of a triangle is clearly within a camera's picture: what clipping leaves of it has a corner there.
bool is_seen(const Triangle& triangle, const Camera& camera) {
  std::vector<Vec3d> polygon{Vec3d(triangle.a) - camera.eye, Vec3d(triangle.b) - camera.eye,
                             Vec3d(triangle.c) - camera.eye};
  const Vec3d &f = camera.forward, r = camera.right / glm::dot(camera.right, camera.right),
              u = camera.up / glm::dot(camera.up, camera.up);
  constexpr double inside = 1 - 0x1p-20;
  for (const Vec3d& normal : {inside * f + r, inside * f - r, inside * f + u, inside * f - u}) {
    std::vector<Vec3d> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double at_a = glm::dot(normal, a), at_b = glm::dot(normal, b);
      if (at_a >= 0) kept.push_back(a);
      if ((at_a >= 0) != (at_b >= 0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    polygon = std::move(kept);
  }
  return !polygon.empty();
}

std::shared_ptr<Field> make_field(const std::string& name, const Mesh& mesh) {
  Random random(7);
  const auto number = [&] { return 2 * random.uniform_double() - 1; };
  const double volume = volume_of(*mesh);
  const double scale = 0.6 * std::cbrt(4 * std::numbers::pi / 3 / volume);
  const auto field = std::make_shared<Field>(
      Field{name, volume * scale * scale * scale, LiveScene(strewn(mesh, random, scale)), {}, {}, {}, {}, {}});
  for (std::size_t i = 0; i < ray_count; ++i) {
    Ray<float> ray;
    ray.origin = Vec3f(2 * space * glm::normalize(Vec3d(number(), number(), number())));
    ray.direction = Vec3f(space * Vec3d(number(), number(), number())) - ray.origin;
    field->rays.push_back(ray);
  }
  for (std::size_t i = 0; i < view_count; ++i) {
    const Vec3d eye = space * Vec3d(number(), number(), number()), target = space * Vec3d(number(), number(), number());
    field->cameras.push_back(Camera::looking_at(eye, target, {0, 1, 0}, 30, 4, 3));
  }
  field->hit.assign(ray_count, std::vector<bool>(node_count));
  field->seen.assign(view_count, std::vector<bool>(node_count));
  std::vector<Hit<float>> hits(ray_count);
  for (NodeId node = 1; node <= node_count; ++node) {
    const Placement placement(field->live.world(node).matrix(), 0);
    std::vector<Vec3f> positions;
    for (const Vec3f& p : mesh->positions()) positions.push_back(placement.point(p));
    field->placed.push_back(std::make_shared<const TriangleMesh>(std::move(positions), mesh->triangles()));
    const TriangleMesh& placed = *field->placed.back();
    make_tracer("box-tree", field->placed.back())->closest_hits(field->rays, hits);
    for (std::size_t i = 0; i < ray_count; ++i) field->hit[i][node - 1] = hits[i].is_hit();
    for (std::size_t i = 0; i < view_count; ++i) {
      for (std::uint32_t t = 0; t < placed.size() && !field->seen[i][node - 1]; ++t) {
        field->seen[i][node - 1] = is_seen(placed[t], field->cameras[i]);
      }
    }
  }
  return field;
}

struct Tally {
  double met = 0, meant = 0;

  void count(bool is_met, bool is_meant, const std::string& kind, const std::string& where) {
    met += is_met;
    meant += is_meant;
    if (is_met || !is_meant) return;
    throw WrongHits(kind + " is wrong, so no times are shown: " + where + ": expected bounds that are met, found none");
  }
  double in_vain() const { return met > 0 ? 100 * (met - meant) / met : 0; }
};

template <class V>
void add_kind(const std::shared_ptr<Field>& field, bool is_spoiled, std::vector<GraphContender>& rays,
              std::vector<GraphContender>& views) {
  const std::string kind(name_of(kind_of<V>));
  const auto bounds = std::make_shared<std::vector<V>>();
  double volume = 0;
  for (NodeId node = 1; node <= node_count; ++node) {
    bounds->push_back(field->live.own_bounds<V>(node));
    volume += sightline::volume_of(bounds->back()) / (field->thing_volume * double(node_count));
  }
  Tally by_rays, by_views;
  for (std::size_t i = 0; i < ray_count; ++i) {
    const VolumeRay ray(field->rays[i]);
    for (std::size_t k = 0; k < node_count; ++k) {
      const bool is_met = ray.may_meet((*bounds)[k]);
      by_rays.count(is_met && !(is_spoiled && field->hit[i][k]), field->hit[i][k], kind,
                    field->name + ", ray " + std::to_string(i) + ", node " + std::to_string(k + 1));
    }
  }
  for (std::size_t i = 0; i < view_count; ++i) {
    const ViewFrustum view(field->cameras[i]);
    for (std::size_t k = 0; k < node_count; ++k) {
      by_views.count(view.may_see((*bounds)[k]), field->seen[i][k], kind,
                     field->name + ", camera " + std::to_string(i) + ", node " + std::to_string(k + 1));
    }
  }
  const auto ready_rays =
      std::make_shared<std::vector<VolumeRay>>(field->rays.begin(), field->rays.begin() + timed_rays);
  rays.push_back({"rays",
                  field->name,
                  kind,
                  [bounds, ready_rays] {
                    std::size_t met = 0;
                    for (const VolumeRay& ray : *ready_rays) {
                      for (const V& v : *bounds) met += ray.may_meet(v);
                    }
                    use(met);
                  },
                  double(timed_rays * node_count),
                  {{"volume", volume}, {"met", by_rays.met}, {"hit", by_rays.meant}, {"in vain", by_rays.in_vain()}}});
  const auto ready_views = std::make_shared<std::vector<ViewFrustum>>(field->cameras.begin(), field->cameras.end());
  views.push_back(
      {"views",
       field->name,
       kind,
       [bounds, ready_views] {
         std::size_t met = 0;
         for (const ViewFrustum& view : *ready_views) {
           for (const V& v : *bounds) met += view.may_see(v);
         }
         use(met);
       },
       double(view_count * node_count),
       {{"volume", volume}, {"met", by_views.met}, {"seen", by_views.meant}, {"in vain", by_views.in_vain()}}});
}

}  // namespace

std::vector<GraphContender> kind_contenders(const GraphPlan& plan) {
  std::vector<GraphContender> rays, views;
  const std::pair<const char*, Mesh> things[]{{"balls", ball(16, 10)},
                                              {"cubes", box(Vec3f(1))},
                                              {"sticks", box({0.1f, 0.1f, 4})},
                                              {"teapots", load_scene("teapot:2", "")}};
  for (const auto& [name, mesh] : things) {
    const auto field = make_field(name, mesh);
    add_kind<Aabb>(field, plan.is_spoiled, rays, views);
    add_kind<Sphere>(field, false, rays, views);
    add_kind<Cylinder>(field, false, rays, views);
  }
  rays.insert(rays.end(), std::make_move_iterator(views.begin()), std::make_move_iterator(views.end()));
  return rays;
}

}  // namespace sightline::bench
