/// Rays along the silhouette of a box.

#include <algorithm>

#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/ask_solid.h"
#include "tests/hard_cases/families/families.h"

namespace sightline::hard {
namespace {

/// Slabs with reciprocals, in float (Kay and Kajiya, "Ray Tracing Complex Scenes", 1986).
bool slabs_are_met(const solid::Box& box, const Ray<float>& ray) {
  float enter = -std::numeric_limits<float>::infinity(), leave = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const float inverse = 1 / ray.direction[axis];
    const float one = (static_cast<float>(box.lo[axis]) - ray.origin[axis]) * inverse,
                other = (static_cast<float>(box.hi[axis]) - ray.origin[axis]) * inverse;
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
  }
  return enter < leave;
}

void ask_silhouettes(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  const solid::Box box{{-0.3, -0.7, -0.45}, {0.6, 0.2, 0.9}};
  std::vector<AskedRay> questions;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vec3d eye(2 + 2 * random.uniform_double(), 2 + 2 * random.uniform_double(), 3 * any_point(random).x);
    // From there the edge of the highest x and the lowest y is part of the silhouette.
    const double along = 0.1 + 0.8 * random.uniform_double(), aside = std::ldexp(i % 2 == 0 ? 1.0 : -1.0, -difficulty);
    const Vec3d target(box.hi.x + aside, box.lo.y, box.lo.z + along * (box.hi.z - box.lo.z));
    const Ray<double> ray{eye, target - eye};
    questions.push_back({ray, true_spans(box, ray)});
  }
  ask_lists(box, questions, trial);
  ask_structures(box, questions, trial);
  for (const auto& [ray, truth] : questions) {
    const bool is_met = slabs_are_met(box, to_float(ray)), expected = !truth.ends.empty();
    trial.naive("slabs with reciprocals in float").decide(is_met == expected, [&, &ray = ray] {
      return Example{text_of(ray), expected ? "a hit" : "no hit", is_met ? "a hit" : "no hit"};
    });
  }
}

}  // namespace

Family box_silhouettes() {
  return {"silhouettes",
          "Rays past an edge of a box that is part of its silhouette, before it or behind: where they enter and leave.",
          "rays pass 2^-k beside the edge, of a box of size 1",
          "k: 2^-k beside the edge",
          1,
          50,
          Oracle::rationals,
          ask_silhouettes};
}

}  // namespace sightline::hard
