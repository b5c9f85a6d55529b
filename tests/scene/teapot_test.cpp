#include "sightline/scene/teapot.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace sightline {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

TEST(Teapot, HasTheCountsThatItPromises) {
  for (const std::uint32_t n : {1u, 2u, 3u, 7u, 16u})
    EXPECT_EQ(make_teapot(static_cast<int>(n)).size(), 64 * n * n - 8 * n);
}

/// Newell's figures: the knob's top is 3.15 high, belly and handle reach 2 and 3 from the axis.
TEST(Teapot, HasItsSize) {
  const Aabb bounds = make_teapot(16).bounds();
  EXPECT_EQ(bounds.lo, Vec3f(-3, 0, -2));
  EXPECT_EQ(bounds.hi.y, 3.15f);
  EXPECT_EQ(bounds.hi.z, 2);
  EXPECT_NEAR(bounds.hi.x, 3.434f, 0.001f);
}

TEST(Teapot, HasNoTriangleWithTwoEqualCornersAndNoEqualVertices) {
  const TriangleMesh mesh = make_teapot(9);
  const auto less = [](const Vec3f& a, const Vec3f& b) {
    return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
  };
  const std::set<Vec3f, decltype(less)> different(mesh.positions().begin(), mesh.positions().end(), less);
  EXPECT_EQ(different.size(), mesh.positions().size());
  for (const auto& [a, b, c] : mesh.triangles()) EXPECT_TRUE(a != b && b != c && c != a);
}

/// No edge is used twice in one direction, so all neighbours agree about the outside; the only open borders are the
/// rim, the lid's border, both ends of the handle and of the spout: circles of 4 and of 2 patches.
TEST(Teapot, IsASurfaceWithSixBorders) {
  const std::uint32_t n = 8;
  const TriangleMesh mesh = make_teapot(n);
  std::map<Edge, int> uses;
  for (const auto& [a, b, c] : mesh.triangles()) {
    for (const Edge& edge : {Edge(a, b), Edge(b, c), Edge(c, a)}) ++uses[edge];
  }
  std::size_t open = 0;
  for (const auto& [edge, count] : uses) {
    EXPECT_EQ(count, 1);
    open += !uses.contains({edge.second, edge.first});
  }
  EXPECT_EQ(open, (4 + 4 + 2 + 2 + 2 + 2) * n);
}

TEST(Teapot, FacesOutward) {
  const TriangleMesh mesh = make_teapot(8);
  double volume = 0;
  for (std::uint32_t i = 0; i < mesh.size(); ++i) {
    volume += glm::dot(Vec3d(mesh[i].a), glm::cross(Vec3d(mesh[i].b), Vec3d(mesh[i].c))) / 6;
  }
  EXPECT_GT(volume, 25);  // of which body and lid make 24.4, handle and spout 1.3
}

}  // namespace
}  // namespace sightline
