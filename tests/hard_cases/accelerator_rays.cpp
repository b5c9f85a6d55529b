/// Rays that are far away, or no rays at all.

#include "sightline/math/volumes.h"
#include "tests/hard_cases/accelerator_parts.h"
#include "tests/hard_cases/triangle_parts.h"

namespace sightline::hard {
namespace {

// ---- bsphere-far

/// As one writes it first: the discriminant of |o + t d|^2 = 1, in float.
bool meets_unit_sphere(const Ray<float>& ray) {
  const float a = glm::dot(ray.direction, ray.direction), b = glm::dot(ray.origin, ray.direction),
              c = glm::dot(ray.origin, ray.origin) - 1;
  return b * b - a * c >= 0;
}

void run_sphere_far(Trial& trial) {
  const TracedMesh traced(uv_sphere(10, 16, Vec3d(0), 1));
  Random random(111);
  std::vector<Ray<float>> rays;
  for (std::uint64_t i = 0; i < trial.count(2000); ++i) {
    const Vec3d from = 4100.0 * glm::normalize(point_in_cube(random));
    // Near the outline, within it and beyond.
    const Vec3d across = glm::normalize(glm::cross(from, point_in_cube(random)));
    rays.push_back(ray_between(from, (0.9 + 0.1 * random.uniform_double()) * across));
  }
  const MeshQuestion question(traced.mesh(), std::move(rays));
  question.ask(trial, traced);
  Tally& naive = trial.naive("bounding sphere by its discriminant in float");
  for (std::size_t i = 0; i < question.rays().size(); ++i) {
    if (question.truth(i).empty()) continue;
    naive.decide(meets_unit_sphere(question.rays()[i]), [&] {
      return Example{text_of_ray(to_double(question.rays()[i])) + ", sphere of radius 1 around (0, 0, 0)",
                     "kept: a triangle within is hit at " + text_of_number(question.truth(i)[0].t), "culled"};
    });
  }
}

// ---- nan-inf-ray

template <class T>
void judge_broken(Trial& trial, const Tracer& tracer, const Ray<T>& ray, Level level) {
  Hit<T> hit, streamed;
  std::uint8_t any = 1;
  TraversalStats stats;
  const std::span<const Ray<T>> one(&ray, 1);
  tracer.closest_hits(one, std::span(&hit, 1), stats, level);
  tracer.stream_closest_hits(one, std::span(&streamed, 1), level);
  tracer.any_hits(one, std::span(&any, 1), level);
  const bool is_bounded = stats.nodes <= 1 && stats.leaves == 0;
  const bool is_miss = !hit.is_hit() && !streamed.is_hit() && any == 0 && tracer.all_hits(ray).empty();
  trial.of(tracer.name(), level).decide(is_miss && is_bounded, [&] {
    return Example{text_of_ray(to_double(ray)), "a miss at once",
                   std::string(is_miss ? "a miss" : "a hit") + " after " + std::to_string(stats.nodes) + " nodes and " +
                       std::to_string(stats.leaves) + " leaves"};
  });
}

/// Boxes that a ray visits whose test keeps what it cannot compare.
std::size_t boxes_kept(const TriangleMesh& mesh, const Ray<float>& ray) {
  std::size_t kept = 0;
  for (std::uint32_t id = 0; id < mesh.size(); ++id) {
    const Aabb box = mesh.bounds(id);
    float lo = 0, hi = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
      const float a = (box.lo[axis] - ray.origin[axis]) / ray.direction[axis],
                  b = (box.hi[axis] - ray.origin[axis]) / ray.direction[axis];
      lo = std::max(lo, std::min(a, b)), hi = std::min(hi, std::max(a, b));
    }
    kept += !(lo > hi);
  }
  return kept;
}

void run_nan_inf(Trial& trial) {
  const TracedMesh traced(laws::soup(static_cast<int>(trial.count(2000)), 0.2f, 112));
  for (const auto& tracer : traced.tracers()) {
    for (const Ray<float>& ray : laws::broken_rays<float>()) {
      judge_broken(trial, *tracer, ray, Level::fast);
      judge_broken(trial, *tracer, ray, Level::watertight);
    }
    for (const Ray<double>& ray : laws::broken_rays<double>()) {
      judge_broken(trial, *tracer, ray, Level::precise);
      judge_broken(trial, *tracer, ray, Level::exact);
    }
  }
  Tally& naive = trial.naive("slabs that keep NaN");
  for (const Ray<float>& ray : laws::broken_rays<float>()) {
    const std::size_t kept = boxes_kept(traced.mesh(), ray);
    naive.decide(kept <= 1, [&] {
      return Example{text_of_ray(to_double(ray)), "a miss at once", std::to_string(kept) + " boxes visited"};
    });
  }
}

// ---- Drawings

Sketch draw_sphere_far() {
  Sketch sketch{"A cluster in its bounding sphere, seen from 4100 radii away (drawn 5).", {}};
  return sketch.circle({0, 0}, 1, Role::aid)
      .polygon({{-0.7, 0.7}, {0.3, 0.93}, {0.5, 0.4}})
      .line({-5, 0.3}, {3, 1}, Role::ray)
      .dot({-0.12, 0.73})
      .label({-4.8, 1.4}, "true: hit")
      .label({-4.8, -1}, "b^2 and a c agree in all 24 bits: the difference is negative, culled", Role::naive);
}
Sketch draw_nan() {
  Sketch sketch{"A ray whose direction has a NaN goes nowhere. Each box is asked, and none can refuse it.", {}};
  for (int i = 0; i < 4; ++i) {
    sketch.rectangle({1.5 * i, 0.3 * i}, {1.5 * i + 1, 0.3 * i + 1}, Role::naive);
  }
  return sketch.dot({-1.5, 0.5}, Role::aid)
      .line({-1.5, 0.5}, {-0.6, 0.7}, Role::ray)
      .label({-1.5, -0.5}, "true: not a ray, a miss before the first node")
      .label({1, 2.2}, "NaN > NaN is false, so every box is kept", Role::naive);
}

}  // namespace

HardCase bounding_sphere_far() {
  return {.id = "bsphere-far",
          .group = "accelerator",
          .inputs = "a mesh in the unit sphere, 2000 rays of float from 4100 away, near its outline",
          .expected = "the nearest hit; no bounding volume culls it",
          .why =
              "The discriminant is the difference of two numbers of the size of the distance squared, 1.7e7: all that "
              "float leaves of it is noise of the size of the radius squared.",
          .oracle = Oracle::rationals,
          .run = run_sphere_far,
          .draw = draw_sphere_far};
}
HardCase nan_inf_ray() {
  return {
      .id = "nan-inf-ray",
      .group = "accelerator",
      .inputs = "rays with NaN or an infinity in each place, without a direction, with an empty range; 2000 triangles",
      .expected = "a miss, before any leaf and after at most one node",
      .why =
          "Slab tests are written so that NaN keeps a box, as rays in faces of boxes need it. A ray that is NaN all "
          "over then keeps all boxes, and one bad pixel takes as long as brute force.",
      .oracle = Oracle::brute_force,
      .reference = "embree, verify.cpp: NaNTest, InfTest",
      .is_policy = true,
      .run = run_nan_inf,
      .draw = draw_nan};
}

}  // namespace sightline::hard
