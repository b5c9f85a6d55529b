/// Spheres that rays graze, and spheres far away.

#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/ask_solid.h"
#include "tests/hard_cases/families/families.h"
#include "tests/hard_cases/families/naive.h"

namespace sightline::hard {
namespace {

/// Root counts of the textbook's quadratic, in float: a = d.d, b = 2 q.d, c = q.q - r^2.
void ask_naive(const solid::Sphere& sphere, const std::vector<AskedRay>& questions, Trial& trial) {
  for (const auto& [ray, truth] : questions) {
    const Vec3f q = Vec3f(ray.origin) - Vec3f(sphere.center), d(ray.direction);
    const auto radius = static_cast<float>(sphere.radius);
    const int count = school_root_count(glm::dot(d, d), 2 * glm::dot(q, d), glm::dot(q, q) - radius * radius);
    const std::size_t expected = truth.ends.size();
    trial.naive("school formula in float").decide(static_cast<std::size_t>(count) == expected, [&, &ray = ray] {
      return Example{text_of(ray), std::to_string(expected) + " hits", std::to_string(count) + " hits"};
    });
  }
}

void ask(const solid::Sphere& sphere, const std::vector<Ray<double>>& rays, Trial& trial) {
  std::vector<AskedRay> questions;
  for (const Ray<double>& ray : rays) questions.push_back({ray, true_spans(sphere, ray)});
  ask_lists(sphere, questions, trial);
  ask_structures(sphere, questions, trial);
  ask_naive(sphere, questions, trial);
}

void ask_grazing(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  const solid::Sphere sphere{any_point(random), 1};
  std::vector<Ray<double>> rays;
  for (std::uint64_t i = 0; i < count; ++i) {
    const AnyFrame frame(random);
    const double impact = 1 + std::ldexp(i % 2 == 0 ? -1.0 : 1.0, -difficulty);
    rays.push_back({sphere.center + impact * frame.x - 16.0 * frame.z, frame.z});
  }
  ask(sphere, rays, trial);
}

void ask_far(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  const solid::Sphere sphere{any_point(random), 1};
  std::vector<Ray<double>> rays;
  for (std::uint64_t i = 0; i < count; ++i) {
    const AnyFrame frame(random);
    const Vec3d origin = sphere.center - std::ldexp(1.0, difficulty) * frame.z;
    rays.push_back({origin, sphere.center + 0.5 * frame.x - origin});
  }
  ask(sphere, rays, trial);
}

}  // namespace

Family grazing_spheres() {
  return {"grazing",
          "Rays past a unit sphere from 16 away, inside its silhouette or outside: where they enter and leave.",
          "rays pass the center at 1 -+ 2^-k",
          "k: impact 1 +- 2^-k",
          1,
          50,
          Oracle::rationals,
          ask_grazing};
}

Family far_spheres() {
  return {"far-spheres",
          "Rays through a unit sphere far away, halfway between center and silhouette: where they enter and leave.",
          "rays begin 2^k away",
          "k: distance 2^k",
          1,
          50,
          Oracle::rationals,
          ask_far};
}

}  // namespace sightline::hard
