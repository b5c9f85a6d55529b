#include "labs/check/structure_scene.h"

#include <cmath>

#include "sightline/math/random.h"

namespace sightline::labs {
namespace {

Vec3f point(Random& random, float size) {
  const float x = random.uniform(-size, size), y = random.uniform(-size, size), z = random.uniform(-size, size);
  return {x, y, z};
}

}  // namespace

std::vector<Triangle> budget_triangles() {
  Random random(2026);
  std::vector<Triangle> triangles;
  for (int crowd = 0; crowd < 12; ++crowd) {
    const Vec3f middle = point(random, 8);
    for (int i = 0; i < 250; ++i) {
      const Vec3f at = middle + point(random, 0.8f);
      triangles.push_back({at, at + point(random, 0.12f), at + point(random, 0.12f)});
    }
  }
  for (int i = 0; i < 60; ++i) {
    const Vec3f at = point(random, 8);
    triangles.push_back({at, at + point(random, 3), at + point(random, 3)});
  }
  return triangles;
}

std::vector<Ray<float>> budget_rays() {
  Random random(7);
  std::vector<Ray<float>> rays;
  for (int i = 0; i < 2000; ++i) {
    const Vec3f from = point(random, 14), to = point(random, 8);
    rays.push_back({from, to - from});
  }
  return rays;
}

}  // namespace sightline::labs
