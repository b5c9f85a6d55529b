#pragma once
/// Scenes of a few triangles and balls in nested places, for tests.

#include <cmath>
#include <memory>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/scene/scene.h"

namespace sightline {

inline Transform random_place(Random& random) {
  const auto number = [&] { return 2 * random.uniform_double() - 1; };
  Transform place = Transform::translation({3 * number(), 3 * number(), 3 * number()}) *
                    Transform::rotation(Vec3d(number(), number(), 1), 360 * number());
  if (random.below(4) == 0) place = place * Transform::scaling({-1.5, 0.5, 1});
  return place;
}

inline MeshGeometry random_mesh(Random& random) {
  const auto number = [&] { return 2 * random.uniform() - 1; };
  std::vector<Vec3f> positions(3 * (1 + random.below(4)));
  for (Vec3f& p : positions) p = {number(), number(), 0.2f * number()};
  std::vector<TriangleMesh::Corners> triangles;
  for (std::uint32_t i = 0; i < positions.size(); i += 3) triangles.push_back({i, i + 1, i + 2});
  return {std::make_shared<const TriangleMesh>(std::move(positions), std::move(triangles)), {}, {}};
}

/// The last geometry is a ball of radius 0.5 around (0.25, 0, 0); others are meshes.
inline Scene random_scene(std::uint64_t seed, std::uint32_t nodes) {
  Random random(seed);
  Scene scene;
  for (int i = 0; i < 4; ++i) scene.geometries.push_back({"mesh", random_mesh(random)});
  scene.geometries.push_back({"ball", SolidTree(solid::Sphere{{0.25, 0, 0}, 0.5})});
  for (std::uint32_t i = 0; i < nodes; ++i) {
    const NodeId node = scene.graph.add(random.below(scene.graph.size()), "", random_place(random));
    if (random.below(3) > 0) scene.graph.set_geometry(node, random.below(5));
  }
  return scene;
}

}  // namespace sightline
