/// Rims of cylinders, and apexes of cones.

#include "tests/hard_cases/families/any_points.h"
#include "tests/hard_cases/families/ask_solid.h"
#include "tests/hard_cases/families/families.h"

namespace sightline::hard {
namespace {

/// Crossings of an upright cylinder, radius 1 and from z = -1 to 1, each face by itself in float: the side where z is
/// between the caps, the caps where the point is within the rim.
int cylinder_count(const Ray<float>& ray) {
  const Vec3f &o = ray.origin, &d = ray.direction;
  int count = 0;
  const float a = d.x * d.x + d.y * d.y, b = o.x * d.x + o.y * d.y, c = o.x * o.x + o.y * o.y - 1;
  const float discriminant = b * b - a * c;
  if (discriminant > 0) {
    const float root = std::sqrt(discriminant);
    for (const float t : {(-b - root) / a, (-b + root) / a}) count += std::fabs(o.z + t * d.z) <= 1;
  }
  for (const float z : {-1.0f, 1.0f}) {
    const float t = (z - o.z) / d.z, x = o.x + t * d.x, y = o.y + t * d.y;
    count += x * x + y * y <= 1;
  }
  return count;
}

/// Of the upright cone from the apex (0, 0, 1) to the rim of radius 1 at z = 0, likewise.
int cone_count(const Ray<float>& ray) {
  const Vec3f &o = ray.origin, &d = ray.direction;
  const float h = 1 - o.z;
  const float a = d.x * d.x + d.y * d.y - d.z * d.z, b = o.x * d.x + o.y * d.y + h * d.z,
              c = o.x * o.x + o.y * o.y - h * h;
  const float discriminant = b * b - a * c;
  int count = 0;
  if (discriminant > 0) {
    const float root = std::sqrt(discriminant);
    for (const float t : {(-b - root) / a, (-b + root) / a}) {
      const float z = o.z + t * d.z;
      count += z >= 0 && z <= 1;
    }
  }
  const float t = -o.z / d.z, x = o.x + t * d.x, y = o.y + t * d.y;
  return count + (x * x + y * y <= 1);
}

using Count = int (*)(const Ray<float>&);

void ask(const SolidTree& tree, Count naive, const std::vector<Ray<double>>& rays, Trial& trial) {
  std::vector<AskedRay> questions;
  for (const Ray<double>& ray : rays) questions.push_back({ray, true_spans(tree, ray)});
  ask_lists(tree, questions, trial);
  ask_structures(tree, questions, trial);
  for (const auto& [ray, truth] : questions) {
    const int count = naive(to_float(ray));
    trial.naive("face by face in float")
        .decide(static_cast<std::size_t>(count) == truth.ends.size(), [&, &ray = ray, &truth = truth] {
          return Example{text_of(ray), std::to_string(truth.ends.size()) + " boundaries",
                         std::to_string(count) + " boundaries"};
        });
  }
}

void ask_rims_and_apexes(int difficulty, std::uint64_t count, std::uint64_t seed, Trial& trial) {
  Random random(seed);
  std::vector<Ray<double>> at_rim, at_apex;
  for (std::uint64_t i = 0; i < (count + 1) / 2; ++i) {
    const double aside = std::ldexp(i % 2 == 0 ? 1.0 : -1.0, -difficulty), angle = 6.25 * random.uniform_double();
    const Vec3d outward(std::cos(angle), std::sin(angle), 0);
    const Vec3d above = Vec3d(0, 0, 2.5) + any_point(random), beside = 3.0 * outward + any_point(random);
    at_rim.push_back({above, (1 + aside) * outward + Vec3d(0, 0, 1) - above});
    at_apex.push_back({beside, Vec3d(0, 0, 1 + aside) - beside});
  }
  ask(solid::Cylinder{}, cylinder_count, at_rim, trial);
  ask(solid::Cone{}, cone_count, at_apex, trial);
}

}  // namespace

Family rims_and_apexes() {
  return {"rims",
          "Rays past the rim of a cylinder and the apex of a cone, within or aside: where they enter and leave.",
          "rays pass 2^-k beside the rim, or above or below the apex",
          "k: 2^-k beside rim and apex",
          1,
          50,
          Oracle::rationals,
          ask_rims_and_apexes};
}

}  // namespace sightline::hard
