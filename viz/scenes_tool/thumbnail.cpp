#include "viz/scenes_tool/thumbnail.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sightline/csg/evaluator.h"
#include "sightline/query/tracer.h"
#include "sightline/scene/camera.h"
#include "sightline/scene/flatten.h"
#include "viz/scenes_tool/surface_color.h"

namespace sightline::scenes_tool {
namespace {

struct PlacedSolid {
  Solid solid;
  Transform to_world;
  std::uint32_t material;
};

Vec3d unit(const Vec3d& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : Vec3d(0, 1, 0);
}

class Painter {
 public:
  Painter(const Scene& scene, int width, int height) : scene_(scene), colors_(scene), flat_(instances_of(scene)) {
    std::uint64_t first = 0;
    for (std::uint32_t i = 0; i < flat_.instances.size(); ++i) {
      firsts_.push_back(first);
      first += flat_.instances.mesh_of(i).size();
    }
    Aabb bounds = flat_.instances.bounds();
    if (flat_.instances.triangles() > 0) {
      tracer_ = make_tracer("box-tree", std::make_shared<const TriangleMesh>(flat_.instances.flattened()));
    }
    add_solids(bounds);
    if (bounds.is_empty()) bounds = {Vec3f(-1), Vec3f(1)};
    camera_ =
        scene.cameras.empty() ? Camera::facing(bounds, width, height) : camera_of(scene.cameras[0], width, height);
  }

  Image paint() const {
    Image image{camera_.width, camera_.height, 3, {}};
    image.pixels.resize(std::size_t(image.width) * std::size_t(image.height) * 3);
    tbb::parallel_for(0, image.height, [&](int y) {
      for (int x = 0; x < image.width; ++x) {
        const Vec3d light = color_at(x, y);
        const std::size_t pixel =
            3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
        for (std::size_t i = 0; i < 3; ++i) image.pixels[pixel + i] = static_cast<float>(light[static_cast<int>(i)]);
      }
    });
    return image;
  }

 private:
  void add_solids(Aabb& bounds) {
    std::vector<std::uint32_t> materials(scene_.graph.size(), no_item);
    scene_.graph.for_each_shown([&](NodeId node, const Transform& world) {
      const std::uint32_t own = scene_.graph.material(node);
      materials[node] = own != no_item || node == root_node ? own : materials[scene_.graph.parent(node)];
      const std::uint32_t geometry = scene_.graph.geometry(node);
      const auto* tree = geometry == no_item ? nullptr : std::get_if<SolidTree>(&scene_.geometries[geometry].shape);
      if (!tree) return;
      solids_.push_back({Solid(*tree), world, materials[node]});
      if (!solids_.back().solid.is_bounded()) return;
      const Aabb local = solids_.back().solid.bounds();
      for (int corner = 0; corner < 8; ++corner) {
        bounds.extend(Vec3f(world.point({corner & 1 ? local.hi.x : local.lo.x, corner & 2 ? local.hi.y : local.lo.y,
                                         corner & 4 ? local.hi.z : local.lo.z})));
      }
    });
  }

  Camera camera_of(const SceneCamera& camera, int width, int height) const {
    const Transform world = scene_.graph.world(camera.node);
    const Vec3d eye = world.point(Vec3d(0));
    return Camera::looking_at(eye, eye + unit(world.vector({0, 0, -1})), unit(world.vector({0, 1, 0})),
                              camera.field_of_view, width, height);
  }

  struct Sight {
    double t = std::numeric_limits<double>::infinity();
    Vec3d color{0}, normal{0};
  };

  Vec3d color_at(int x, int y) const {
    const Ray<float> ray = camera_.ray(x, y);
    const Ray<double> precise{Vec3d(ray.origin), Vec3d(ray.direction)};
    Sight sight;
    if (tracer_) {
      Hit<float> hit;
      tracer_->closest_hits(std::span(&ray, 1), std::span(&hit, 1));
      if (hit.is_hit()) sight = sight_of(hit);
    }
    for (const PlacedSolid& solid : solids_) look(solid, precise, sight);
    if (sight.t == std::numeric_limits<double>::infinity()) {
      return Vec3d(0.80, 0.85, 0.90) - Vec3d(0.25, 0.24, 0.22) * (double(y) / camera_.height);
    }
    const Vec3d view = unit(precise.direction);
    const Vec3d normal = glm::dot(sight.normal, view) > 0 ? -sight.normal : sight.normal;
    const Vec3d key = unit(-0.6 * unit(camera_.right) + 0.8 * unit(camera_.up) - 0.9 * unit(camera_.forward));
    const double light =
        0.25 + 0.15 * normal.y + 0.55 * std::fmax(0, glm::dot(normal, key)) - 0.1 * glm::dot(normal, view);
    return sight.color * light;
  }

  Sight sight_of(const Hit<float>& hit) const {
    const auto after = std::upper_bound(firsts_.begin(), firsts_.end(), hit.prim_id);
    const auto instance = static_cast<std::uint32_t>(after - firsts_.begin() - 1);
    const auto local = static_cast<std::uint32_t>(hit.prim_id - firsts_[instance]);
    const SceneOrigin& origin = flat_.origins[instance];
    const auto& geometry = std::get<MeshGeometry>(scene_.geometries[scene_.graph.geometry(origin.node)].shape);
    auto [a, b, c] = geometry.mesh->triangles()[local];
    if (flat_.instances.placements()[instance].is_mirroring()) std::swap(b, c);  // as the flattened mesh lists them
    const double u = hit.u, v = hit.v, w = 1 - u - v;
    const auto mixed = [&](const auto& list) { return w * Vec3d(list[a]) + u * Vec3d(list[b]) + v * Vec3d(list[c]); };
    const Vec3d point = mixed(geometry.mesh->positions());
    glm::dvec2 uv(0);
    if (!geometry.uvs.empty()) {
      uv = w * glm::dvec2(geometry.uvs[a]) + u * glm::dvec2(geometry.uvs[b]) + v * glm::dvec2(geometry.uvs[c]);
    }
    const Triangle placed = flat_.instances.triangle(instance, local);
    Vec3d normal = glm::cross(Vec3d(placed.b) - Vec3d(placed.a), Vec3d(placed.c) - Vec3d(placed.a));
    if (!geometry.normals.empty()) {
      const Affine world = flat_.instances.placements()[instance].to_world();
      normal = Transform::of(world).normal(mixed(geometry.normals));
    }
    return {hit.t, colors_.color(origin.material, point, uv), unit(normal)};
  }

  void look(const PlacedSolid& placed, const Ray<double>& ray, Sight& sight) const {
    // The same t along both rays.
    const Affine& back = placed.to_world.inverse();
    const Ray<double> local{back.point(ray.origin), back.vector(ray.direction)};
    NoSolidProbe probe;
    SolidEvaluator<Level::precise> evaluator(placed.solid, local, probe);
    const auto boundary = evaluator.first(0, sight.t);
    if (!boundary || !(boundary->t < sight.t)) return;
    const std::string& name = placed.solid.materials()[placed.solid.primitives()[boundary->primitive].material];
    const Vec3d point = local.at(boundary->t);
    sight.t = boundary->t;
    sight.color = name.empty() ? colors_.color(placed.material, point, glm::dvec2(0)) : colors_.color(name, point);
    sight.normal = unit(placed.to_world.normal(placed.solid.normal(*boundary, local)));
  }

  const Scene& scene_;
  SurfaceColors colors_;
  SceneInstances flat_;
  std::vector<std::uint64_t> firsts_;  ///< Of each instance, its first triangle in the flattened mesh.
  std::unique_ptr<Tracer> tracer_;     ///< Null where there are no triangles.
  std::vector<PlacedSolid> solids_;
  Camera camera_;
};

}  // namespace

Image thumbnail(const Scene& scene, int width, int height) { return Painter(scene, width, height).paint(); }

}  // namespace sightline::scenes_tool
