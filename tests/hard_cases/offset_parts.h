#pragma once
/// Rays that leave surfaces: the renderer's origins, and those of naive code.

#include <bit>
#include <memory>
#include <utility>
#include <vector>

#include "sightline/render/surfaces.h"
#include "tests/hard_cases/exact_side.h"
#include "tests/hard_cases/triangle_parts.h"

namespace sightline::hard {

HardCase offset_none();
HardCase offset_fixed();
HardCase offset_leak();
HardCase offset_absorbed();
HardCase offset_shadow_end();

/// Of scenes, powers of ten.
inline constexpr int least_scale = -4, largest_scale = 7;

inline double random_scale(Random& random) {
  return std::pow(10.0, least_scale + (largest_scale - least_scale) * random.uniform_double());
}

/// A scene of one shape in the world's coordinates, as the renderer has it.
class OneShape {
 public:
  OneShape(std::variant<MeshGeometry, SolidTree> shape, Level level) {
    scene_.geometries.push_back({"shape", std::move(shape)});
    const NodeId node = scene_.graph.add(root_node, "shape", {});
    scene_.graph.set_geometry(node, 0);
    WorldSettings settings;
    settings.level = level;
    settings.threads = 1;
    world_ = std::make_unique<TraceWorld>(scene_, settings);
    surfaces_ = std::make_unique<Surfaces>(scene_, *world_);
  }
  explicit OneShape(TriangleMesh mesh)
      : OneShape(MeshGeometry{std::make_shared<const TriangleMesh>(std::move(mesh)), {}, {}}, Level::watertight) {}

  WorldHit hit(const Ray<double>& ray) const {
    WorldHit hit;
    world_->closest_hits(std::span(&ray, 1), std::span(&hit, 1));
    return hit;
  }
  bool is_shadowed(const Ray<double>& ray) const {
    std::uint8_t is_hit = 0;
    world_->any_hits(std::span(&ray, 1), std::span(&is_hit, 1));
    return is_hit != 0;
  }
  SurfacePoint locate(const Ray<double>& ray, const WorldHit& hit) const { return surfaces_->locate(ray, hit); }

 private:
  Scene scene_;
  std::unique_ptr<TraceWorld> world_;
  std::unique_ptr<Surfaces> surfaces_;
};

/// The origin of a ray that goes on from there, on the side that `ray` came from.
inline Vec3d origin_of_next(const SurfacePoint& at, const Ray<double>& ray) {
  return at.beyond(glm::dot(at.outside, ray.direction) > 0 ? -at.outside : at.outside);
}

/// A unit normal in float on the side that the ray came from.
inline Vec3f float_normal(const Triangle& triangle, const Ray<float>& ray) {
  const Vec3f normal = glm::normalize(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
  return glm::dot(normal, ray.direction) > 0 ? -normal : normal;
}

/// Waechter and Binder, "A Fast and Robust Method for Avoiding Self-Intersection", 2019: steps in the last places.
inline Vec3f integer_offset(const Vec3f& p, const Vec3f& normal) {
  Vec3f moved;
  for (int axis = 0; axis < 3; ++axis) {
    const int steps = static_cast<int>(256 * normal[axis]);
    const float stepped = std::bit_cast<float>(std::bit_cast<int>(p[axis]) + (p[axis] < 0 ? -steps : steps));
    moved[axis] = std::fabs(p[axis]) < 1 / 32.f ? p[axis] + 1 / 65536.f * normal[axis] : stepped;
  }
  return moved;
}

}  // namespace sightline::hard
