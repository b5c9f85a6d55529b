#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sightline/math/random.h"
#include "tests/csg/evaluate.h"

namespace sightline {
namespace {

constexpr double step = 0x1p-20;  ///< Between neighbouring rays, in directions of length 1.

/// Some map that neither mirrors nor keeps lengths or angles, back to the shape.
Frame some_frame(Random& random) {
  const auto number = [&] { return 2 * random.uniform_double() - 1; };
  Frame frame;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) frame.rows[i][k] = (i == k ? 1.5 : 0) + 0.8 * number();
    frame.rows[i][3] = 0.2 * number();
  }
  return frame;
}

/// The first boundaries of a ray and of two beside it.
struct Neighbours {
  std::vector<Boundary> boundaries;
  std::vector<Vec3d> points;
};

Neighbours neighbours_of(const Solid& solid, const Ray<double>& ray) {
  Neighbours found;
  for (const Vec3d& aside : {Vec3d(0), step * Vec3d(1, -0.5, 0.25), step * Vec3d(-0.25, 1, 0.5)}) {
    const Ray<double> beside{ray.origin, ray.direction + aside};
    const auto boundary = first_of(solid, beside, 0, 100, Level::precise);
    if (!boundary) break;
    found.boundaries.push_back(*boundary);
    found.points.push_back(beside.at(boundary->t));
  }
  return found;
}

/// A normal is at right angles to the way to neighbouring points, up to what the surface bends on that way, and against
/// the ray that comes from outside.
TEST(SolidNormal, IsAcrossTheSurfaceInAnyFrame) {
  Random random(1);
  const std::vector<SolidTree> shapes{
      solid::Sphere{}, solid::Box{}, solid::Cylinder{}, solid::Cone{}, solid::Torus{{0, 0, 0}, {0, 0, 1}, 1, 0.25},
      solid::Quadric{}};
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    SolidTree tree = shapes[static_cast<std::size_t>(i) % shapes.size()];
    tree.frame = some_frame(random);
    const Solid solid(tree);
    const auto number = [&] { return 2 * random.uniform_double() - 1; };
    const Vec3d from = 8.0 * glm::normalize(Vec3d(number(), number(), number())), to(number(), number(), number());
    const Ray<double> ray{from, glm::normalize(to - from)};
    const auto [boundaries, points] = neighbours_of(solid, ray);
    if (points.size() < 3 || boundaries[0].face != boundaries[1].face || boundaries[0].face != boundaries[2].face) {
      continue;
    }
    const Vec3d normal = solid.normal(boundaries[0], ray);
    const double slant = -glm::dot(normal, ray.direction);
    ASSERT_NEAR(glm::length(normal), 1, 0x1p-50);
    ASSERT_GT(slant, 0);
    for (const std::size_t k : {1, 2}) {
      const Vec3d way = points[k] - points[0];
      if (slant < 0.1 || glm::length(way) > 0x1p-12) continue;
      ++compared;
      ASSERT_LT(std::fabs(glm::dot(normal, way)), 0x1p-8 * glm::length(way)) << "shape " << i % shapes.size();
    }
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace sightline
