#include "viz/walk/walk_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_set>

namespace sightline::viz {
namespace {

std::unordered_set<std::uint32_t> cells_made(const Tracer& tracer) {
  std::unordered_set<std::uint32_t> made;
  tracer.for_each_cell([&](const Cell& cell) { made.insert(cell.node); });
  return made;
}

}  // namespace

WalkModel model_of(const Tracer& tracer, const Ray<float>& ray) {
  WalkModel model;
  model.tracer = &tracer;
  const auto before = tracer.is_lazy() ? cells_made(tracer) : std::unordered_set<std::uint32_t>();
  model.walk = record_walk(tracer, ray);
  model.candidates = candidates_below(tracer, model.walk);
  model.cells_before = tracer.is_lazy() ? before.size() : model.walk.all_cells;
  for (const WalkCell& cell : model.walk.cells) {
    model.is_new.push_back(tracer.is_lazy() && !before.contains(cell.cell.node));
  }
  return model;
}

WalkModel walk_again(const WalkModel& model, const Ray<float>& ray) {
  WalkModel again = model_of(*model.tracer, ray);
  again.structure = model.structure;
  again.scene = model.scene;
  again.command = model.command;
  if (model.tracer->is_lazy()) again.command += " --earlier=" + text_of(model.walk.ray);
  return again;
}

Stretch shown_stretch(const Aabb& bounds, const Ray<float>& ray) {
  const Vec3d origin(ray.origin), direction(ray.direction);
  const double margin = 0.22 * glm::length(Vec3d(bounds.extent())) / glm::length(direction);
  const Vec3d middle = 0.5 * (Vec3d(bounds.lo) + Vec3d(bounds.hi));
  const double nearest = glm::dot(middle - origin, direction) / glm::dot(direction, direction);
  double enter = -1e300, leave = 1e300;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) continue;
    const double a = (double(bounds.lo[axis]) - origin[axis]) / direction[axis];
    const double b = (double(bounds.hi[axis]) - origin[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (!(enter <= leave)) enter = leave = nearest;  // past the mesh
  const double from = std::max(double(ray.t_min), enter - margin);
  return {from, std::max(from + margin, leave + margin)};
}

Ray<float> usual_ray(const Aabb& bounds) {
  const Vec3f size = bounds.extent();
  const Vec3f from = bounds.lo + Vec3f(-0.12f, 0.86f, 1.0f) * size, to = bounds.lo + Vec3f(0.8f, 0.42f, 0.4f) * size;
  return {from, to - from};
}

/// Around the middle, ring by ring; in the end toward triangles themselves, of which any is the first met at least
/// once.
Ray<float> usual_ray(const Tracer& tracer) {
  const TriangleMesh& mesh = tracer.mesh();
  const Ray<float> middle = usual_ray(mesh.bounds());
  if (mesh.size() == 0) return middle;
  const std::shared_ptr<const TriangleMesh> borrowed(std::shared_ptr<void>(), &mesh);
  const auto other = tracer.is_lazy() ? make_tracer("box-tree", borrowed) : nullptr;
  const auto is_hit = [&](const Ray<float>& ray) {
    Hit<float> hit;
    (other ? *other : tracer).closest_hits(std::span(&ray, 1), std::span(&hit, 1));
    return hit.is_hit();
  };
  if (is_hit(middle)) return middle;
  const Vec3d along(middle.direction), extent(mesh.bounds().extent());
  const Vec3d right = glm::normalize(Vec3d(-along.z, 0, along.x)), up = glm::normalize(glm::cross(right, along));
  constexpr int rings = 16, spokes = 24;
  for (int ring = 1; ring <= rings; ++ring) {
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const double angle = 2 * std::numbers::pi * spoke / spokes, radius = 0.5 * glm::length(extent) * ring / rings;
      const Ray<float> ray{middle.origin, Vec3f(along + radius * (std::cos(angle) * right + std::sin(angle) * up))};
      if (is_hit(ray)) return ray;
    }
  }
  constexpr std::size_t most = 1000;
  for (std::size_t i = 0; i < mesh.size(); i += 1 + mesh.size() / most) {
    const auto [a, b, c] = mesh[static_cast<std::uint32_t>(i)];
    const Ray<float> ray{middle.origin, Vec3f((Vec3d(a) + Vec3d(b) + Vec3d(c)) / 3.0 - Vec3d(middle.origin))};
    if (is_valid(ray) && is_hit(ray)) return ray;
  }
  return middle;
}

}  // namespace sightline::viz
