#include "sightline/scene/staged.h"

#include <array>
#include <numbers>

#include "sightline/scene/teapot.h"
#include "sightline/shape/mesh_builder.h"

namespace sightline {

TriangleMesh make_stadium(int segments) {
  MeshBuilder builder;
  builder.mesh(make_teapot(segments));
  // From the middle of the field to the rim: radius and height of octagons.
  constexpr std::array<std::array<float, 2>, 6> profile = {
      {{0, 0}, {600, 0}, {620, 15}, {800, 120}, {820, 120}, {1000, 280}}};
  constexpr auto diagonal = static_cast<float>(1 / std::numbers::sqrt2);
  constexpr std::array<std::array<float, 2>, 9> octagon = {{{1, 0},
                                                            {diagonal, diagonal},
                                                            {0, 1},
                                                            {-diagonal, diagonal},
                                                            {-1, 0},
                                                            {-diagonal, -diagonal},
                                                            {0, -1},
                                                            {diagonal, -diagonal},
                                                            {1, 0}}};
  const auto point = [&](std::size_t ring, std::size_t side) {
    return Vec3f(profile[ring][0] * octagon[side][0], profile[ring][1], profile[ring][0] * octagon[side][1]);
  };
  for (std::size_t side = 0; side < 8; ++side) {
    builder.triangle(point(0, 0), point(1, side + 1), point(1, side));
    for (std::size_t ring = 1; ring + 1 < profile.size(); ++ring) {
      builder.quad(point(ring, side), point(ring, side + 1), point(ring + 1, side + 1), point(ring + 1, side));
    }
  }
  return builder.take();
}

TriangleMesh make_room(int segments) {
  MeshBuilder builder;
  builder.box({-8, 0, -8}, {8, 8, 8}, true);
  builder.box({-3, 1.75f, -2}, {3, 2, 2});  // the table's top, and its legs
  for (const float x : {-2.75f, 2.25f}) {
    for (const float z : {-1.75f, 1.25f}) builder.box({x, 0, z}, {x + 0.5f, 1.75f, z + 0.5f});
  }
  builder.mesh(make_teapot(segments), 0.5f, {0, 2, 0});
  builder.box({-7, 0, -7}, {-4, 5, -5});  // a cupboard
  builder.box({4, 0, -6}, {6, 1.5f, -4});
  builder.box({4.5f, 1.5f, -5.5f}, {5.5f, 2.5f, -4.5f});
  return builder.take();
}

}  // namespace sightline
